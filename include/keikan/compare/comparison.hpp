// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "keikan/baseline/method.hpp"
#include "keikan/compare/picture_error.hpp"

namespace keikan::compare {

/// Seconds of one run of a method, from the faces to the picture.
struct Seconds {
    double wall = 0;
    double processor = 0;  ///< of all threads together: what counts on a machine that others use, too
};

struct ComparisonOptions {
    std::vector<baseline::Method> methods;
    int repeat = 3;
    std::uint32_t seed = 1;
    WaterOptions water;                        ///< of kato
    int reference_samples = 512;               ///< of water, Sobol's, in each pixel of the truth
    std::optional<Image<Rgb>> reference = {};  ///< the truth, where it is known already
    int search_to = 4096;                      ///< the largest N of the searches for equal quality; 0: none
    std::function<void(const std::string& doing)> tell = {};
};

/// What was measured of one method.
struct MethodResult {
    baseline::Method method;
    std::vector<Seconds> runs;  ///< interleaved with those of the other methods
    Seconds median;
    PictureError all;
    PictureError conductors;  ///< in the pixels that show a conductor
    std::uint64_t water_samples = 0;
    Image<Rgb> picture;
};

/// One N that a search has tried.
struct Trial {
    int count = 0;
    PictureError conductors;
    Seconds seconds;  ///< one run
    /// The picture was made in conductor pixels only, and the seconds are extrapolated from runs with fewer
    /// samples: time is linear in the number of samples.
    bool extrapolated = false;
};

/// What a search wants in the pixels that show a conductor.
enum class Goal {
    KatoRmse,  ///< an RMSE that is not above kato's
    AllRight,  ///< at most kWrongShare of the pixels off by more than kVisible
};
/// "Nearly all": what was left wrong by the 16,384 samples of the prototype that the target comes from.
inline constexpr double kWrongShare = 0.0003;

/// The smallest N with which a method reaches the quality.
struct EqualQuality {
    baseline::Method::Kind kind = baseline::Method::Kind::MultiScan;
    Goal goal = Goal::KatoRmse;
    std::optional<Trial> reached;  ///< nothing: no N up to search_to does
    Trial last;                    ///< the largest N tried
    double time_ratio = 0;  ///< kato's processor seconds over this method's, at `reached` or else at `last`
};

struct Comparison {
    ImageSize size;
    int threads = 1;
    std::uint64_t faces = 0;
    Image<Rgb> truth;
    std::string truth_is;
    Image<std::uint8_t> conductor_pixels;  ///< 1 where a conductor is seen
    std::uint64_t conductor_pixel_count = 0;
    /// There are conductors; else all pixels take their place in the searches.
    bool has_conductors = false;
    std::vector<MethodResult> methods;
    struct Trials {
        baseline::Method::Kind kind;
        std::vector<Trial> trials;  ///< by rising N
    };
    std::vector<Trials> trials;
    std::vector<EqualQuality> equal_quality;
    bool water = false;
};

/// Renders the scene with every method, in turns, and measures each against the truth.
///
/// The truth has exact areas in every pixel (baseline::exact_everywhere, whose areas keikan-verify proves)
/// and the colour of each visible part at its centroid: the picture that all methods tend to. A method's
/// error is thus that of its areas, and nothing of shading is in it but where a method shades a part
/// elsewhere than at its centroid. Where water is drawn by rays, the truth divides pixels by kato's exact
/// areas and takes reference_samples of the water, other ones than kato's.
///
/// Equal quality is looked for in each kind of method with an N that is among the methods, if kato is, too: N
/// is doubled (samples: 1, 4, 16, ... so that cells stay square) until the goal is met or search_to exceeded;
/// then bisected between the last two, over all N (samples: over squares). The smallest N is what that finds.
///
/// Property: (1) All but the seconds is the same for any number of threads.
Comparison compare_methods(const Scene& scene, const Geometry& geometry, const ComparisonOptions& options);

/// Holds kato (by outline extraction) and catmull to what they promise: areas are exact, so no pixel may be
/// off by more than kVisible. Nothing is asked of a scene with water, nor against a truth that was given.
///
/// Errors: CheckFailure naming the method and its largest error.
void require_exact(const Comparison& comparison);

/// 1 where any part of a conductor is seen, by exact areas.
Image<std::uint8_t> conductor_pixels(const Geometry& geometry, const Camera& camera);

}  // namespace keikan::compare

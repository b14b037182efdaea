// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "coverage_picture.hpp"
#include "crosscheck/certain_hiding.hpp"
#include "crosscheck/compare_pixel.hpp"
#include "crosscheck/face_bins.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scan/scan_band.hpp"

namespace keikan::truth {

/// What was counted on the way. A value is the coverage of one pixel by one matte, or its background.
struct TruthSummary {
    std::uint64_t pixels = 0;
    std::uint64_t polygons = 0;         ///< faces that may be in them, summed
    std::uint64_t unsettled = 0;        ///< pixels in which a certificate left a rounding open
    crosscheck::RungCounts rungs;       ///< `rational`: those, pixels without a certificate, and the sample
    std::uint64_t values = 0;           ///< compared: wherever the exact one or the float path's is not 0
    std::uint64_t differing_codes = 0;  ///< the float path's 16-bit code is not that of the exact coverage
    /// Values whose exact coverage is so near a boundary between two codes that the float path's error bound
    /// does not exclude the other one; and those of them that differ.
    std::uint64_t at_boundary = 0;
    std::uint64_t differing_at_boundary = 0;
    /// Pixels that the scan told twice, never, or with faces that do not exist.
    std::uint64_t form_faults = 0;
    double max_error = 0;      ///< of the float path's coverage by a matte; an upper bound
    double max_sum_error = 0;  ///< of the float path: |all coverages and background - 1|
    struct Place {
        PixelIndex pixel;
        double error = 0;
    };
    std::vector<Place> worst;      ///< by falling error, at most kWorstKept
    std::vector<Place> differing;  ///< the first pixels with a differing code
    static constexpr std::size_t kWorstKept = 10;

    bool pass() const { return differing_codes == 0 && form_faults == 0; }
    TruthSummary& operator+=(const TruthSummary& later);
};

/// The exact coverage of every pixel of a scene by every object, from the same projected faces that the
/// renderer sees, and beside it the float path's answer to the same question.
///
/// The oracle is asked about every face whose bounding box meets the pixel and that is not certainly hidden,
/// found apart from the scan. Where its certificate leaves two floats, or two 16-bit codes, possible for any
/// value of the pixel, rational splitting decides all values of the pixel: so every float and every code is
/// that of the exact number. One pixel in `rational_one_in` is put to rational splitting whatever the
/// certificate says, and must come out the same.
///
/// Properties:
///   (1) Picture and summary are the same for any number of threads.
///   (2) Objects of the same name are one matte.
class SceneTruth {
  public:
    /// All references must outlive this.
    SceneTruth(const ProjectedFaces& faces, const Geometry& geometry, ImageSize size, std::uint64_t seed = 1,
               std::uint64_t rational_one_in = 512);

    /// The rows of `band`, side by side. Bands come in order from the top; what they say is only compared
    /// with.
    void take(const ScanBand& band);

    /// Requires: all bands have been taken.
    const CoveragePicture& picture() const;
    const TruthSummary& summary() const { return summary_; }

  private:
    struct RowResult;
    class RowTruth;

    const ProjectedFaces& faces_;
    std::uint64_t seed_;
    std::uint64_t rational_one_in_;
    crosscheck::FaceBins bins_;
    crosscheck::CertainHiding hiding_;
    std::vector<std::uint32_t> matte_of_face_;  ///< by position in the projected faces
    CoveragePicture picture_;
    TruthSummary summary_;
    int next_row_ = 0;
};

}  // namespace keikan::truth

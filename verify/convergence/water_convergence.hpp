// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "keikan/render/render_scene.hpp"
#include "keikan/scene/scene.hpp"

namespace keikan::convergence {

/// No exact oracle exists for waves, so convergence is the oracle: many samples a pixel are the truth.
struct WaterCheckOptions {
    PixelWindow window;
    int reference_samples = 4096;  ///< a pixel, stratified: Owen-scrambled points of Sobol of another seed
    double error = 2;              ///< that the adaptive method is asked for, in codes of 8 bits
    std::vector<double> k_w{80, 800, 8000};
    std::vector<double> k_r{0, 3, 12};
    int paper_most = 256;  ///< Eq. (1) grows without end towards the horizon
    std::uint32_t seed = 1;
};

/// One way to draw the window, beside the reference. Codes are those of sRGB with 8 bits, not rounded; errors
/// are over all channels of all pixels that hold water.
struct WaterResult {
    std::string method;
    double samples_per_pixel = 0;
    std::uint64_t most_samples = 0;
    double rmse = 0;
    double largest_error = 0;
    std::uint64_t missed = 0;  ///< samples without water or without a finite colour
    double seconds = 0;        ///< of the water alone
};

struct WaterReport {
    PixelWindow window;
    std::uint64_t pixels = 0;  ///< of the window, that hold water
    double asked_error = 0;
    WaterResult adaptive;
    WaterResult
        random;         ///< independent points, as many in each pixel as the adaptive method takes on average
    WaterResult sobol;  ///< Sobol's points, as many
    double filter_rmse = 0;              ///< reference with waves taken for slopes, against all waves traced
    std::uint64_t reference_missed = 0;  ///< of both references
    std::vector<WaterResult> paper;

    static constexpr double kWithin = 0.2;  ///< how far the error may be from the one that was asked for
    static constexpr double kBestOfRandom = 0.7;

    std::uint64_t missed() const;  ///< by any method, and by the references
    bool finite() const;           ///< every method's errors are
    bool error_as_asked() const { return std::abs(adaptive.rmse / asked_error - 1) <= kWithin; }
    bool beats_random() const { return adaptive.rmse <= kBestOfRandom * random.rmse; }
    bool pass() const {
        return pixels > 0 && missed() == 0 && finite() && error_as_asked() && beats_random();
    }
};

/// The part of the picture, at most `size`, whose middle is the median row and column of the water's pixels.
/// Nothing where no water is drawn by rays.
std::optional<PixelWindow> window_of_water(const Scene& scene, const Geometry& geometry, ImageSize size);

/// Draws the window by each method and compares.
///
/// Properties:
///   (1) The adaptive method and the uniform ones are held against a reference in which waves are slopes
///   where they
///       take them for slopes; the paper's, which traces all waves, against one in which all are traced.
///   (2) The random points are rounded up to a whole number a pixel: no fewer than the adaptive method takes.
WaterReport check_water(const Scene& scene, const Geometry& geometry, const WaterCheckOptions& options);

/// Whoever draws: render_scene of one scene with these options for its water and with ExtraImages; or a fault
/// in its place, to see it found.
using WaterDrawing = std::function<RenderedPicture(const WaterOptions&)>;
WaterReport check_water(const WaterDrawing& draw, const WaterCheckOptions& options);

/// {"verdict": "pass" | "fail", "pixels": n, "samples": {...}, "methods": [...], ...}
std::string report_json(const WaterReport& report, double seconds);
/// The table of docs/water.md.
std::string report_table(const WaterReport& report);

}  // namespace keikan::convergence

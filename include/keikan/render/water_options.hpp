// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "keikan/model/pixel.hpp"
#include "keikan/wave/pixel_sampler.hpp"
#include "keikan/wave/sample_count.hpp"

namespace keikan {

/// How many samples a pixel of water gets, and where.
enum class WaterMode {
    Variance,  ///< as many as the target error asks for; waves smaller than the pixel's footprint become
               ///< slopes
    Paper,     ///< equations (1) to (3), all waves traced, the paper's pairs
    Fixed,     ///< the same number everywhere: for comparison
    Flat,      ///< none: flat colour, as any face
};

/// What a pixel that holds water and other things is.
enum class MixedPixels {
    Exact,  ///< samples in the water's visible region, the other faces by their areas
    Paper,  ///< the whole pixel is water (paper, section 6: future work)
};

/// Some columns and rows of a picture.
struct PixelWindow {
    int x = 0, y = 0, width = 0, height = 0;
    bool holds(PixelIndex p) const { return p.x >= x && p.y >= y && p.x < x + width && p.y < y + height; }
};

struct WaterOptions {
    WaterMode mode = WaterMode::Variance;
    MixedPixels mixed = MixedPixels::Exact;
    /// Variance: standard error of the pixel's colour, in sRGB codes of 8 bits: root of the mean square of
    /// the channels'. It is an aim, held to by estimates: over many pixels the root of the mean square of
    /// their errors is within 20 % of it, where pixels need more than `least` and fewer than `most` samples
    /// (`keikan-verify water`, docs/water.md). No bound of any one pixel.
    double error = 2;
    /// Variance: fewest samples of a pixel; four times as many where no pixel nearby was measured beforehand.
    int least = 4;
    int most = 256;                          ///< Variance
    int fixed = 64;                          ///< Fixed
    Sampler fixed_sampler = Sampler::Sobol;  ///< Fixed
    bool filter = true;  ///< Fixed and Variance: waves smaller than the footprint become slopes
    PaperSampleCounts paper{.most = 1024};
    std::uint32_t seed = 1;
    std::optional<PixelWindow> window{};  ///< water elsewhere is left out (black), for measurements
};

struct WaterStatistics {
    std::uint64_t pixels = 0;        ///< that hold water drawn by rays
    std::uint64_t mixed_pixels = 0;  ///< of those, with other things, too
    std::uint64_t samples = 0;
    /// Taken beforehand, to learn how well samples do: 64 for one pixel in 64 (WaterMode::Variance).
    std::uint64_t measuring_samples = 0;
    std::uint64_t most_samples = 0;  ///< of one pixel
    std::uint64_t face_rays = 0;     ///< into the hierarchy of faces
    std::uint64_t wave_rays = 0;     ///< to the waves
    std::uint64_t wave_steps = 0;    ///< of those: how often all waves were evaluated
    std::uint64_t missed = 0;        ///< samples without water or without a finite colour: must be 0
    std::array<std::uint64_t, 17> histogram{};  ///< pixels by samples: [i] counts 2^i to 2^(i+1) - 1
    double seconds = 0;
};

}  // namespace keikan

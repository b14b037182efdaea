// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>

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

struct WaterOptions {
    WaterMode mode = WaterMode::Variance;
    MixedPixels mixed = MixedPixels::Exact;
    double error = 2;  ///< Variance: standard error of the pixel's colour, in sRGB codes of 8 bits
    int least = 16;    ///< Variance: first samples, a power of two
    int most = 256;    ///< Variance
    int fixed = 64;    ///< Fixed
    Sampler fixed_sampler = Sampler::Sobol;  ///< Fixed
    bool filter = true;  ///< Fixed and Variance: waves smaller than the footprint become slopes
    PaperSampleCounts paper{.most = 1024};
    std::uint32_t seed = 1;
};

struct WaterStatistics {
    std::uint64_t pixels = 0;        ///< that hold water drawn by rays
    std::uint64_t mixed_pixels = 0;  ///< of those, with other things, too
    std::uint64_t samples = 0;
    std::uint64_t most_samples = 0;  ///< of one pixel
    std::uint64_t face_rays = 0;  ///< into the hierarchy of faces; each sample is a ray to the waves besides
    std::uint64_t missed = 0;     ///< samples without water or without a finite colour: must be 0
    std::array<std::uint64_t, 17> histogram{};  ///< pixels by samples: [i] counts 2^i to 2^(i+1) - 1
    double seconds = 0;
};

}  // namespace keikan

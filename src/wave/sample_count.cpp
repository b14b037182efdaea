// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/sample_count.hpp"

#include <algorithm>
#include <cmath>

namespace keikan {

int paper_first_count(const WaveSurface& waves, const WaterFootprint& footprint,
                      const PaperSampleCounts& counts) {
    double cycles_m = 0;
    for (std::size_t i = 0; i < waves.size(); ++i)
        cycles_m += waves.amplitude_m(i) * footprint.extent_m(waves.direction(i)) / waves.length_m(i);
    const double n = std::round(counts.k_w * cycles_m);
    return static_cast<int>(
        std::clamp(n, static_cast<double>(counts.least), static_cast<double>(counts.most)));
}

int paper_second_count(double largest_variance, const PaperSampleCounts& counts) {
    if (!(largest_variance > 1)) return 0;
    const double n = std::round(counts.k_r * std::log10(largest_variance));
    return static_cast<int>(std::clamp(n, 0.0, static_cast<double>(counts.most)));
}

}  // namespace keikan

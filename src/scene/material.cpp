// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/material.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keikan {

Rgb HeightSlopeRamp::colour_at(float height_m) const {
    if (height_m <= stops.front().height_m) return stops.front().colour;
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const Stop &low = stops[i - 1], &high = stops[i];
        if (height_m < high.height_m)
            return mixed(low.colour, high.colour, (height_m - low.height_m) / (high.height_m - low.height_m));
    }
    return stops.back().colour;
}

float HeightSlopeRamp::steep_share(float normal_z) const {
    constexpr float kDegreeInFloats = std::numbers::pi_v<float> / 180;
    const float slope_deg = std::acos(std::min(std::abs(normal_z), 1.0f)) / kDegreeInFloats;
    if (slope_deg <= steep_from_deg) return 0;
    if (slope_deg >= steep_full_deg) return 1;
    return (slope_deg - steep_from_deg) / (steep_full_deg - steep_from_deg);
}

}  // namespace keikan

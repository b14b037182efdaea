// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>

namespace keikan {

/// Refractive index of fresh water in visible light, against air.
inline constexpr double kWaterIndex = 1.333;

/// Cosine of the refracted ray's angle to the normal, inside the water, from that of the incident ray
/// outside.
inline double refracted_cosine(double cosine) {
    return std::sqrt(1 - (1 - cosine * cosine) / (kWaterIndex * kWaterIndex));
}

/// The share of unpolarised light that water reflects, exactly (Fresnel); `cosine` is that of the angle
/// between ray and normal, outside, in [0, 1].
inline double fresnel_reflectance(double cosine) {
    const double inside = refracted_cosine(cosine);
    const double s = (cosine - kWaterIndex * inside) / (cosine + kWaterIndex * inside);
    const double p = (inside - kWaterIndex * cosine) / (inside + kWaterIndex * cosine);
    return (s * s + p * p) / 2;
}

}  // namespace keikan

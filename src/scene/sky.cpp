// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/sky.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace keikan {
namespace {

/// CIE's indicatrix: brighter around the sun.
double towards_sun(double cosine) {
    const double c = std::clamp(cosine, -1.0, 1.0);
    return 0.91 + 10 * std::exp(-3 * std::acos(c)) + 0.45 * c * c;
}

/// CIE's gradation: brighter towards the horizon.
double towards_horizon(double cos_z) {
    return 1 - std::exp(-0.32 / std::max(cos_z, 0.0));
}

constexpr double kAtZenith = 0.27385;  ///< 1 - exp(-0.32), as the standard prints it

/// The share of a disc of radius r, in front of everything, that a round pixel sees whose centre is `away`
/// from the disc's: 1 inside, 0 outside, linear across the rim.
double disc_share(double away, double radius, double pixel) {
    return std::clamp((radius - away) / pixel + 0.5, 0.0, 1.0) *
           std::min(1.0, 4 * radius * radius / (pixel * pixel));
}

}  // namespace

double cie_clear_sky(const glm::dvec3& direction, const glm::dvec3& to_sun) {
    return towards_sun(glm::dot(direction, to_sun)) * towards_horizon(direction.z) /
           (kAtZenith * towards_sun(to_sun.z));
}

Sky::Sky(const Background& background, const Light& light) : background_(background), to_sun_(light.to_sun) {
    const double solid_angle = 2 * std::numbers::pi * (1 - std::cos(kSunRadius_rad));
    if (background.sun_disc) disc_ = static_cast<float>(std::numbers::pi / solid_angle) * light.sun;
    per_zenith_luminance_ =
        static_cast<double>(luminance(background.zenith)) / (kAtZenith * towards_sun(light.to_sun.z));
}

Rgb Sky::colour(const glm::dvec3& direction) const {
    const auto rising = static_cast<float>(std::clamp(direction.z, 0.0, 1.0));
    const Rgb gradient = (1 - rising) * background_.horizon + rising * background_.zenith;
    if (background_.model == SkyModel::Gradient) return gradient;
    const float own = luminance(gradient);
    if (!(own > 0)) return {};
    const double wanted =
        towards_sun(glm::dot(direction, to_sun_)) * towards_horizon(direction.z) * per_zenith_luminance_;
    return (static_cast<float>(wanted) / own) * gradient;
}

Rgb Sky::colour_with_sun(const glm::dvec3& direction, double pixel_rad) const {
    const Rgb sky = colour(direction);
    if (!background_.sun_disc || !(direction.z > 0)) return sky;
    const double away = glm::length(direction - to_sun_);  // a chord: the angle, for small ones
    const double share = disc_share(away, kSunRadius_rad, std::max(pixel_rad, 1e-9));
    return share > 0 ? sky + static_cast<float>(share) * disc_ : sky;
}

}  // namespace keikan

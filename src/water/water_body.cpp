// SPDX-License-Identifier: Apache-2.0
#include "water_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "keikan/water/fresnel.hpp"

namespace keikan {

InWater into_water(const WaterSurface& water, const glm::dvec3& down, double transmitted) {
    InWater ray;
    if (!(transmitted > kFaint)) return ray;
    ray.share = transmitted / (kWaterIndex * kWaterIndex);
    ray.down = down;
    ray.mu_v = std::max(-down.z, 1e-3);
    const Rgb a = water.absorption_per_m, b = water.scattering_per_m;
    const double clearest = static_cast<double>(std::min({a.r + b.r, a.g + b.g, a.b + b.b}));
    const double way = water.depth_m / ray.mu_v;
    constexpr double kFaintOpticalDepth = 11 * std::numbers::ln2;  // - log kFaint
    ray.visible_m = clearest > 0 ? std::min(way, kFaintOpticalDepth / clearest) : way;
    return ray;
}

Rgb light_from_water(const WaterSurface& water, const InWater& ray, const Bed& bed, Rgb sun, Rgb sky_ambient,
                     double sun_z) {
    const auto mu_v = static_cast<float>(ray.mu_v), way = static_cast<float>(bed.way_m);
    const double sun_cosine = std::max(sun_z, 0.0);
    const auto mu_s = static_cast<float>(refracted_cosine(sun_cosine));
    const auto into = static_cast<float>(sun_z > 0 ? (1 - fresnel_reflectance(sun_cosine)) * sun_cosine : 0);
    const auto channel = [&](float a, float b, float albedo, float sun_light, float sky_light) {
        const float c = a + b, from_sun = sun_light * into;
        // Down and up again, for light from the sun and from the zenith.
        const float both_sun = 1 + mu_v / mu_s, both_sky = 1 + mu_v;
        const float through_sun = std::exp(-c * way * both_sun), through_sky = std::exp(-c * way * both_sky);
        float radiance = 0;
        if (std::isfinite(bed.way_m)) radiance = albedo * (from_sun * through_sun + sky_light * through_sky);
        if (c > 0)
            radiance +=
                b / (4 * c) *
                (from_sun / mu_s * (1 - through_sun) / both_sun + sky_light * (1 - through_sky) / both_sky);
        return radiance;
    };
    const Rgb a = water.absorption_per_m, b = water.scattering_per_m;
    return {channel(a.r, b.r, bed.albedo.r, sun.r, sky_ambient.r),
            channel(a.g, b.g, bed.albedo.g, sun.g, sky_ambient.g),
            channel(a.b, b.b, bed.albedo.b, sun.b, sky_ambient.b)};
}

}  // namespace keikan

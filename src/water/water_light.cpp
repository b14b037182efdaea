// SPDX-License-Identifier: Apache-2.0
#include "keikan/water/water_light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "keikan/water/fresnel.hpp"
#include "keikan/wave/trace_wave.hpp"

namespace keikan {

namespace {

/// Light that is weaker than this share of what it adds to is not followed: an eighth of a code of 8 bits.
constexpr double kFaint = 1.0 / 2048;

/// A mirrored ray that rises this many standard deviations of the waves' slopes is taken to meet no other
/// wave.
constexpr double kSteepRise = 3;

/// A mirrored ray that rises less steeply is not followed to waves farther away than one that rises like
/// this.
constexpr double kLeastRise = 0.02;

glm::dvec3 normal_of(glm::dvec2 slope) {
    return WavePoint{0, slope}.normal();
}

glm::dvec3 mirror(const glm::dvec3& v, const glm::dvec3& n) {
    return 2 * glm::dot(v, n) * n - v;
}

float channel(Rgb colour, int i) {
    return i == 0 ? colour.r : i == 1 ? colour.g : colour.b;
}

bool finite(Rgb colour) {
    return std::isfinite(colour.r) && std::isfinite(colour.g) && std::isfinite(colour.b);
}

}  // namespace

WaterSample WaterLight::along(const WaterSurface& water, const ResolvedWater& resolved, const ViewRay& ray,
                              SlopeChoice choice) const {
    WaterSample sample;
    const glm::dvec3 below(0, 0, water.level_m);
    const glm::dvec3 eye = ray.origin - below;  // heights are above the mean plane from here on
    const double falling = std::max(-ray.direction.z, 1e-12);
    const double to_plane = std::min(std::max(eye.z, 0.0) / falling, kFarthest_m);
    double t = to_plane;
    glm::dvec2 slope(0, 0);
    glm::dvec3 on_wave = eye + t * ray.direction;
    if (to_plane < kFarthest_m && !resolved.waves.empty()) {
        // No farther than where the ray has left the troughs behind.
        const double farthest = to_plane + (resolved.waves.crest_bound_m() + 1e-6) / falling;
        const auto met = trace_wave(resolved.waves, eye, ray.direction, farthest);
        sample.missed = !met;
        if (met) {
            t = met->t;
            on_wave = eye + t * ray.direction;
            slope = resolved.waves.point(on_wave.x, on_wave.y).slope;
        }
    }
    const glm::dvec3 towards_viewer = -ray.direction;
    const glm::dvec3 on_plane = eye + to_plane * ray.direction + below;

    const SeenSlopes slopes(resolved.unresolved, slope, towards_viewer);
    const glm::dvec3 normal = normal_of(slopes.at(choice.u1, choice.u2));
    const double cosine = std::clamp(glm::dot(normal, towards_viewer), 0.0, 1.0);
    const double reflectance = fresnel_reflectance(cosine);
    Rgb colour = static_cast<float>(reflectance) *
                 mirrored(resolved, on_wave, on_plane, mirror(towards_viewer, normal), sample);
    colour = colour + glitter(slopes, on_plane, towards_viewer, sample);
    if (1 - reflectance > kFaint)
        colour = colour + static_cast<float>((1 - reflectance) / (kWaterIndex * kWaterIndex)) *
                              out_of_water(water, on_plane, normal, towards_viewer, sample);
    sample.colour = through_haze(scene_.haze, colour, t);
    if (!finite(sample.colour)) {
        sample.missed = true;
        sample.colour = scene_.background.horizon;
    }
    return sample;
}

Rgb WaterLight::mirrored(const ResolvedWater& resolved, const glm::dvec3& on_wave, const glm::dvec3& on_plane,
                         glm::dvec3 direction, WaterSample& sample) const {
    // From wave to wave; what is lost into the water at the further mirrors is the water's own light, which
    // is left out: it is dark beside what is mirrored there, at grazing angles.
    float share = 1;
    glm::dvec3 from = on_wave;
    const double steep = kSteepRise * resolved.waves.slope_deviation();
    for (int bounce = 1; bounce < kBounces && !resolved.waves.empty(); ++bounce) {
        if (direction.z > steep * std::hypot(direction.x, direction.y)) break;
        // As far as the ray needs to rise above the crests, at least as steeply as kLeastRise.
        const double reach = 2 * resolved.waves.crest_bound_m() / std::max(direction.z, kLeastRise);
        const auto met = trace_wave(resolved.waves, from, direction, reach);
        if (!met || met->t <= 0) break;
        from = from + met->t * direction;
        const glm::dvec3 normal = resolved.waves.point(from.x, from.y).normal();
        const double cosine = -glm::dot(normal, direction);
        if (!(cosine > 0)) break;
        share *= static_cast<float>(fresnel_reflectance(std::min(cosine, 1.0)));
        direction = mirror(-direction, normal);
    }
    if (direction.z < 0) direction.z = -direction.z;
    ++sample.rays;
    const auto hit = faces_.first_hit(on_plane, direction, kFarthest_m);
    if (!hit) return share * sky_colour(scene_.background, direction);
    const glm::dvec3 point = on_plane + hit->distance_m * direction;
    return share * through_haze(scene_.haze, faces_.colour(*hit, point, direction), hit->distance_m);
}

Rgb WaterLight::glitter(const SeenSlopes& slopes, const glm::dvec3& on_plane,
                        const glm::dvec3& towards_viewer, WaterSample& sample) const {
    const glm::dvec3& sun = scene_.light.to_sun;
    if (!(sun.z > 0)) return {};
    const glm::dvec3 sum = sun + towards_viewer;
    if (!(sum.z > 0)) return {};
    const glm::dvec3 half = sum / glm::length(sum);
    const double cosine = glm::dot(half, towards_viewer);
    const double density = slopes.density_by_projection({-half.x / half.z, -half.y / half.z});
    const double strength = std::numbers::pi * fresnel_reflectance(std::min(cosine, 1.0)) * density /
                            (4 * half.z * half.z * half.z * half.z);
    if (!(strength > kFaint)) return {};
    ++sample.rays;
    if (faces_.any_hit(on_plane, sun, kFarthest_m)) return {};
    return static_cast<float>(strength) * scene_.light.sun;
}

Rgb WaterLight::out_of_water(const WaterSurface& water, const glm::dvec3& on_plane, const glm::dvec3& normal,
                             const glm::dvec3& towards_viewer, WaterSample& sample) const {
    const double cosine = std::clamp(glm::dot(normal, towards_viewer), 0.0, 1.0);
    const double inside = refracted_cosine(cosine);
    const glm::dvec3 down = -(1 / kWaterIndex) * towards_viewer + (cosine / kWaterIndex - inside) * normal;
    const double mu_v = std::max(-down.z, 1e-3);

    const Rgb a = water.absorption_per_m, b = water.scattering_per_m;
    const double clearest = static_cast<double>(std::min({a.r + b.r, a.g + b.g, a.b + b.b}));
    double way = water.depth_m / mu_v;
    Rgb bed = water.bed;
    // A bed is looked for as far as any of its light could be seen.
    const double visible = clearest > 0 ? std::min(way, -std::log(kFaint) / clearest) : way;
    if (visible > FaceRays::kRayStart_m) {
        ++sample.rays;
        if (const auto hit = faces_.first_hit(on_plane, down, std::min(visible, kFarthest_m))) {
            way = hit->distance_m;
            bed = faces_.albedo(*hit, on_plane + way * down);
        }
    }

    const Light& light = scene_.light;
    const double sun_z = std::max(light.to_sun.z, 0.0);
    const double mu_s = refracted_cosine(sun_z);
    const double into = sun_z > 0 ? 1 - fresnel_reflectance(sun_z) : 0;
    const double depth = way * mu_v;
    float result[3];
    for (int i = 0; i < 3; ++i) {
        const double c = static_cast<double>(channel(a, i) + channel(b, i));
        const double sun = static_cast<double>(channel(light.sun, i)) * into * sun_z;
        const double sky = static_cast<double>(channel(light.sky_ambient, i));
        double radiance = 0;
        if (std::isfinite(way))
            radiance = static_cast<double>(channel(bed, i)) * std::exp(-c * way) *
                       (sun * std::exp(-c * depth / mu_s) + sky * std::exp(-c * depth));
        if (c > 0) {
            const auto scattered = [&](double irradiance, double mu) {
                const double both = 1 + mu_v / mu;
                return irradiance / mu * static_cast<double>(channel(b, i)) / 4 *
                       (1 - std::exp(-c * way * both)) / (c * both);
            };
            radiance += scattered(sun, mu_s) + scattered(sky, 1);
        }
        result[i] = static_cast<float>(radiance);
    }
    return {result[0], result[1], result[2]};
}

}  // namespace keikan

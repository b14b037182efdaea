// SPDX-License-Identifier: Apache-2.0
#include "keikan/water/water_light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "keikan/support/check.hpp"
#include "keikan/water/fresnel.hpp"
#include "light_lanes.hpp"
#include "water_body.hpp"

namespace keikan {

namespace {

/// A mirrored ray that rises this many standard deviations of the waves' slopes is taken to meet no other
/// wave.
constexpr double kSteepRise = 3;

/// A mirrored ray that rises less steeply is not followed to waves farther away than one that rises like
/// this.
constexpr double kLeastRise = 0.02;

constexpr std::uint32_t kNoRay = 0xFFFFFFFFu;

glm::dvec3 normal_of(glm::dvec2 slope) {
    return WavePoint{0, slope}.normal();
}

glm::dvec3 mirror(const glm::dvec3& v, const glm::dvec3& n) {
    return 2 * glm::dot(v, n) * n - v;
}

using MirrorLanes = void (*)(const lanes::MirrorJob&);

MirrorLanes mirror_for_this_processor() {
#ifdef KEIKAN_HAS_AVX2_SOURCE
    if (__builtin_cpu_supports("avx2")) return lanes::mirror_with_avx2;
#endif
    return lanes::mirror_with_any_processor;
}

bool same(const ViewRay& p, const ViewRay& q) {
    return p.origin == q.origin && p.direction == q.direction;
}

bool finite(Rgb colour) {
    return std::isfinite(colour.r) && std::isfinite(colour.g) && std::isfinite(colour.b);
}

}  // namespace

/// One sample on its way; heights are above the mean plane.
struct WaterLight::Way {
    double t = 0;                      ///< to the water
    glm::dvec2 slope{0, 0};            ///< of the waves there
    glm::dvec3 on_wave{}, on_plane{};  ///< where the view ray meets the waves; the mean plane (in the world)
    glm::dvec3 towards_viewer{}, direction{};  ///< unit vectors; where the mirrored ray goes
    double reflectance = 0;
    float share = 1;         ///< what mirrors after the first leave of it
    double sun_glitter = 0;  ///< of the sun, if it shines here
    InWater in_water;
    double sun_shares[2] = {1, 1};  ///< on the water; on the face that is mirrored: 0 in the shade
    // Places in the lists of rays.
    std::uint32_t mirror_ray = kNoRay, bed_ray = kNoRay, sun_ray = kNoRay, face_sun_ray = kNoRay;
    std::uint16_t wave_rays = 0;
    std::uint32_t steps = 0;
    bool missed = false;
    bool shares_meeting = false;  ///< with the waves: that of the way before, whose ray is the same
};

WaterLight::Memory::Memory() = default;
WaterLight::Memory::~Memory() = default;

void WaterLight::along(const WaterSurface& water, const ResolvedWater& resolved,
                       std::span<const WaterLook> looks, std::span<WaterSample> samples, Memory& memory,
                       SlopeOrder order) const {
    KEIKAN_CHECK(looks.size() == samples.size(), looks.size() << " looks, " << samples.size() << " samples");
    memory.ways.assign(looks.size(), Way{});
    memory.near.set(resolved.waves, resolved.place, resolved.meeting_error_m);
    meet_waves(water, resolved, looks, memory);
    rank(memory, order);
    mirror_views(water, resolved, looks, memory);
    mirror_between_waves(resolved, memory);
    look_for_faces(memory);
    look_for_sun(looks, memory);
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const Way& way = memory.ways[i];
        WaterSample& sample = samples[i];
        Rgb colour = static_cast<float>(way.reflectance) * mirrored(way, memory) +
                     static_cast<float>(way.sun_glitter * way.sun_shares[0]) * scene_.light.sun;
        if (way.in_water.share > 0)
            colour = colour + static_cast<float>(way.in_water.share) * out_of_water(water, way, memory);
        const auto sent = [](std::uint32_t ray) { return ray != kNoRay ? 1 : 0; };
        sample.face_rays = static_cast<std::uint16_t>(sent(way.mirror_ray) + sent(way.bed_ray) +
                                                      sent(way.sun_ray) + sent(way.face_sun_ray));
        sample.wave_rays = way.wave_rays;
        sample.steps = way.steps;
        sample.colour = through_haze(scene_.haze, colour, way.t);
        sample.missed = way.missed || !finite(sample.colour);
        if (!finite(sample.colour)) sample.colour = scene_.background.horizon;
    }
}

WaterSample WaterLight::along(const WaterSurface& water, const ResolvedWater& resolved,
                              const WaterLook& look) const {
    Memory memory;
    WaterSample sample;
    along(water, resolved, std::span(&look, 1), std::span(&sample, 1), memory);
    return sample;
}

void WaterLight::meet_waves(const WaterSurface& water, const ResolvedWater& resolved,
                            std::span<const WaterLook> looks, Memory& memory) const {
    const glm::dvec3 below(0, 0, water.level_m);
    memory.active.clear();
    memory.wave_rays.clear();
    for (std::size_t i = 0; i < looks.size(); ++i) {
        Way& way = memory.ways[i];
        const ViewRay& ray = looks[i].ray;
        const glm::dvec3 eye = ray.origin - below;
        const double falling = std::max(-ray.direction.z, 1e-12);
        way.t = std::min(std::max(eye.z, 0.0) / falling, kFarthest_m);
        way.towards_viewer = -ray.direction;
        way.on_wave = eye + way.t * ray.direction;
        way.on_plane = way.on_wave + below;
        if (!(way.t < kFarthest_m) || resolved.waves.empty()) continue;
        if (i > 0 && same(ray, looks[i - 1].ray)) {
            way.shares_meeting = true;
            continue;
        }
        // No farther than where the ray has left the troughs behind.
        const double farthest =
            way.t + (resolved.waves.crest_bound_m() + resolved.meeting_error_m + 1e-6) / falling;
        memory.active.push_back(static_cast<std::uint32_t>(i));
        memory.wave_rays.push_back({eye, ray.direction, farthest});
    }
    memory.meetings.resize(memory.wave_rays.size());
    memory.near.trace(memory.wave_rays, memory.meetings);
    for (std::size_t i = 0; i < memory.active.size(); ++i) {
        Way& way = memory.ways[memory.active[i]];
        const auto& met = memory.meetings[i];
        ++way.wave_rays;
        way.missed = !met;
        if (!met) continue;
        way.t = met->t;
        way.on_wave = memory.wave_rays[i].origin + met->t * memory.wave_rays[i].direction;
        way.slope = met->slope;
        way.steps += static_cast<std::uint32_t>(met->steps);
    }
    for (std::size_t i = 1; i < looks.size(); ++i) {
        Way& way = memory.ways[i];
        if (!way.shares_meeting) continue;
        const Way& before = memory.ways[i - 1];
        way.t = before.t;
        way.on_wave = before.on_wave;
        way.slope = before.slope;
        way.missed = before.missed;
    }
}

void WaterLight::rank(Memory& memory, SlopeOrder order) {
    memory.ranks.clear();
    for (std::uint32_t i = 0; i < memory.ways.size(); ++i) {
        // A mirror turns by twice what its normal leans towards the viewer.
        const Way& way = memory.ways[i];
        const glm::dvec3& v = way.towards_viewer;
        memory.ranks.push_back({way.slope.x * v.x + way.slope.y * v.y - v.z / 2, i});
    }
    if (order == SlopeOrder::ByRank) std::sort(memory.ranks.begin(), memory.ranks.end());
}

void WaterLight::mirror_views(const WaterSurface& water, const ResolvedWater& resolved,
                              std::span<const WaterLook> looks, Memory& memory) const {
    static const auto mirror_lanes = mirror_for_this_processor();
    enum List {
        SlopeX,
        SlopeY,
        ViewX,
        ViewY,
        ViewZ,
        U1,
        U2,
        Out,
        Down = Out + 3,
        Reflectance = Down + 3,
        Glitter,
        Lists
    };
    const std::size_t blocks = (looks.size() + lanes::kPadding - 1) / lanes::kPadding;
    memory.numbers.assign(Lists * blocks, Eight{});
    const auto list = [&](int which) { return memory.numbers[static_cast<std::size_t>(which) * blocks].v; };
    const auto set = [&](int which, std::size_t i, double v) { list(which)[i] = static_cast<float>(v); };
    for (std::size_t k = 0; k < looks.size(); ++k) {
        const std::size_t i = memory.ranks[k].second;
        const Way& way = memory.ways[i];
        set(SlopeX, i, way.slope.x);
        set(SlopeY, i, way.slope.y);
        set(ViewX, i, way.towards_viewer.x);
        set(ViewY, i, way.towards_viewer.y);
        set(ViewZ, i, way.towards_viewer.z);
        set(U1, i, looks[k].slope.u1);
        set(U2, i, looks[k].slope.u2);
    }
    const glm::vec3 sun(scene_.light.to_sun);
    // A uniform disc of radius r has the variance r^2 / 4 along each axis; a mirror turns by half the angle.
    constexpr double kDisc = kSunRadius_rad * kSunRadius_rad / 16;
    const SlopeCovariance& rough = resolved.unresolved;
    const auto in_float = [](double v) { return static_cast<float>(v); };
    mirror_lanes({.count = looks.size(),
                  .slope_x = list(SlopeX),
                  .slope_y = list(SlopeY),
                  .view_x = list(ViewX),
                  .view_y = list(ViewY),
                  .view_z = list(ViewZ),
                  .u1 = list(U1),
                  .u2 = list(U2),
                  .xx = in_float(rough.xx),
                  .xy = in_float(rough.xy),
                  .yy = in_float(rough.yy),
                  .disc = in_float(kDisc),
                  .sun_x = sun.x,
                  .sun_y = sun.y,
                  .sun_z = sun.z,
                  .direction = {list(Out), list(Out + 1), list(Out + 2)},
                  .reflectance = list(Reflectance),
                  .glitter = list(Glitter),
                  .down = {list(Down), list(Down + 1), list(Down + 2)}});
    const auto vector = [&](int first, std::size_t i) {
        return glm::dvec3(glm::vec3(list(first)[i], list(first + 1)[i], list(first + 2)[i]));
    };
    for (std::size_t i = 0; i < looks.size(); ++i) {
        Way& way = memory.ways[i];
        way.direction = vector(Out, i);
        way.reflectance = static_cast<double>(list(Reflectance)[i]);
        way.sun_glitter = static_cast<double>(list(Glitter)[i]);
        way.in_water = into_water(water, vector(Down, i), 1 - way.reflectance);
    }
}

void WaterLight::mirror_between_waves(const ResolvedWater& resolved, Memory& memory) const {
    // From wave to wave; what is lost into the water at the further mirrors is the water's own light, which
    // is left out: it is dark beside what is mirrored there, at grazing angles.
    const double steep = kSteepRise * resolved.waves.slope_deviation();
    memory.active.clear();
    for (std::size_t i = 0; !resolved.waves.empty() && i < memory.ways.size(); ++i)
        memory.active.push_back(static_cast<std::uint32_t>(i));
    for (int bounce = 1; bounce < kBounces && !memory.active.empty(); ++bounce) {
        std::erase_if(memory.active, [&](std::uint32_t i) {
            const glm::dvec3& d = memory.ways[i].direction;
            return d.z > 0 && d.z * d.z > steep * steep * (d.x * d.x + d.y * d.y);
        });
        memory.wave_rays.clear();
        for (const std::uint32_t i : memory.active) {
            Way& way = memory.ways[i];
            // As far as the ray needs to rise above the crests, at least as steeply as kLeastRise.
            const double reach =
                (resolved.waves.crest_bound_m() - way.on_wave.z) / std::max(way.direction.z, kLeastRise);
            memory.wave_rays.push_back({way.on_wave, way.direction, reach});
            ++way.wave_rays;
        }
        memory.meetings.resize(memory.wave_rays.size());
        memory.near.trace(memory.wave_rays, memory.meetings);
        std::size_t kept = 0;
        for (std::size_t k = 0; k < memory.active.size(); ++k) {
            Way& way = memory.ways[memory.active[k]];
            const auto& met = memory.meetings[k];
            if (!met || met->t <= 0) continue;
            way.steps += static_cast<std::uint32_t>(met->steps);
            way.on_wave += met->t * way.direction;
            const glm::dvec3 normal = normal_of(met->slope);
            const double cosine = -glm::dot(normal, way.direction);
            if (!(cosine > 0)) continue;
            way.share *= static_cast<float>(fresnel_reflectance(std::min(cosine, 1.0)));
            way.direction = mirror(-way.direction, normal);
            memory.active[kept++] = memory.active[k];
        }
        memory.active.resize(kept);
    }
    for (Way& way : memory.ways) way.direction.z = std::abs(way.direction.z);
}

void WaterLight::look_for_faces(Memory& memory) const {
    memory.face_rays.clear();
    const auto add = [&](const FaceRay& ray) {
        memory.face_rays.push_back(ray);
        return static_cast<std::uint32_t>(memory.face_rays.size() - 1);
    };
    // Rays of one kind side by side: they go the same way.
    for (Way& way : memory.ways) way.mirror_ray = add({way.on_plane, way.direction, kFarthest_m});
    for (Way& way : memory.ways)
        if (way.in_water.share > 0 && way.in_water.visible_m > FaceRays::kRayStart_m)
            way.bed_ray =
                add({way.on_plane, way.in_water.down, std::min(way.in_water.visible_m, kFarthest_m)});
    memory.hits.resize(memory.face_rays.size());
    faces_.first_hits(memory.face_rays, memory.hits);
}

void WaterLight::look_for_sun(std::span<const WaterLook> looks, Memory& memory) const {
    memory.light_rays.clear();
    if (!(scene_.light.to_sun.z > 0)) return;
    const bool shadows = scene_.light.shadows != Shadows::Off;
    const auto add = [&](const FaceRay& ray) {
        memory.light_rays.push_back(ray);
        return static_cast<std::uint32_t>(memory.light_rays.size() - 1);
    };
    for (std::size_t i = 0; i < looks.size(); ++i) {
        Way& way = memory.ways[i];
        const glm::dvec3 to_sun = scene_.light.shadows == Shadows::Soft
                                      ? disc_.at(looks[i].sun.u1, looks[i].sun.u2)
                                      : scene_.light.to_sun;
        if (way.sun_glitter > kFaint || (shadows && way.in_water.share > kFaint))
            way.sun_ray = add({way.on_plane, to_sun, kFarthest_m});
        else
            way.sun_glitter = 0;
        const auto& hit = memory.hits[way.mirror_ray];
        if (!shadows || !hit) continue;
        const double side = glm::dot(hit->flat_normal, way.direction) <= 0 ? 1 : -1;
        if (side * glm::dot(hit->normal, scene_.light.to_sun) <= 0) continue;
        const glm::dvec3 point = way.on_plane + hit->distance_m * way.direction;
        way.face_sun_ray = add(faces_.towards_light(point, side * hit->flat_normal, to_sun));
    }
    memory.hidden.resize(memory.light_rays.size());
    faces_.any_hits(memory.light_rays, memory.hidden);
    for (Way& way : memory.ways) {
        if (way.sun_ray != kNoRay && memory.hidden[way.sun_ray] != 0) way.sun_shares[0] = 0;
        if (way.face_sun_ray != kNoRay && memory.hidden[way.face_sun_ray] != 0) way.sun_shares[1] = 0;
    }
}

Rgb WaterLight::mirrored(const Way& way, const Memory& memory) const {
    const auto& hit = memory.hits[way.mirror_ray];
    if (!hit) return way.share * sky_.colour(way.direction);
    const glm::dvec3 point = way.on_plane + hit->distance_m * way.direction;
    const Rgb lit = faces_.colour(*hit, point, way.direction, static_cast<float>(way.sun_shares[1]));
    return way.share * through_haze(scene_.haze, lit, hit->distance_m);
}

Rgb WaterLight::out_of_water(const WaterSurface& water, const Way& way, const Memory& memory) const {
    const Light& light = scene_.light;
    Bed bed{water.depth_m / way.in_water.mu_v, water.bed};
    if (way.bed_ray != kNoRay && memory.hits[way.bed_ray]) {
        const FaceHit& hit = *memory.hits[way.bed_ray];
        bed = {hit.distance_m, faces_.albedo(hit, way.on_plane + hit.distance_m * way.in_water.down)};
    }
    return light_from_water(water, way.in_water, bed, static_cast<float>(way.sun_shares[0]) * light.sun,
                            light.sky_ambient, light.to_sun.z);
}

}  // namespace keikan

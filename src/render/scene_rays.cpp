// SPDX-License-Identifier: Apache-2.0
#include "keikan/render/scene_rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "keikan/support/check.hpp"
#include "keikan/water/face_rays.hpp"
#include "keikan/water/water_light.hpp"
#include "keikan/wave/counter_random.hpp"
#include "keikan/wave/sample_count.hpp"
#include "keikan/wave/water_footprint.hpp"
#include "water_random.hpp"

namespace keikan {

namespace {

/// A wave is traced in full where its length is at least the footprint's extent along it, and is slopes alone
/// where three of its lengths fit into it; in between, its amplitude fades, so that no line is drawn where it
/// ends.
constexpr double kTracedCycles = 1, kSlopeCycles = 3;

/// How near to the waves a ray meets them, across the view.
constexpr double kMeetingError_px = 0x1p-8;

double traced_share(double cycles) {
    const double s = std::clamp((cycles - kTracedCycles) / (kSlopeCycles - kTracedCycles), 0.0, 1.0);
    return 1 - s * s * (3 - 2 * s);
}

ViewRay view_ray(const Camera& camera, double x, double y) {
    const double u = (x - camera.centre_x) / camera.focal_px, v = (y - camera.centre_y) / camera.focal_px;
    const glm::dvec3 off = u * camera.right + v * camera.down;
    if (camera.kind == Camera::Kind::Orthographic) return {camera.position + off, camera.forward};
    return {camera.position, camera.forward + off};
}

}  // namespace

struct SceneRays::Light {
    Light(const Scene& of, const Geometry& geometry) : scene(of), faces(of, geometry), light(of, faces) {}
    const Scene& scene;
    FaceRays faces;
    WaterLight light;
};

SceneRays::SceneRays(const Scene& scene, const Geometry& geometry)
    : light_(std::make_unique<Light>(scene, geometry)) {}
SceneRays::~SceneRays() = default;

float SceneRays::sun_share(std::span<const glm::dvec3> points, const glm::dvec3& flat_normal,
                           std::uint64_t key) const {
    constexpr std::size_t kTogether = 16;  // on the stack
    std::array<FaceRay, kTogether> rays;
    std::array<std::uint8_t, kTogether> hidden;
    const auto& light = light_->scene.light;
    std::size_t seen = 0;
    for (std::size_t begin = 0; begin < points.size(); begin += kTogether) {
        const std::size_t count = std::min(kTogether, points.size() - begin);
        for (std::size_t i = 0; i < count; ++i) {
            const Point u = shuffled_sobol(static_cast<std::uint32_t>(begin + i), key);
            rays[i] = light_->faces.towards_light(
                points[begin + i], flat_normal,
                light.shadows == Shadows::Hard ? light.to_sun : on_sun_disc(light.to_sun, u.x, u.y));
        }
        light_->faces.any_hits(std::span(rays).first(count), std::span(hidden).first(count));
        seen += static_cast<std::size_t>(
            std::count(hidden.begin(), hidden.begin() + static_cast<std::ptrdiff_t>(count), 0));
    }
    return static_cast<float>(seen) / static_cast<float>(points.size());
}

struct WaterSampler::Working {
    const SceneRays::Light& view;
    bool filter;
    std::uint32_t seed;
    PixelIndex at{};
    const WaterSurface* water = nullptr;
    WaterFootprint footprint{};
    ResolvedWater resolved{};
    std::vector<double> shares{};
    std::vector<WaterLook> looks{};
    std::vector<WaterSample> samples{};
    WaterLight::Memory memory{};
    std::vector<Point> slopes{}, suns{};
    std::vector<Rgb> colours{};
    WaterStatistics statistics{};

    /// The waves that this pixel traces, and the slopes of the others.
    void resolve() {
        const double x = at.x, y = at.y;
        const Camera& camera = view.scene.camera;
        std::array<ViewRay, 4> corners{view_ray(camera, x, y), view_ray(camera, x + 1, y),
                                       view_ray(camera, x + 1, y + 1), view_ray(camera, x, y + 1)};
        for (ViewRay& corner : corners) corner.origin.z -= water->level_m;
        footprint = water_footprint(corners, WaterLight::kFarthest_m);
        const WaveSurface& waves = water->waves;
        resolved.unresolved = {water->ripple_variance / 2, 0, water->ripple_variance / 2};
        shares.assign(waves.size(), 1);
        for (std::size_t i = 0; filter && i < waves.size(); ++i) {
            const glm::dvec2 direction = waves.direction(i);
            shares[i] = traced_share(footprint.extent_m(direction) / waves.length_m(i));
            resolved.unresolved.add(direction, (1 - shares[i] * shares[i]) * waves.slope_variance(i));
        }
        resolved.waves.set_shares(waves, shares);
        resolved.place = footprint.centre();
        const glm::dvec3 to(resolved.place, water->level_m);
        const double away = camera.kind == Camera::Kind::Orthographic ? 1 : glm::length(to - camera.position);
        resolved.meeting_error_m = kMeetingError_px * away / camera.focal_px;
    }
};

WaterSampler::WaterSampler(const SceneRays& rays, bool filter, std::uint32_t seed)
    : working_(new Working{*rays.light_, filter, seed}) {}
WaterSampler::~WaterSampler() = default;
WaterSampler::WaterSampler(WaterSampler&&) noexcept = default;

void WaterSampler::look_at(PixelIndex pixel, std::uint16_t water) {
    const auto& waters = working_->view.scene.water;
    KEIKAN_CHECK(water < waters.size() && waters[water], "water " << water << " is not drawn by rays");
    working_->at = pixel;
    working_->water = &*waters[water];
    working_->resolve();
}

Rgb WaterSampler::mean(std::span<const Point> points) {
    KEIKAN_CHECK(!points.empty(), "a mean of no samples");
    Working& work = *working_;
    work.slopes.clear();
    work.suns.clear();
    const std::uint64_t slope_key = random_key(work.at.x, work.at.y, kSlopeNumbers, work.seed);
    const std::uint64_t sun_key = random_key(work.at.x, work.at.y, kSunNumbers, work.seed);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        work.slopes.push_back(scrambled_sobol(i, slope_key));
        work.suns.push_back(shuffled_sobol(i, sun_key));
    }
    work.colours.resize(points.size());
    colours(points, work.slopes, work.suns, work.colours, SlopeOrder::ByRank);
    double r = 0, g = 0, b = 0;
    for (const Rgb& c : work.colours) {
        r += static_cast<double>(c.r);
        g += static_cast<double>(c.g);
        b += static_cast<double>(c.b);
    }
    const auto n = static_cast<double>(points.size());
    return {static_cast<float>(r / n), static_cast<float>(g / n), static_cast<float>(b / n)};
}

void WaterSampler::colours(std::span<const Point> points, std::span<const Point> slopes,
                           std::span<const Point> suns, std::span<Rgb> colours, SlopeOrder order) {
    KEIKAN_CHECK(
        points.size() == slopes.size() && points.size() == suns.size() && points.size() == colours.size(),
        "points, slopes, suns and colours must be as many");
    Working& work = *working_;
    const Camera& camera = work.view.scene.camera;
    work.looks.resize(points.size());
    work.samples.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        ViewRay ray = view_ray(camera, work.at.x + points[i].x, work.at.y + points[i].y);
        ray.direction = glm::normalize(ray.direction);
        work.looks[i] = {ray, {slopes[i].x, slopes[i].y}, {suns[i].x, suns[i].y}};
    }
    work.view.light.along(*work.water, work.resolved, work.looks, work.samples, work.memory, order);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const WaterSample& sample = work.samples[i];
        colours[i] = sample.colour;
        work.statistics.face_rays += sample.face_rays;
        work.statistics.wave_rays += sample.wave_rays;
        work.statistics.wave_steps += sample.steps;
        work.statistics.missed += sample.missed ? 1 : 0;
    }
    work.statistics.samples += points.size();
}

int WaterSampler::paper_first_count(const PaperSampleCounts& counts) const {
    return keikan::paper_first_count(working_->water->waves, working_->footprint, counts);
}

std::span<const FaceRay> WaterSampler::first_hit_rays() const {
    return working_->memory.face_rays;
}

std::span<const FaceRay> WaterSampler::sun_rays() const {
    return working_->memory.light_rays;
}

const WaterStatistics& WaterSampler::statistics() const {
    return working_->statistics;
}

}  // namespace keikan

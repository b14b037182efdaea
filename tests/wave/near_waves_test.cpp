// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/near_waves.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "../../src/wave/near_lanes.hpp"
#include "keikan/wave/counter_random.hpp"
#include "keikan/wave/wind_sea.hpp"

using namespace keikan;

namespace {

/// Rays of one pixel far from the origin, with `slope` metres down for each metre ahead; they come to the
/// mean plane within a metre of the place.
std::vector<WaveRay> pixel_rays(CounterRandom& random, glm::dvec2 place, double slope, int count) {
    const double turn = 2 * std::numbers::pi * random.uniform();
    std::vector<WaveRay> rays;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 direction = glm::normalize(glm::dvec3(std::cos(turn), std::sin(turn), -slope));
        const glm::dvec3 at(place.x + random.uniform(), place.y + random.uniform(), 0);
        const double before = 2 / -direction.z;
        rays.push_back({at - before * direction, direction, 2 * before});
    }
    return rays;
}

double above_waves(const WaveSurface& waves, const WaveRay& ray, double t) {
    const glm::dvec3 p = ray.origin + t * ray.direction;
    return p.z - waves.point(p.x, p.y).height_m;
}

/// (1) and (2), by marching.
void check_near(const WaveSurface& waves, const WaveRay& ray, const std::optional<WaveMeeting>& met,
                double error, int marching_steps) {
    const double end = met ? met->t : ray.t_max;
    if (met) {
        REQUIRE((met->t >= 0 && met->t <= ray.t_max));
        REQUIRE(above_waves(waves, ray, met->t) <= error);
        const glm::dvec3 p = ray.origin + met->t * ray.direction;
        REQUIRE(glm::length(waves.point(p.x, p.y).slope - met->slope) < 1e-3);
    }
    for (int i = 0; i <= marching_steps; ++i)
        REQUIRE(above_waves(waves, ray, end * i / marching_steps) >= -error);
}

WaveSurface windy(int count) {
    WindSea sea;
    sea.wind_speed_m_s = 3.2;
    sea.fetch_m = 900;
    sea.shortest_m = 0.15;
    sea.count = count;
    return WaveSurface(wind_sea(sea));
}

const std::vector<StokesWave> kSteepWaves{{0.6, 9, 0, 0}, {0.15, 2.3, 1.1, 0.4}, {0.02, 0.3, -0.6, 1.7}};

}  // namespace

TEST_CASE(
    "NearWaves: dense marching finds no crest that was stepped through, and no ray deeper than the error",
    "[wave][trace][near]") {
    const WaveSurface sea = windy(28), steep(kSteepWaves);
    CounterRandom random(21);
    NearWaves near;
    std::vector<std::optional<WaveMeeting>> met;
    const glm::dvec2 place(24'000, -7'000);
    for (const WaveSurface* waves : {&sea, &steep})
        for (const double slope : {1.0, 0.17, 0.05})
            for (const double error : {1e-3, 1e-4, 2e-5}) {
                const std::vector<WaveRay> rays = pixel_rays(random, place, slope, 12);
                near.set(*waves, place, error);
                met.assign(rays.size(), {});
                near.trace(rays, met);
                for (std::size_t i = 0; i < rays.size(); ++i) {
                    REQUIRE(met[i]);
                    check_near(*waves, rays[i], met[i], error, 1500);
                }
            }
}

TEST_CASE("NearWaves: rays that start where a view met the waves leave them, and miss no other crest",
          "[wave][trace][near]") {
    const WaveSurface waves = windy(28);
    CounterRandom random(22);
    NearWaves near;
    const glm::dvec2 place(300, 4'000);
    const double error = 5e-5;
    near.set(waves, place, error);
    std::vector<WaveRay> rays = pixel_rays(random, place, 0.1, 300);
    std::vector<std::optional<WaveMeeting>> met(rays.size());
    near.trace(rays, met);
    std::vector<WaveRay> mirrored;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        REQUIRE(met[i]);
        const glm::dvec3 normal = WavePoint{0, met[i]->slope}.normal();
        const double cosine = glm::dot(normal, rays[i].direction);
        const glm::dvec3 away = rays[i].direction - 2 * cosine * normal;
        mirrored.push_back({rays[i].origin + met[i]->t * rays[i].direction, away,
                            (waves.crest_bound_m() + 0.05) / std::max(away.z, 0.02)});
    }
    met.assign(mirrored.size(), {});
    near.trace(mirrored, met);
    int again = 0, at_once = 0;
    for (std::size_t i = 0; i < mirrored.size(); ++i) {
        if (met[i]) ++again;
        if (met[i] && met[i]->t <= 0) ++at_once;
        check_near(waves, mirrored[i], met[i], error, 1500);
    }
    CHECK(at_once == 0);
    CHECK(again > 10);
    CHECK(again < 150);
}

TEST_CASE("NearWaves: many rays at once have the bits that each has by itself, with vectors of any width",
          "[wave][trace][near][lanes]") {
    const WaveSurface waves = windy(21);
    CounterRandom random(23);
    std::vector<WaveRay> rays;
    for (const double slope : {1.0, 0.1, 0.02})
        for (const WaveRay& ray : pixel_rays(random, {5, 9}, slope, 50)) rays.push_back(ray);
    NearWaves near;
    near.set(waves, {5, 9}, 1e-4);
    std::vector<std::optional<WaveMeeting>> together(rays.size());
    near.trace(rays, together);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        std::optional<WaveMeeting> alone;
        near.trace(std::span(&rays[i], 1), std::span(&alone, 1));
        REQUIRE((alone && together[i]));
        CHECK(alone->t == together[i]->t);
        CHECK(alone->slope == together[i]->slope);
        CHECK(alone->steps == together[i]->steps);
    }
    // The lanes themselves, four and eight at a time.
    const lanes::NearWave two[] = {{0.3f, 0.1f, 0.2f, {0.1f, 0.01f, 0}, {-0.1f, -0.02f, 0}},
                                   {1.1f, -0.4f, 0.7f, {0.02f, 0, 0}, {-0.02f, 0, 0}}};
    const lanes::NearPrefix prefixes[] = {{1, -0.03f, 0.5f, 0.1f, 0.2f}, {2, -0.01f, 1.6f, -0.2f, 0.4f}};
    std::vector<lanes::NearRay> plain;
    for (int i = 0; i < 37; ++i)
        plain.push_back({{static_cast<float>(random.uniform()), static_cast<float>(random.uniform()), 0.2f},
                         {0.9f, 0.1f, i % 3 == 0 ? 0.1f : -0.2f},
                         3});
    std::vector<lanes::NearHit> narrow(plain.size()), wide(plain.size());
    lanes::NearJob job{two, prefixes, 2, 1e-4f, 1e-5f, plain.data(), plain.size(), narrow.data()};
    lanes::trace_near_with_any_processor(job);
    job.hits = wide.data();
#if defined(__x86_64__)
    if (!__builtin_cpu_supports("avx2")) return;
    lanes::trace_near_with_avx2(job);
    for (std::size_t i = 0; i < plain.size(); ++i) {
        CHECK(narrow[i].met == wide[i].met);
        CHECK(narrow[i].t == wide[i].t);
        CHECK(narrow[i].slope[0] == wide[i].slope[0]);
        CHECK(narrow[i].slope[1] == wide[i].slope[1]);
        CHECK(narrow[i].steps == wide[i].steps);
    }
#endif
}

TEST_CASE("NearWaves: what single precision is not good enough for is left to trace_waves",
          "[wave][trace][near]") {
    const WaveSurface waves = windy(12);
    CounterRandom random(24);
    const std::vector<WaveRay> rays = pixel_rays(random, {0, 0}, 0.2, 5);
    std::vector<std::optional<WaveMeeting>> exact(rays.size()), met(rays.size());
    NearWaves near;
    const auto same_as_exact = [&](glm::dvec2 place, double error) {
        near.set(waves, place, error);
        near.trace(rays, met);
        std::vector<WaveRay> lifted = rays;
        if (error > kTraceError)
            for (WaveRay& ray : lifted) ray.origin.z += error / 2;
        trace_waves(waves, lifted, exact);
        bool same = true;
        for (std::size_t i = 0; i < rays.size(); ++i) same &= met[i] && exact[i] && met[i]->t == exact[i]->t;
        return same;
    };
    CHECK(same_as_exact({0, 0}, kTraceError));
    CHECK(same_as_exact({0, 0}, 1e-7));
    CHECK(same_as_exact({2000, 0}, 1e-4));
    CHECK_FALSE(same_as_exact({0, 0}, 1e-4));
}

TEST_CASE("NearWaves: still water is met where the plane is", "[wave][trace][near]") {
    const WaveSurface still;
    NearWaves near;
    near.set(still, {1, 2}, 1e-4);
    const WaveRay ray{{1, 2, 10}, {0, 0.6, -0.8}, 100};
    std::optional<WaveMeeting> met;
    near.trace(std::span(&ray, 1), std::span(&met, 1));
    REQUIRE(met);
    CHECK(std::abs(met->t - 12.5) < 2e-4);
}

// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/trace_wave.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "../../src/wave/trace_lanes.hpp"
#include "keikan/wave/counter_random.hpp"
#include "keikan/wave/wind_sea.hpp"

using namespace keikan;

namespace {

struct Ray {
    glm::dvec3 origin, direction;
    glm::dvec3 at(double t) const { return origin + t * direction; }
};

double above_water(const WaveSurface& water, const glm::dvec3& p) {
    return p.z - water.point(p.x, p.y).height_m;
}

/// The bound of property (2), with the rounding of the heights that a test computes by itself.
constexpr double kDeepest = kTraceError + kWaveHeightError;

/// Marches the ray densely up to where it was met, or to its end: the deepest point below the water.
double deepest_before(const WaveSurface& water, const Ray& ray, double t_end, int steps) {
    double deepest = 0;
    for (int i = 0; i < steps; ++i)
        deepest = std::max(deepest, -above_water(water, ray.at(t_end * i / steps)));
    return deepest;
}

/// A random ray from a height towards the water, `slope` metres down for each metre ahead.
Ray random_ray(CounterRandom& random, double height_m, double slope) {
    const double turn = 2 * std::numbers::pi * random.uniform();
    const glm::dvec3 direction(std::cos(turn), std::sin(turn), -slope);
    return {{1000 * random.uniform(), 1000 * random.uniform(), height_m}, glm::normalize(direction)};
}

void check_ray(const WaveSurface& water, const Ray& ray, double t_max, int marching_steps) {
    const auto met = trace_wave(water, ray.origin, ray.direction, t_max);
    if (met) {
        REQUIRE(met->t >= 0);
        REQUIRE(met->t <= t_max);
        const double above = above_water(water, ray.at(met->t));
        REQUIRE(above <= kTraceError + kWaveHeightError);
        if (met->t == 0) return;  // it may have started below
        REQUIRE(above >= -kDeepest);
    }
    REQUIRE(deepest_before(water, ray, met ? met->t : t_max, marching_steps) <= kDeepest);
}

const std::vector<StokesWave> kSteep{{0.6, 9, 0, 0}, {0.15, 2.3, 1.1, 0.4}, {0.02, 0.3, -0.6, 1.7}};

}  // namespace

TEST_CASE("trace_wave: still water is met where the plane is", "[wave][trace]") {
    const WaveSurface still;
    const auto met = trace_wave(still, {1, 2, 10}, {0, 0.6, -0.8}, 100);
    REQUIRE(met);
    CHECK(met->t == Approx(12.5).epsilon(1e-14));
    CHECK_FALSE(trace_wave(still, {1, 2, 10}, {0, 0.6, -0.8}, 12));
    CHECK_FALSE(trace_wave(still, {1, 2, 10}, {0, 1, 0}, 100));
    CHECK_FALSE(trace_wave(still, {1, 2, 10}, {0, 0.8, 0.6}, 100));
}

TEST_CASE("trace_wave: straight down, the meeting is at the water's height", "[wave][trace]") {
    const WaveSurface water(kSteep);
    CounterRandom random(5);
    for (int i = 0; i < 500; ++i) {
        const double x = 100 * random.uniform(), y = 100 * random.uniform();
        const auto met = trace_wave(water, {x, y, 50}, {0, 0, -1}, 100);
        REQUIRE(met);
        REQUIRE(std::abs(50 - met->t - water.point(x, y).height_m) < kTraceError + kWaveHeightError);
    }
}

TEST_CASE("trace_wave: a level ray is met on the flank of the first crest that is high enough",
          "[wave][trace]") {
    // One sine wave of length 10, crest at x = 10: half of its amplitude is met where cos = 1/2, 10/6 before.
    const StokesWave wave{0.7, 10, 0, 0};
    const WaveSurface water(std::span(&wave, 1), 1);
    const auto met = trace_wave(water, {5, 0, 0.35}, {1, 0, 0}, 1000);
    REQUIRE(met);
    CHECK(met->t == Approx(5 - 10.0 / 6).margin(1e-7));
    // A hair above the crest nothing is met, a hair below it is, however far away.
    CHECK_FALSE(trace_wave(water, {5, 0, 0.7 + 1e-7}, {1, 0, 0}, 1000));
    CHECK(trace_wave(water, {5, 0, 0.7 - 1e-7}, {1, 0, 0}, 1000));
}

TEST_CASE("trace_wave: dense marching finds no crest that was stepped through", "[wave][trace]") {
    const WaveSurface water(kSteep);
    CounterRandom random(6);
    for (const double slope : {1.0, 0.3, 0.05})
        for (int i = 0; i < 150; ++i)
            check_ray(water, random_ray(random, 1 + 3 * random.uniform(), slope), 400, 2000);
}

TEST_CASE("trace_wave: at grazing angles neither", "[wave][trace]") {
    const WaveSurface water(kSteep);
    CounterRandom random(7);
    for (const double slope : {1e-2, 1e-3, 1e-5, 0.0, -1e-3})
        for (int i = 0; i < 40; ++i)
            check_ray(water, random_ray(random, 0.5 + 0.5 * random.uniform(), slope), 600, 20'000);
}

TEST_CASE("trace_wave: nor in a sea of many waves", "[wave][trace]") {
    WindSea sea;
    sea.wind_speed_m_s = 7;
    sea.count = 60;
    const WaveSurface water(wind_sea(sea));
    CounterRandom random(8);
    for (const double slope : {0.3, 0.03, 0.003})
        for (int i = 0; i < 25; ++i) check_ray(water, random_ray(random, 2.5, slope), 900, 5000);
}

TEST_CASE("trace_wave: a ray that touches a crest from above stays out of the water", "[wave][trace]") {
    // Tangents at points of a sine wave, from both sides.
    const StokesWave wave{0.7, 10, 0, 0};
    const WaveSurface water(std::span(&wave, 1), 1);
    for (const double x : {9.0, 9.5, 10.0, 10.4, 11.1}) {
        const WavePoint p = water.point(x, 0);
        const glm::dvec3 direction = glm::normalize(glm::dvec3(1, 0, p.slope.x));
        for (const double lift : {-1e-6, 1e-6}) {
            const Ray ray{glm::dvec3(x, 0, p.height_m + lift) - 2.0 * direction, direction};
            check_ray(water, ray, 20, 50'000);
            const auto met = trace_wave(water, ray.origin, ray.direction, 4);
            CHECK(met.has_value() == (lift < 0));
        }
    }
}

TEST_CASE("trace_wave: a ray that starts on the water and rises leaves it", "[wave][trace]") {
    const WaveSurface water(kSteep);
    CounterRandom random(9);
    int met_again = 0;
    for (int i = 0; i < 1000; ++i) {
        const double x = 300 * random.uniform(), y = 300 * random.uniform();
        const WavePoint p = water.point(x, y);
        const double turn = 2 * std::numbers::pi * random.uniform();
        glm::dvec3 direction(std::cos(turn), std::sin(turn), 0);
        direction.z = p.slope.x * direction.x + p.slope.y * direction.y + 0.05;
        const Ray ray{{x, y, p.height_m}, glm::normalize(direction)};
        const auto met = trace_wave(water, ray.origin, ray.direction, 50);
        if (met) {
            ++met_again;
            REQUIRE(met->t > 1e-3);
        }
        REQUIRE(deepest_before(water, ray, met ? met->t : 50, 2000) <= kDeepest);
    }
    CHECK(met_again > 20);
}

TEST_CASE("trace_wave: a ray that starts below the water meets it at once", "[wave][trace]") {
    const WaveSurface water(kSteep);
    const double height = water.point(3, 4).height_m;
    const auto met = trace_wave(water, {3, 4, height - 0.01}, {0, 0.6, 0.8}, 10);
    REQUIRE(met);
    CHECK(met->t == 0);
}

TEST_CASE("trace_wave: few steps are enough", "[wave][trace]") {
    WindSea sea;
    sea.count = 40;
    const WaveSurface water(wind_sea(sea));
    CounterRandom random(10);
    const auto mean_steps = [&](double slope) {
        double sum = 0;
        for (int i = 0; i < 200; ++i) {
            const Ray ray = random_ray(random, 20, slope);
            sum += trace_wave(water, ray.origin, ray.direction, 1e6).value().steps;
        }
        return sum / 200;
    };
    const double steep = mean_steps(0.5), low = mean_steps(0.05), grazing = mean_steps(0.005);
    INFO("steps on average: " << steep << ", " << low << ", " << grazing);
    CHECK(steep < 10);
    CHECK(low < 30);
    CHECK(grazing < 120);
}

TEST_CASE("trace_waves: many rays at once have the bits that each has by itself, with vectors of any width",
          "[wave][trace][lanes]") {
    WindSea sea;
    sea.count = 30;
    const WaveSurface water(wind_sea(sea));
    CounterRandom random(11);
    std::vector<WaveRay> rays;
    for (int i = 0; i < 150; ++i) {
        const Ray ray = random_ray(random, 1.5, i % 3 == 0 ? -0.02 : i % 3 == 1 ? 0.02 : 0.6);
        rays.push_back({ray.origin, ray.direction, i % 5 == 0 ? 1 : 300.0});
    }
    std::vector<std::optional<WaveMeeting>> together(rays.size());
    trace_waves(water, rays, together);
    std::vector<lanes::Ray> plain;
    for (const WaveRay& ray : rays)
        plain.push_back({{ray.origin.x, ray.origin.y, ray.origin.z},
                         {ray.direction.x, ray.direction.y, ray.direction.z},
                         ray.t_max});
    std::vector<lanes::Hit> narrow(rays.size());
    lanes::trace_with_any_processor({water.series().data(), water.size(), water.crest_bound_m(), kTraceError,
                                     plain.data(), plain.size(), narrow.data()});
    int met = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto alone = trace_wave(water, rays[i].origin, rays[i].direction, rays[i].t_max);
        REQUIRE(together[i].has_value() == alone.has_value());
        REQUIRE(together[i].has_value() == narrow[i].met);
        if (!alone) continue;
        ++met;
        CHECK(together[i]->t == alone->t);
        CHECK(together[i]->slope == alone->slope);
        CHECK(together[i]->steps == alone->steps);
        CHECK(narrow[i].t == alone->t);
        CHECK(narrow[i].slope[0] == alone->slope.x);
        const glm::dvec3 at = rays[i].origin + alone->t * rays[i].direction;
        CHECK(glm::length(water.point(at.x, at.y).slope - alone->slope) < 1e-9);
    }
    CHECK(met > 50);
    CHECK(met < 140);
}

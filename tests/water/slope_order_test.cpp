// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "keikan/water/water_light.hpp"
#include "keikan/wave/counter_random.hpp"
#include "keikan/wave/pixel_sampler.hpp"
#include "upright_wall.hpp"

using namespace keikan;

namespace {

/// Waves and ripples before a wall whose edge is seen in them: a part of a small pixel, drawn with 32
/// samples.
struct Scenery {
    Scene scene;
    Geometry geometry = test::upright_wall(3, 20, 0, 4);
    WaterSurface water;
    ResolvedWater resolved;

    Scenery() {
        scene.background.zenith = scene.background.horizon = {1, 1, 1};
        scene.light.sun = {0, 0, 0};
        scene.light.sky_ambient = scene.light.ground_ambient = {0.1f, 0.1f, 0.1f};
        scene.haze.range_m = 0;
        scene.materials.push_back(Material{});
        scene.camera.position = {0, 0, 10};
        const StokesWave waves[] = {{0.04, 1.1, 0.4, 0}, {0.01, 0.4, 1.9, 2}};
        water.waves = WaveSurface(waves);
        resolved = {water.waves, {6e-4, 0, 6e-4}, 1e-4, {0, 14}};
    }
    static ViewRay ray(Point p) {
        return {{0, 0, 3}, glm::normalize(glm::dvec3(0.02 * p.x, 0.97, -0.25 + 0.01 * p.y))};
    }
};

std::vector<WaterLook> looks_of(std::uint64_t key, std::uint32_t slopes_of_a_place) {
    std::vector<WaterLook> looks;
    for (std::uint32_t i = 0; i < 32; ++i) {
        const Point p = scrambled_sobol(i / slopes_of_a_place, mixed(key)),
                    s = scrambled_sobol(i, mixed(key + 1));
        looks.push_back({Scenery::ray(p), {s.x, s.y}, {}});
    }
    return looks;
}

struct Estimate {
    double mean = 0, variance = 0;  ///< of the means of 32 samples
};

Estimate estimate(const Scenery& s, SlopeOrder order, std::uint32_t slopes_of_a_place, int runs) {
    const FaceRays rays(s.scene, s.geometry);
    const WaterLight light(s.scene, rays);
    WaterLight::Memory memory;
    std::vector<WaterSample> samples(32);
    double sum = 0, squares = 0;
    for (int run = 0; run < runs; ++run) {
        light.along(s.water, s.resolved, looks_of(static_cast<std::uint64_t>(7919 * run), slopes_of_a_place),
                    samples, memory, order);
        double mean = 0;
        for (const WaterSample& sample : samples) mean += static_cast<double>(sample.colour.g) / 32;
        sum += mean;
        squares += mean * mean;
    }
    return {sum / runs, squares / runs - sum * sum / runs / runs};
}

}  // namespace

TEST_CASE("WaterLight: slopes that are paired by rank change no expectation, and err less",
          "[water][light]") {
    const Scenery s;
    const int runs = 1500;
    const Estimate given = estimate(s, SlopeOrder::AsGiven, 1, runs),
                   rank = estimate(s, SlopeOrder::ByRank, 1, runs),
                   shared = estimate(s, SlopeOrder::ByRank, 2, runs);
    INFO(given.mean << " " << rank.mean << " " << shared.mean << ", variances " << given.variance << " "
                    << rank.variance << " " << shared.variance);
    const double standard = std::sqrt(given.variance / runs);
    CHECK(std::abs(rank.mean - given.mean) < 5 * standard);
    CHECK(std::abs(shared.mean - given.mean) < 5 * standard);
    CHECK(rank.variance < 0.8 * given.variance);
    CHECK(shared.variance < 0.9 * given.variance);
}

TEST_CASE("WaterLight: samples that share a place see what they see by themselves", "[water][light]") {
    const Scenery s;
    const FaceRays rays(s.scene, s.geometry);
    const WaterLight light(s.scene, rays);
    WaterLight::Memory memory;
    const std::vector<WaterLook> looks = looks_of(3, 4);
    std::vector<WaterSample> together(looks.size());
    light.along(s.water, s.resolved, looks, together, memory);
    std::uint64_t steps = 0, alone_steps = 0;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const WaterSample alone = light.along(s.water, s.resolved, looks[i]);
        CHECK(together[i].colour == alone.colour);
        CHECK(together[i].missed == alone.missed);
        steps += together[i].steps;
        alone_steps += alone.steps;
    }
    CHECK(steps < alone_steps);
}

// SPDX-License-Identifier: Apache-2.0
#include "keikan/water/water_light.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "keikan/support/parallel.hpp"
#include "keikan/water/fresnel.hpp"
#include "keikan/wave/pixel_sampler.hpp"
#include "upright_wall.hpp"

using namespace keikan;

namespace {

/// A scene without a file: sky of one colour, no sun, no haze, one white material.
Scene empty_scene(Rgb sky) {
    Scene scene;
    scene.background.zenith = scene.background.horizon = sky;
    scene.light.sun = scene.light.sky_ambient = scene.light.ground_ambient = {0, 0, 0};
    scene.haze.range_m = 0;
    Material white;
    white.name = "white";
    white.colour = {1, 1, 1};
    scene.materials.push_back(white);
    scene.camera.position = {0, 0, 10};
    return scene;
}

/// An upright square wall at y = 20, x and z from -50 to 50, as an object.
Geometry wall() {
    return test::upright_wall(50, 20, -50, 50);
}

WaterSurface black_water() {
    WaterSurface water;
    water.ripple_variance = 0;
    water.absorption_per_m = {1e6f, 1e6f, 1e6f};
    water.scattering_per_m = {0, 0, 0};
    return water;
}

}  // namespace

TEST_CASE("FaceRays: while it lives, work still goes on side by side", "[water][rays][threads]") {
    const ThreadLimit two(2);
    const Scene scene = empty_scene({0, 0, 0});
    const Geometry geometry = wall();
    const FaceRays rays(scene, geometry);
    std::atomic<int> begun = 0, met = 0;
    parallel_for(2, [&](std::size_t) {
        ++begun;
        const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(5);
        while (begun < 2 && std::chrono::steady_clock::now() < patience) {
        }
        if (begun == 2) ++met;
    });
    CHECK(met == 2);
}

TEST_CASE("FaceRays: the first face, its distance and its Phong colour", "[water][rays]") {
    Scene scene = empty_scene({0, 0, 0});
    scene.light.sky_ambient = {0.4f, 0.4f, 0.4f};
    scene.light.ground_ambient = {0.2f, 0.2f, 0.2f};
    scene.light.sun = {1, 1, 1};
    scene.light.to_sun = {0, -0.6, 0.8};
    const Geometry geometry = wall();
    const FaceRays rays(scene, geometry);
    const auto hit = rays.first_hit({{1, 0, 3}, {0, 0.8, 0.6}, 1000});
    REQUIRE(hit);
    CHECK(hit->distance_m == Approx(25).epsilon(1e-6));
    CHECK(std::abs(hit->flat_normal.y) == Approx(1));
    // Half of sky and ground, 0.3, and the sun at a cosine of 0.6.
    CHECK(rays.colour(*hit, {1, 20, 18}, {0, 0.8, 0.6}).r == Approx(0.9).epsilon(1e-6));
    // Its other side is in the shade.
    CHECK(rays.colour(*hit, {1, 20, 18}, {0, -0.8, 0.6}).r == Approx(0.3).epsilon(1e-6));
    CHECK_FALSE(rays.first_hit({{1, 0, 3}, {0, 0.8, 0.6}, 24}));
    CHECK_FALSE(rays.first_hit({{1, 0, 3}, {0, -0.8, 0.6}, 1000}));
    CHECK(rays.any_hit({{1, 0, 3}, {0, 0.8, 0.6}, 1000}));
    CHECK_FALSE(rays.any_hit({{1, 0, 3}, {0, 0.8, 0.6}, 24}));
}

TEST_CASE("WaterLight: black still water shows the sky by Fresnel's share", "[water][light]") {
    const Scene scene = empty_scene({1, 0.5f, 0.25f});
    const Geometry nothing{{}, {0}, {}};
    const FaceRays rays(scene, nothing);
    const WaterLight light(scene, rays);
    const WaterSurface water = black_water();
    for (const double elevation : {1.4, 0.5, 0.1, 0.01}) {
        const ViewRay ray{{3, 4, 10}, {std::cos(elevation), 0, -std::sin(elevation)}};
        const WaterSample sample = light.along(water, {}, {ray, {}, {}});
        CHECK_FALSE(sample.missed);
        CHECK(sample.colour.r == Approx(fresnel_reflectance(std::sin(elevation))).epsilon(1e-5));
        CHECK(sample.colour.g == Approx(0.5 * fresnel_reflectance(std::sin(elevation))).epsilon(1e-5));
    }
}

TEST_CASE("WaterLight: a wall is mirrored where the mirror says, and hazed over the whole way",
          "[water][light]") {
    Scene scene = empty_scene({0, 0, 0});
    scene.light.sky_ambient = scene.light.ground_ambient = {1, 1, 1};
    const Geometry geometry = wall();
    const FaceRays rays(scene, geometry);
    const WaterLight light(scene, rays);
    // From 10 m above, 3 : 4 down: the water at y = 13.33, the wall 6.67 m behind it.
    const ViewRay ray{{0, 0, 10}, {0, 0.8, -0.6}};
    const double reflected = fresnel_reflectance(0.6);
    CHECK(light.along(black_water(), {}, {ray, {}, {}}).colour.r == Approx(reflected).epsilon(1e-5));
    // Away from the wall there is the black sky.
    CHECK(light.along(black_water(), {}, {{{0, 0, 10}, {0, -0.8, -0.6}}, {}, {}}).colour.r == 0);
    // Black haze takes exp(-1) of 50/3 m to the water and of 25/3 m behind it.
    scene.haze = {{0, 0, 0}, 25};
    const WaterLight hazy(scene, rays);
    CHECK(hazy.along(black_water(), {}, {ray, {}, {}}).colour.r ==
          Approx(reflected * std::exp(-1)).epsilon(1e-5));
}

TEST_CASE("WaterLight: clear water over a bed, straight down", "[water][light]") {
    Scene scene = empty_scene({0, 0, 0});
    scene.light.sun = {1, 1, 1};
    scene.light.to_sun = {0.6, 0, 0.8};  // in the zenith, its mirror image would be in the way
    const Geometry nothing{{}, {0}, {}};
    const FaceRays rays(scene, nothing);
    const WaterLight light(scene, rays);
    WaterSurface water;
    water.ripple_variance = 0;
    water.depth_m = 2;
    water.bed = {0.5f, 0.5f, 0.5f};
    water.scattering_per_m = {0, 0, 0};
    water.absorption_per_m = {0, 0.25f, 1};
    const Rgb seen = light.along(water, {}, {{{0, 0, 10}, {0, 0, -1}}, {}, {}}).colour;
    // In and out through the surface, n^-2 for the wider cone outside; 2 m of water upwards, 2 m by mu_s
    // downwards.
    const double through =
        (1 - fresnel_reflectance(1)) * 0.8 * (1 - fresnel_reflectance(0.8)) / (kWaterIndex * kWaterIndex);
    const double way = 2 + 2 / refracted_cosine(0.8);
    CHECK(seen.r == Approx(0.5 * through).epsilon(1e-5));
    CHECK(seen.g == Approx(0.5 * through * std::exp(-0.25 * way)).epsilon(1e-5));
    CHECK(seen.b == Approx(0.5 * through * std::exp(-way)).epsilon(1e-5));
}

TEST_CASE("WaterLight: deep water scatters b / (4 c (1 + mu_v / mu_s)) of the sun", "[water][light]") {
    Scene scene = empty_scene({0, 0, 0});
    scene.light.sun = {1, 1, 1};
    scene.light.to_sun = {0.6, 0, 0.8};
    const Geometry nothing{{}, {0}, {}};
    const FaceRays rays(scene, nothing);
    WaterSurface water;
    water.ripple_variance = 0;
    water.absorption_per_m = {0.3f, 0.3f, 0.3f};
    water.scattering_per_m = {0.1f, 0.1f, 0.1f};
    const Rgb seen = WaterLight(scene, rays).along(water, {}, {{{0, 0, 10}, {0, 0, -1}}, {}, {}}).colour;
    const double through =
        (1 - fresnel_reflectance(1)) * 0.8 * (1 - fresnel_reflectance(0.8)) / (kWaterIndex * kWaterIndex);
    const double mu_s = refracted_cosine(0.8);
    CHECK(seen.r == Approx(through / mu_s * 0.1 / 4 / 0.4 / (1 + 1 / mu_s)).epsilon(1e-5));
}

TEST_CASE("WaterLight: still water mirrors the sun's disc, with the irradiance that Fresnel leaves of it",
          "[water][light]") {
    Scene scene = empty_scene({0, 0, 0});
    scene.light.sun = {1, 1, 1};
    scene.light.to_sun = {0, 0.6, 0.8};
    const Geometry nothing{{}, {0}, {}};
    const FaceRays rays(scene, nothing);
    const WaterLight light(scene, rays);
    // Directions around the mirrored sun, 0.025 degrees apart.
    const double step = 0.025 * std::numbers::pi / 180;
    double irradiance = 0;
    for (int i = -60; i <= 60; ++i)
        for (int j = -60; j <= 60; ++j) {
            const double elevation = std::asin(0.8) + i * step, turn = j * step / 0.6;
            const glm::dvec3 direction(std::cos(elevation) * std::sin(turn),
                                       std::cos(elevation) * std::cos(turn), -std::sin(elevation));
            const double seen = static_cast<double>(
                light.along(black_water(), {}, {{{0, 0, 10}, direction}, {}, {}}).colour.r);
            irradiance += seen * step * step * std::cos(elevation) / 0.6;
        }
    CHECK(irradiance == Approx(std::numbers::pi * fresnel_reflectance(0.8)).epsilon(0.01));
}

TEST_CASE("WaterLight: glitter is the mirror image of a small sun in random slopes", "[water][light]") {
    // A disc of the sun's irradiance, 3 degrees across, mirrored by slopes that are drawn one by one.
    Scene scene = empty_scene({0, 0, 0});
    scene.light.sun = {1, 1, 1};
    const Geometry nothing{{}, {0}, {}};
    const FaceRays rays(scene, nothing);
    ResolvedWater rough;
    rough.unresolved = {0.02, 0.003, 0.015};
    for (const double elevation : {0.9, 0.35}) {
        scene.light.to_sun = {0.3, std::cos(elevation) * 0.9, 0};
        scene.light.to_sun.z = std::sqrt(1 - glm::dot(scene.light.to_sun, scene.light.to_sun));
        const glm::dvec3 view(0, std::cos(elevation), -std::sin(elevation));
        const WaterLight light(scene, rays);
        const double found =
            static_cast<double>(light.along(black_water(), rough, {{{0, 0, 10}, view}, {}, {}}).colour.r);

        const SeenSlopes slopes(rough.unresolved, {0, 0}, -view);
        const double cone = std::cos(1.5 * std::numbers::pi / 180);
        const double radiance = std::numbers::pi / (2 * std::numbers::pi * (1 - cone));  // of the disc
        const std::uint32_t n = 1 << 18;
        double expected = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            const Point u = scrambled_sobol(i, 5);
            const glm::dvec3 normal = WavePoint{0, slopes.at(u.x, u.y)}.normal();
            const double cosine = -glm::dot(normal, view);
            const glm::dvec3 mirrored = view + 2 * cosine * normal;
            if (glm::dot(mirrored, scene.light.to_sun) > cone)
                expected += radiance * fresnel_reflectance(cosine) / n;
        }
        INFO("elevation " << elevation);
        // The disc is 0.026 wide in slopes, a fifth of the standard deviation: it blurs by a few per cent.
        CHECK(found == Approx(expected).epsilon(0.05));
    }
}

TEST_CASE("WaterLight: rays that come from waves miss nothing and stay finite", "[water][light]") {
    Scene scene = empty_scene({1, 1, 1});
    scene.light.sun = {1, 1, 1};
    scene.light.to_sun = glm::normalize(glm::dvec3(0.3, 0.5, 0.2));
    const Geometry geometry = wall();
    const FaceRays rays(scene, geometry);
    const WaterLight light(scene, rays);
    WaterSurface water;
    const StokesWave waves[] = {{0.3, 6, 0.4, 0}, {0.05, 1.1, 1.9, 2}};
    water.waves = WaveSurface(waves);
    ResolvedWater resolved{water.waves, {0.002, 0, 0.002}};
    for (std::uint32_t i = 0; i < 4000; ++i) {
        const Point u = scrambled_sobol(i, 6), s = shuffled_sobol(i, 7);
        const double elevation = 0.001 + 1.5 * u.x * u.x, turn = 2 * std::numbers::pi * u.y;
        const glm::dvec3 direction(std::cos(elevation) * std::cos(turn), std::cos(elevation) * std::sin(turn),
                                   -std::sin(elevation));
        const WaterSample sample = light.along(water, resolved, {{{0, 0, 10}, direction}, {s.x, s.y}, {}});
        REQUIRE_FALSE(sample.missed);
        // Nor where rays may meet the waves above or below them.
        resolved.meeting_error_m = 2e-3 * u.y;
        resolved.place = glm::dvec2(direction.x, direction.y) * (10 / -direction.z);
        REQUIRE_FALSE(light.along(water, resolved, {{{0, 0, 10}, direction}, {s.x, s.y}, {}}).missed);
        // No brighter than the sun itself: pi over the solid angle of its disc, 6.8e-5.
        REQUIRE((sample.colour.r >= 0 && sample.colour.r < 5e4));
    }
}

// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/sky.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "keikan/water/face_rays.hpp"
#include "keikan/wave/pixel_sampler.hpp"
#include "upright_wall.hpp"

using namespace keikan;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

glm::dvec3 at_elevation(double degrees, double azimuth_degrees = 0) {
    const double e = degrees * kDegree, a = azimuth_degrees * kDegree;
    return {std::cos(e) * std::sin(a), std::cos(e) * std::cos(a), std::sin(e)};
}

}  // namespace

TEST_CASE("cie_clear_sky: values worked out by hand", "[water][sky]") {
    // Sun 30 degrees up: zs = 60 degrees, denominator 0.27385 (0.91 + 10 exp(-pi) + 0.45 / 4) = 0.39836.
    const glm::dvec3 sun = at_elevation(30);
    CHECK(cie_clear_sky({0, 0, 1}, sun) == Approx(1).epsilon(1e-5));
    // Horizon under the sun, g = 30 degrees: 0.91 + 10 exp(-pi/2) + 0.45 * 3/4 = 3.32630.
    CHECK(cie_clear_sky(at_elevation(0), sun) == Approx(3.32630 / 0.39836).epsilon(1e-4));
    // Horizon opposite, g = 150 degrees: 0.91 + 10 exp(-5 pi / 2) + 0.45 * 3/4 = 1.25138.
    CHECK(cie_clear_sky(at_elevation(0, 180), sun) == Approx(1.25138 / 0.39836).epsilon(1e-4));
    // 30 degrees up, opposite: g = 120 degrees, gradation 1 - exp(-0.64) = 0.47271;
    // 0.91 + 10 exp(-2 pi) + 0.45 / 4 = 1.04117.
    CHECK(cie_clear_sky(at_elevation(30, 180), sun) == Approx(1.04117 * 0.47271 / 0.39836).epsilon(1e-4));
}

TEST_CASE("Sky: the clear sky has the zenith's luminance times CIE's", "[water][sky]") {
    Background background;
    background.model = SkyModel::CieClear;
    Light light;
    light.to_sun = at_elevation(30);
    const Sky sky(background, light);
    for (const glm::dvec3& d : {at_elevation(90), at_elevation(40, 70), at_elevation(5, 200)})
        CHECK(luminance(sky.colour(d)) ==
              Approx(static_cast<double>(luminance(background.zenith)) * cie_clear_sky(d, light.to_sun))
                  .epsilon(1e-4));
}

TEST_CASE("Sky: the sun's disc has the irradiance of the light", "[water][sky]") {
    Background background;
    background.zenith = background.horizon = {0, 0, 0};
    background.sun_disc = true;
    Light light;
    light.sun = {2, 1, 0.5f};
    light.to_sun = at_elevation(40);
    const Sky sky(background, light);
    // 0.02 degrees from pixel to pixel, over a square of two degrees.
    const double step = 0.02 * kDegree;
    double irradiance = 0;
    const glm::dvec3 right(1, 0, 0), up = glm::cross(right, light.to_sun);
    for (int i = -50; i <= 50; ++i)
        for (int j = -50; j <= 50; ++j) {
            const glm::dvec3 d = glm::normalize(light.to_sun + i * step * right + j * step * up);
            irradiance += static_cast<double>(sky.colour_with_sun(d, step).r) * step * step;
        }
    CHECK(irradiance == Approx(2 * std::numbers::pi).epsilon(0.01));
    CHECK(sky.colour_with_sun(at_elevation(41), step) == Rgb{0, 0, 0});
}

TEST_CASE("on_sun_disc: directions fill the disc of 0.2666 degrees evenly", "[water][sky]") {
    const glm::dvec3 sun = at_elevation(35, 20);
    int inner = 0;
    double farthest = 0;
    for (std::uint32_t i = 0; i < 4096; ++i) {
        const Point u = scrambled_sobol(i, 1);
        const double away = std::acos(std::min(1.0, glm::dot(on_sun_disc(sun, u.x, u.y), sun)));
        farthest = std::max(farthest, away);
        inner += away < 0.2666 * kDegree / 2 ? 1 : 0;
    }
    CHECK(farthest <= 0.2666 * kDegree * (1 + 1e-6));
    CHECK(farthest > 0.99 * 0.2666 * kDegree);
    CHECK(inner == Approx(1024).margin(20));  // half of the radius, a quarter of the area
}

TEST_CASE(
    "FaceRays: a wall's shadow ends where the sun's rays do, in a penumbra of its distance times 2 tan "
    "0.2666",
    "[water][sky][shadow]") {
    // The top edge of a wall at y = 0, 10 m high; the sun 45 degrees up beyond it: its shadow ends at y = -10
    // on z = 0.
    const Geometry geometry = test::upright_wall(500, 0, -1, 10);
    Scene scene;
    scene.camera.position = {0, -20, 5};
    scene.light.to_sun = at_elevation(45);
    const FaceRays rays(scene, geometry);
    const auto lit_share = [&](double y) {
        int lit = 0;
        for (std::uint32_t i = 0; i < 1024; ++i) {
            const Point u = scrambled_sobol(i, 2);
            const glm::dvec3 to_sun = on_sun_disc(scene.light.to_sun, u.x, u.y);
            lit += rays.any_hit(rays.towards_light({0, y, 0}, {0, 0, 1}, to_sun)) ? 0 : 1;
        }
        return lit / 1024.0;
    };
    // Across the rays the penumbra is distance * 2 tan 0.2666 degrees = 14.142 * 0.0093062 wide; on the
    // ground, at 45 degrees, sqrt 2 as much: 0.18612 m. Rays start kRayStart_m higher up, which moves it by
    // as much.
    const double half = 0.18612 / 2, slack = 3 * FaceRays::kRayStart_m;
    CHECK(lit_share(-10 - half - slack) == 1);
    CHECK(lit_share(-10 + half + slack) == 0);
    CHECK(lit_share(-10) == Approx(0.5).margin(0.03));
    CHECK(lit_share(-10 - half + 5 * slack) < 1);
    CHECK(lit_share(-10 + half - 5 * slack) > 0);
    // A disc's share beyond a chord at half its radius: 1/3 - sqrt(3) / (4 pi) = 0.19550.
    CHECK(lit_share(-10 + half / 2) == Approx(0.1955).margin(0.03));
}

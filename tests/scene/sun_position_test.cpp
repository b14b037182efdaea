// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/sun_position.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

using namespace keikan;

namespace {
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSunErrorDeg = 0.02;  // sun_position.hpp
}  // namespace

TEST_CASE("sun_position: the worked example of the NREL solar position algorithm", "[scene][sun]") {
    // Reda, Andreas 2004: 2003-10-17 12:30:30 at UTC-7, 39.742476 N, 105.1786 W: azimuth 194.34024,
    // topocentric elevation without refraction 39.872046.
    const SunPosition sun = sun_position({2003, 10, 17, 12, 30, 30, -7}, 39.742476, -105.1786);
    CHECK(sun.azimuth_rad / kDegree == Approx(194.34024).margin(kSunErrorDeg));
    CHECK(sun.elevation_rad / kDegree == Approx(39.872046).margin(kSunErrorDeg));
}

TEST_CASE("sun_position: the declination of Meeus, example 25.a", "[scene][sun]") {
    // 1992-10-13 0h: declination -7.78507 degrees, which is the elevation seen from the North Pole.
    const SunPosition sun = sun_position({1992, 10, 13, 0, 0, 0, 0}, 90, 0);
    CHECK(sun.elevation_rad / kDegree == Approx(-7.78507).margin(kSunErrorDeg));
}

TEST_CASE("sun_position: at noon of the June solstice the sun stands over the Tropic of Cancer",
          "[scene][sun]") {
    // 2020-06-20 21:44 UTC was the solstice; the sun was overhead near 23.437 N, 145.5 W.
    const SunPosition sun = sun_position({2020, 6, 20, 21, 44, 0, 0}, 23.437, -145.54);
    CHECK(sun.elevation_rad / kDegree == Approx(90).margin(0.2));
}

TEST_CASE("sun_position: the same moment by another clock is the same sun", "[scene][sun]") {
    const SunPosition tokyo = sun_position({1997, 10, 16, 0, 30, 0, 9}, 35, 139);
    const SunPosition utc = sun_position({1997, 10, 15, 15, 30, 0, 0}, 35, 139);
    CHECK(tokyo.azimuth_rad == Approx(utc.azimuth_rad));
    CHECK(tokyo.elevation_rad == Approx(utc.elevation_rad));
}

TEST_CASE("direction_of: azimuth runs from north to east", "[scene][sun]") {
    const glm::dvec3 east = direction_of({90 * kDegree, 0});
    CHECK(glm::length(east - glm::dvec3(1, 0, 0)) < 1e-15);
    CHECK(direction_of({0, 30 * kDegree}).z == Approx(0.5));
}

// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/camera.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

using namespace keikan;

namespace {

/// Rounding of a few operations on numbers below 1e4.
constexpr double kRounding = 1e-11;

bool near(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(a - b) <= kRounding;
}

}  // namespace

TEST_CASE("camera: looking north, east is to the right and the sky above", "[scene][camera]") {
    Camera camera;
    camera.position = {100, 200, 30};
    camera.look_along({0, 5, 0});
    CHECK(near(camera.right, {1, 0, 0}));
    CHECK(near(camera.down, {0, 0, -1}));
    CHECK(near(camera.forward, {0, 1, 0}));
    CHECK(near(camera.view_direction(camera.centre_x, camera.centre_y), {0, 1, 0}));
    CHECK(camera.view_direction(camera.centre_x + 1, camera.centre_y).x > 0);
    CHECK(camera.view_direction(camera.centre_x, camera.centre_y - 1).z > 0);
}

TEST_CASE("camera: its axes are orthonormal and right-handed whichever way it looks", "[scene][camera]") {
    for (const glm::dvec3 direction :
         {glm::dvec3(1, 2, 3), {-1, 0.5, -0.2}, {0, 0, 1}, {0, 0, -7}, {0, -1, 0}}) {
        for (const double roll : {0.0, 0.4, -2.0}) {
            Camera camera;
            camera.look_along(direction, roll);
            CHECK(near(glm::cross(camera.right, camera.down), camera.forward));
            CHECK(std::abs(glm::length(camera.right) - 1) <= kRounding);
            CHECK(std::abs(glm::dot(camera.right, camera.forward)) <= kRounding);
            CHECK(near(camera.forward, glm::normalize(direction)));
        }
    }
}

TEST_CASE("camera: rolled clockwise, its right side dips", "[scene][camera]") {
    Camera camera;
    camera.look_along({0, 1, 0}, std::numbers::pi / 6);
    CHECK(camera.right.z == Approx(-0.5));
}

TEST_CASE("camera: image_point and world_point undo each other", "[scene][camera]") {
    for (const auto kind : {Camera::Kind::Perspective, Camera::Kind::Orthographic}) {
        Camera camera;
        camera.kind = kind;
        camera.focal_px = kind == Camera::Kind::Perspective ? 1200 : 3.5;
        camera.position = {-20, 40, 7};
        camera.look_along({3, 1, 0.2}, 0.1);
        const glm::dvec3 world(400, 180, 55);
        const auto seen = camera.image_point(world);
        REQUIRE(seen);
        CHECK(near(camera.world_point(seen->x, seen->y, camera.nearness_at(seen->depth_m)), world));
    }
}

TEST_CASE("camera: what is nearer than the near plane has no image point", "[scene][camera]") {
    Camera camera;
    CHECK_FALSE(camera.image_point({0, 0.05, 0}));
    CHECK_FALSE(camera.image_point({0, -10, 0}));
    CHECK(camera.image_point({0, 0.1, 0}));
}

TEST_CASE("camera: a line of sight passes through the point that it sees", "[scene][camera]") {
    Camera camera;
    camera.look_along({1, 1, 0.1});
    const glm::dvec3 direction = camera.view_direction(120, 610);
    const auto seen = camera.image_point(camera.position + 250.0 * direction);
    REQUIRE(seen);
    CHECK(seen->x == Approx(120));
    CHECK(seen->y == Approx(610));
}

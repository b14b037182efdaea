// SPDX-License-Identifier: Apache-2.0
#include "hidden_backs.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace keikan {
namespace {

/// An upright square, seen from above.
struct Square {
    glm::dvec2 low, high;
};

/// Distance from the eye to the farthest corner of the near plane's part of the view.
double near_reach(const Camera& camera) {
    const double x = std::max(camera.centre_x, camera.size.width - camera.centre_x) / camera.focal_px;
    const double y = std::max(camera.centre_y, camera.size.height - camera.centre_y) / camera.focal_px;
    return camera.near_m * std::sqrt(1 + x * x + y * y);
}

/// The greatest height of the face's plane over the square; infinite where the plane is upright.
double greatest_height(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const Square& square) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    if (!(normal.z > 0)) return HUGE_VAL;
    const auto rise = [&](double slope, double from, double to) {
        return std::max(-slope * from, -slope * to) / normal.z;
    };
    return a.z + rise(normal.x, square.low.x - a.x, square.high.x - a.x) +
           rise(normal.y, square.low.y - a.y, square.high.y - a.y);
}

bool stands_above(const Mesh& terrain, const Camera& camera) {
    // Twice the reach: what remains after every rounding of heights and distances is far more than the reach.
    const double reach = 2 * near_reach(camera);
    const glm::dvec2 eye(camera.position);
    const Square square{eye - reach, eye + reach};
    glm::dvec2 low(HUGE_VAL), high(-HUGE_VAL);
    for (const glm::dvec3& p : terrain.positions) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    if (!(low.x <= square.low.x && low.y <= square.low.y && high.x >= square.high.x &&
          high.y >= square.high.y))
        return false;
    for (std::size_t f = 0; f < terrain.face_count(); ++f) {
        const auto corners = terrain.face(f);
        if (corners.size() != 3) return false;
        const glm::dvec3 &a = terrain.positions[corners[0]], &b = terrain.positions[corners[1]],
                         &c = terrain.positions[corners[2]];
        const bool apart =
            std::max({a.x, b.x, c.x}) < square.low.x || std::min({a.x, b.x, c.x}) > square.high.x ||
            std::max({a.y, b.y, c.y}) < square.low.y || std::min({a.y, b.y, c.y}) > square.high.y;
        if (!apart && greatest_height(a, b, c, square) >= camera.position.z - reach) return false;
    }
    return true;
}

}  // namespace

bool backs_are_hidden(const Object& object, const Camera& camera) {
    if (object.mesh.closed) return true;
    return object.kind == ObjectKind::Terrain && camera.kind == Camera::Kind::Perspective &&
           stands_above(object.mesh, camera);
}

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/camera.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "keikan/support/check.hpp"

namespace keikan {

glm::dvec3 Camera::world_point(double x, double y, double w) const {
    const double depth = depth_at(w);
    const double scale = kind == Kind::Perspective ? depth / focal_px : 1 / focal_px;
    return position + depth * forward + (x - centre_x) * scale * right + (y - centre_y) * scale * down;
}

glm::dvec3 Camera::view_direction(double x, double y) const {
    if (kind == Kind::Orthographic) return forward;
    return glm::normalize(forward + (x - centre_x) / focal_px * right + (y - centre_y) / focal_px * down);
}

std::optional<ImagePoint> Camera::image_point(const glm::dvec3& world) const {
    const glm::dvec3 from_eye = world - position;
    const double depth = glm::dot(forward, from_eye);
    if (depth < near_m) return std::nullopt;
    const double scale = kind == Kind::Perspective ? focal_px / depth : focal_px;
    return ImagePoint{centre_x + scale * glm::dot(right, from_eye),
                      centre_y + scale * glm::dot(down, from_eye), depth};
}

void Camera::look_along(const glm::dvec3& direction, double roll_rad) {
    KEIKAN_CHECK(glm::length(direction) > 0, "a camera needs a direction");
    forward = glm::normalize(direction);
    // Level right-hand direction; a camera that looks straight up or down takes east for it.
    const glm::dvec3 level(forward.y, -forward.x, 0);
    const glm::dvec3 level_right = glm::length(level) > 0 ? glm::normalize(level) : glm::dvec3(1, 0, 0);
    const glm::dvec3 level_down = glm::cross(forward, level_right);
    right = std::cos(roll_rad) * level_right + std::sin(roll_rad) * level_down;
    down = glm::cross(forward, right);
}

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>
#include <optional>

#include "keikan/model/pixel.hpp"

namespace keikan {

/// Where a world point is seen, and how far away along the view direction.
struct ImagePoint {
    double x = 0;
    double y = 0;
    double depth_m = 0;
};

/// A camera, ready to project. A world point X has camera coordinates
///   depth = forward . (X - position),  u = right . (X - position),  v = down . (X - position)   [m],
/// and is seen at the image point
///   perspective:   (centre_x + focal_px u / depth,  centre_y + focal_px v / depth)
///   orthographic:  (centre_x + focal_px u,          centre_y + focal_px v)
/// right, down, forward are orthonormal and right-handed; +v is down, as image rows are.
struct Camera {
    enum class Kind { Perspective, Orthographic };
    Kind kind = Kind::Perspective;
    glm::dvec3 position{0, 0, 0};
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 down{0, 0, -1};
    glm::dvec3 forward{0, 1, 0};
    double focal_px = 1000;  ///< pixels per unit of u/depth (perspective) or pixels per metre (orthographic)
    double centre_x = 500;   ///< principal point, image coordinates
    double centre_y = 325;
    double near_m = 0.1;  ///< what is nearer than this is cut away exactly at the plane depth = near_m
    ImageSize size{1000, 650};

    /// Nearness of a point at this depth: 1/depth (perspective) or -depth (orthographic).
    double nearness_at(double depth_m) const { return kind == Kind::Perspective ? 1 / depth_m : -depth_m; }
    double depth_at(double nearness) const { return kind == Kind::Perspective ? 1 / nearness : -nearness; }
    /// The world point seen at image point (x, y) with nearness w.
    glm::dvec3 world_point(double x, double y, double w) const;
    /// Unit vector from the eye towards what is seen at image point (x, y).
    glm::dvec3 view_direction(double x, double y) const;
    /// Where a world point is seen; nothing when it is nearer than near_m.
    std::optional<ImagePoint> image_point(const glm::dvec3& world) const;
    /// Turns the camera to look along `direction` (any length but 0) with its rows level, then rolls it
    /// clockwise as seen from behind it, so that the picture turns counter-clockwise. Straight up or down,
    /// east is to the right.
    void look_along(const glm::dvec3& direction, double roll_rad = 0);
};

}  // namespace keikan

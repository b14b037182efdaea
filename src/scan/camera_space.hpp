// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/geometric.hpp>

#include "keikan/model/point.hpp"
#include "keikan/scene/camera.hpp"

namespace keikan {

/// A point, or a direction, along the camera's axes right, down, forward [m].
struct CameraPoint {
    double u = 0;
    double v = 0;
    double depth = 0;

    friend CameraPoint operator+(const CameraPoint& p, const CameraPoint& q) {
        return {p.u + q.u, p.v + q.v, p.depth + q.depth};
    }
    friend CameraPoint operator-(const CameraPoint& p, const CameraPoint& q) {
        return {p.u - q.u, p.v - q.v, p.depth - q.depth};
    }
    friend CameraPoint operator*(const CameraPoint& p, double s) { return {p.u * s, p.v * s, p.depth * s}; }
};

inline double dot(const CameraPoint& p, const CameraPoint& q) {
    return p.u * q.u + p.v * q.v + p.depth * q.depth;
}

inline CameraPoint cross(const CameraPoint& p, const CameraPoint& q) {
    return {p.v * q.depth - p.depth * q.v, p.depth * q.u - p.u * q.depth, p.u * q.v - p.v * q.u};
}

/// The world point in camera coordinates. Subtracts the position first: what is near stays accurate however
/// far the world's origin is.
inline CameraPoint camera_point(const Camera& camera, const glm::dvec3& world) {
    const glm::dvec3 from_eye = world - camera.position;
    return {glm::dot(camera.right, from_eye), glm::dot(camera.down, from_eye),
            glm::dot(camera.forward, from_eye)};
}

/// Where a point in front of the near plane is seen.
inline Point image_point(const Camera& camera, const CameraPoint& p) {
    if (camera.kind == Camera::Kind::Orthographic)
        return {camera.centre_x + camera.focal_px * p.u, camera.centre_y + camera.focal_px * p.v};
    return {camera.centre_x + camera.focal_px * p.u / p.depth,
            camera.centre_y + camera.focal_px * p.v / p.depth};
}

}  // namespace keikan

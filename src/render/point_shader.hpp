// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "keikan/image/image.hpp"
#include "keikan/scan/scan_band.hpp"
#include "keikan/scene/scene.hpp"

namespace keikan {

/// The colour of one point of the picture: the equations of keikan/render/shade.hpp, with what is the same
/// for all points worked out once.
class PointShader {
  public:
    explicit PointShader(const Scene& scene);

    /// The face's colour where it is seen at the image point (x, y).
    Rgb face_colour(const SeenFace& face, double x, double y) const;
    Rgb background_colour(double x, double y) const;

    /// Distance of the face from the camera's plane at (x, y) [m], at most kFarthest_m.
    double depth(const SeenFace& face, double x, double y) const;

    /// A face seen edge-on may round to a point at infinity or beyond; it is taken to be this far away,
    /// where any haze is complete.
    static constexpr double kFarthest_m = 1e9;

  private:
    /// The ray through an image point, towards the scene, for each metre of depth.
    glm::dvec3 ray(double x, double y) const {
        if (!perspective_) return camera_.forward;
        return camera_.forward + (x - camera_.centre_x) * step_right_ + (y - camera_.centre_y) * step_down_;
    }
    Rgb albedo(const Material& material, const SeenFace& face, double x, double y, double depth_m) const;

    const Scene& scene_;
    Camera camera_;
    bool perspective_;
    glm::dvec3 step_right_, step_down_;  ///< of the ray from one pixel to the next
    glm::vec3 to_sun_;
    double haze_per_m_;
};

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "keikan/image/image.hpp"
#include "keikan/scan/scan_band.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/scene/sky.hpp"

namespace keikan {

/// The colour of points of the picture: the equations of keikan/render/shade.hpp, with what is the same for
/// all points worked out once.
class PointShader {
  public:
    explicit PointShader(const Scene& scene);

    Rgb background_colour(double x, double y) const;

    /// Distance of the face from the camera's plane where it is seen at the image point (x, y) [m], at most
    /// kFarthest_m.
    double depth(const SeenFace& face, double x, double y) const;

    /// A face seen edge-on may round to a point at infinity or beyond; it is taken to be this far away,
    /// where any haze is complete.
    static constexpr double kFarthest_m = 1e9;

  private:
    friend class FaceShader;

    /// The ray through an image point, towards the scene, for each metre of depth. In float, it is off by at
    /// most 2^-22 of its length: a millimetre of height at 4 km.
    glm::vec3 ray(double x, double y) const {
        if (!perspective_) return forward_;
        return forward_ + static_cast<float>(x - camera_.centre_x) * step_right_ +
               static_cast<float>(y - camera_.centre_y) * step_down_;
    }
    /// The z of Camera::world_point, which is all that a ramp looks at.
    double height_m(double x, double y, double depth_m, const glm::vec3& towards) const;
    Rgb hazed(Rgb colour, double depth_m, float ray_length) const;

    const Scene& scene_;
    Sky sky_;
    Camera camera_;
    bool perspective_;
    glm::vec3 forward_;
    glm::vec3 step_right_, step_down_;  ///< of the ray from one pixel to the next
    glm::vec3 to_sun_;
    Rgb sky_over_ground_;
    double haze_per_m_;
};

/// The same for points of one face.
class FaceShader {
  public:
    FaceShader(const PointShader& shader, const SeenFace& face);

    /// The face's colour where it is seen at the image point (x, y), in this share of the sun.
    Rgb colour(double x, double y, float sun_share = 1) const;

    /// Whether the sun shines on the side that is seen at (x, y), unless something is before it.
    bool faces_sun(double x, double y) const { return glm::dot(unit_normal(x, y), all_.to_sun_) > 0; }

  private:
    glm::vec3 unit_normal(double x, double y) const;
    Rgb albedo(double x, double y, double depth_m, const glm::vec3& towards, float normal_z) const;

    const PointShader& all_;
    const SeenFace& face_;
    const Material& material_;
    bool bends_;        ///< the normal changes over the face
    glm::vec3 normal_;  ///< where it does not
};

}  // namespace keikan

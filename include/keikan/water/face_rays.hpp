// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "keikan/image/image.hpp"
#include "keikan/scene/scene.hpp"

namespace keikan {

/// What a ray met.
struct FaceHit {
    double distance_m = 0;
    glm::dvec3 normal{
        0, 0, 1};  ///< for shading: unit vector, interpolated where the mesh has normals, of either side
    glm::dvec3 flat_normal{0, 0, 1};  ///< of the face itself
    std::uint16_t material = 0;
};

/// All faces of a scene but those of water, in a hierarchy for single rays (Embree 3, robust: no ray slips
/// through the edge between two faces). May be asked from several threads at once.
///
/// Requires: `scene` and `geometry` outlive it.
/// Error:    vertices are rounded to float relative to the camera: 2^-24 of their distance from it.
class FaceRays {
  public:
    FaceRays(const Scene& scene, const Geometry& geometry);
    ~FaceRays();

    /// The first face that origin + t direction (unit vector) meets, at t in (kRayStart_m, farthest_m).
    std::optional<FaceHit> first_hit(const glm::dvec3& origin, const glm::dvec3& direction,
                                     double farthest_m) const;
    /// Whether any face is met.
    bool any_hit(const glm::dvec3& origin, const glm::dvec3& direction, double farthest_m) const;

    /// Phong colour of a face at `point`, seen along the unit vector `direction`: the equations of
    /// keikan/render/shade.hpp without haze. `sun` is the light that arrives there, of which the face may be
    /// in the shade.
    Rgb colour(const FaceHit& hit, const glm::dvec3& point, const glm::dvec3& direction) const;
    /// The colour of the material there, without light on it.
    Rgb albedo(const FaceHit& hit, const glm::dvec3& point) const;

    /// Rays start this far from the water [m], so that rounding does not let them meet what they start from.
    static constexpr double kRayStart_m = 1e-3;

  private:
    struct Hierarchy;
    const Scene& scene_;
    std::unique_ptr<Hierarchy> hierarchy_;
};

/// The sky of the picture's background, seen along a unit vector; without the sun's disc.
Rgb sky_colour(const Background& background, const glm::dvec3& direction);

/// `colour` seen through `distance_m` of haze.
Rgb through_haze(const Haze& haze, Rgb colour, double distance_m);

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>

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

/// A ray that looks for faces.
struct FaceRay {
    glm::dvec3 origin;
    glm::dvec3 direction;  ///< unit vector
    double farthest_m = 0;
};

/// All faces of a scene but those of water, in a hierarchy for rays (Embree 3, robust: no ray slips
/// through the edge between two faces). May be asked from several threads at once.
///
/// Requires: `scene` and `geometry` outlive it.
/// Error:    vertices are rounded to float relative to the camera: 2^-24 of their distance from it.
class FaceRays {
  public:
    FaceRays(const Scene& scene, const Geometry& geometry);
    ~FaceRays();

    /// Of each ray the first face that origin + t direction meets, at t in (kRayStart_m, farthest_m).
    /// hits[i] belongs to rays[i], and depends on nothing else. Requires: both of equal size.
    void first_hits(std::span<const FaceRay> rays, std::span<std::optional<FaceHit>> hits) const;
    std::optional<FaceHit> first_hit(const FaceRay& ray) const;
    /// Whether any face is met.
    bool any_hit(const FaceRay& ray) const;
    /// Of each ray, whether any face is met. Requires: both of equal size.
    void any_hits(std::span<const FaceRay> rays, std::span<std::uint8_t> met) const;

    /// A ray from a face towards the light, which starts as far off the face as it may be displaced by
    /// rounding.
    FaceRay towards_light(const glm::dvec3& point, const glm::dvec3& flat_normal,
                          const glm::dvec3& to_light) const;

    /// Phong colour of a face at `point`, seen along the unit vector `direction`: the equations of
    /// keikan/render/shade.hpp without haze, with this share of the sun.
    Rgb colour(const FaceHit& hit, const glm::dvec3& point, const glm::dvec3& direction,
               float sun_share = 1) const;
    /// The colour of the material there, without light on it.
    Rgb albedo(const FaceHit& hit, const glm::dvec3& point) const;

    /// Rays start this far from the water [m], so that rounding does not let them meet what they start from.
    static constexpr double kRayStart_m = 1e-3;

  private:
    struct Hierarchy;
    const Scene& scene_;
    std::unique_ptr<Hierarchy> hierarchy_;
};

/// The sun's disc, kSunRadius_rad around a unit vector.
class SunDisc {
  public:
    explicit SunDisc(const glm::dvec3& to_sun);

    /// The direction of a point of the disc, for a uniform point of the unit square: uniform on the disc
    /// (Shirley, Chiu 1997).
    glm::dvec3 at(double u1, double u2) const;

  private:
    glm::dvec3 to_sun_, right_, up_;  ///< right_ and up_ reach to the rim
};

inline glm::dvec3 on_sun_disc(const glm::dvec3& to_sun, double u1, double u2) {
    return SunDisc(to_sun).at(u1, u2);
}

/// `colour` seen through `distance_m` of haze.
Rgb through_haze(const Haze& haze, Rgb colour, double distance_m);

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "keikan/scene/water.hpp"
#include "keikan/water/face_rays.hpp"
#include "keikan/water/slopes.hpp"
#include "keikan/wave/water_footprint.hpp"

namespace keikan {

/// The water as one pixel resolves it: waves that are traced, and the slopes of all that is smaller.
struct ResolvedWater {
    WaveSurface waves;
    SlopeCovariance unresolved;
};

/// Two uniform numbers, which choose a slope among the unresolved ones.
struct SlopeChoice {
    double u1 = 0.5;
    double u2 = 0.5;
};

/// What one view ray saw.
struct WaterSample {
    Rgb colour;
    bool missed = false;     ///< no water was met, or no finite colour: our mistake, counted
    std::uint32_t rays = 0;  ///< that were sent into the hierarchy of faces
};

/// The light that comes from water along a view ray.
///
/// The ray is traced to the waves; there, with the slope of the waves and one of the unresolved slopes as
/// they are seen (SeenSlopes), n its unit normal, v the direction to the viewer:
///   R          = fresnel_reflectance(n . v)
///   reflected  = the face that the mirrored ray meets, through haze; or the sky. Where the mirrored ray
///   meets waves
///                again, they reflect once more, up to kBounces times; one that still points down then is
///                turned up
///   glitter    = pi sun F(h . v) density_by_projection(slope of h) / (4 h.z^4), h the unit vector halfway
///   between v
///                and the sun: the sun's reflection integrated over all unresolved slopes; in the shade of a
///                face, 0
///   water      = (1 - R) / n_w^2 (bed T + single scattering), see below
///   colour     = R reflected + glitter + water, through the haze between the viewer and the water
/// `sun` is a white, upright face's radiance, so pi sun is the irradiance of a plane across it.
///
/// In the water, with a and b the coefficients of absorption and scattering, c = a + b, mu_v and mu_s the
/// cosines of the refracted view ray and of the refracted sun, S the way to the bed (a face met below the
/// water, or depth_m / mu_v):
///   T          = exp(-c S)
///   bed        = albedo (sun mu_s_air (1 - F_s) exp(-c d / mu_s) + sky_ambient exp(-c d)), d = S mu_v
///   scattering = b/4 (1 - F_s) sun_s (1 - exp(-c S (1 + mu_v / mu_s))) / (c (1 + mu_v / mu_s)), isotropic,
///   from the sun,
///                and the same from the zenith for sky_ambient
/// Face rays start on the mean plane, where the view ray goes through it: as waves do not move the water's
/// outline, a trough behind the shore must not see the shore from below.
///
/// Property: (1) A function of the arguments alone.
/// Paper:    section 4.1.
class WaterLight {
  public:
    /// Requires: `scene` and `faces` outlive it.
    WaterLight(const Scene& scene, const FaceRays& faces) : scene_(scene), faces_(faces) {}

    /// Requires: a unit direction.
    WaterSample along(const WaterSurface& water, const ResolvedWater& resolved, const ViewRay& ray,
                      SlopeChoice choice) const;

    /// How often light may be mirrored from wave to wave before it leaves.
    static constexpr int kBounces = 3;
    /// Water farther away than this is taken to be this far away [m].
    static constexpr double kFarthest_m = 2e5;

  private:
    Rgb mirrored(const ResolvedWater& resolved, const glm::dvec3& on_wave, const glm::dvec3& on_plane,
                 glm::dvec3 direction, WaterSample& sample) const;
    Rgb out_of_water(const WaterSurface& water, const glm::dvec3& on_plane, const glm::dvec3& normal,
                     const glm::dvec3& towards_viewer, WaterSample& sample) const;
    Rgb glitter(const SeenSlopes& slopes, const glm::dvec3& on_plane, const glm::dvec3& towards_viewer,
                WaterSample& sample) const;

    const Scene& scene_;
    const FaceRays& faces_;
};

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "keikan/scene/sky.hpp"
#include "keikan/scene/water.hpp"
#include "keikan/water/face_rays.hpp"
#include "keikan/water/slopes.hpp"
#include "keikan/wave/near_waves.hpp"
#include "keikan/wave/pixel_sampler.hpp"
#include "keikan/wave/trace_wave.hpp"
#include "keikan/wave/water_footprint.hpp"

namespace keikan {

/// The water as one pixel resolves it: waves that are traced, and the slopes of all that is smaller.
struct ResolvedWater {
    WaveSurface waves;
    SlopeCovariance unresolved;
    /// Rays meet the waves within this [m]; above kTraceError, by NearWaves around the place.
    double meeting_error_m = kTraceError;
    glm::dvec2 place{0, 0};
};

/// Two uniform numbers, which choose one among many.
struct Choice {
    double u1 = 0.5;
    double u2 = 0.5;
};

/// One sample: along which ray the viewer looks (unit direction), which of the unresolved slopes he meets,
/// and from which point of its disc the sun shines.
struct WaterLook {
    ViewRay ray;
    Choice slope;
    Choice sun;
};

/// What one view ray saw.
struct WaterSample {
    Rgb colour;
    bool missed = false;          ///< no water was met, or no finite colour: our mistake, counted
    std::uint16_t face_rays = 0;  ///< that were sent into the hierarchy of faces
    std::uint16_t wave_rays = 0;  ///< that were traced to the waves
    std::uint32_t steps = 0;      ///< of those: how often all waves were evaluated
};

/// The light that comes from water along a view ray.
///
/// The ray is traced to the waves; there, with the slope of the waves and one of the unresolved slopes as
/// they are seen (SeenSlopes), n its unit normal, v the direction to the viewer:
///   R          = fresnel_reflectance(n . v)
///   reflected  = the face that the mirrored ray meets, through haze; or the Sky. Where the mirrored ray
///   meets waves
///                again, they reflect once more, up to kBounces times; one that still points down then is
///                turned up
///   glitter    = pi sun F(h . v) density_by_projection(slope of h) / (4 h.z^4), h the unit vector halfway
///   between v
///                and the sun: the sun's reflection integrated over all unresolved slopes, to whose
///                covariance (kSunRadius_rad / 4)^2 in x and y is added for the width of the disc, so that
///                still water mirrors the sun, too; in the shade of a face, 0
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
/// Unless Light::shadows is Off, a face that is mirrored is lit, and the water is lit, by the point of the
/// sun's disc that the sample chose (Hard: by its middle), if no face is before it; otherwise faces hide the
/// sun from the glitter alone.
///
/// Property: (1) With SlopeOrder::AsGiven, samples[i] is a function of water, resolved and looks[i] alone,
/// the
///               same bits however many looks there are and on any processor; ByRank, of all looks.
/// Paper:    section 4.1.
class WaterLight {
  public:
    struct Way;
    struct alignas(32) Eight {
        float v[8];
    };
    /// What a call needs to keep; one for each thread, so that calls do not allocate.
    struct Memory {
        Memory();
        ~Memory();
        std::vector<Way> ways;
        NearWaves near;
        std::vector<std::uint32_t> active;
        std::vector<WaveRay> wave_rays;
        std::vector<std::optional<WaveMeeting>> meetings;
        std::vector<FaceRay> face_rays, light_rays;
        std::vector<std::optional<FaceHit>> hits;
        std::vector<std::uint8_t> hidden;
        std::vector<std::pair<double, std::uint32_t>> ranks;
        std::vector<Eight> numbers;
    };

    /// Requires: `scene` and `faces` outlive it.
    WaterLight(const Scene& scene, const FaceRays& faces)
        : scene_(scene), sky_(scene.background, scene.light), faces_(faces), disc_(scene.light.to_sun) {}

    /// Requires: unit directions; looks and samples of equal size.
    void along(const WaterSurface& water, const ResolvedWater& resolved, std::span<const WaterLook> looks,
               std::span<WaterSample> samples, Memory& memory, SlopeOrder order = SlopeOrder::AsGiven) const;
    /// One alone.
    WaterSample along(const WaterSurface& water, const ResolvedWater& resolved, const WaterLook& look) const;

    /// How often light may be mirrored from wave to wave before it leaves.
    static constexpr int kBounces = 3;
    /// Water farther away than this is taken to be this far away [m].
    static constexpr double kFarthest_m = 2e5;

  private:
    void meet_waves(const WaterSurface& water, const ResolvedWater& resolved,
                    std::span<const WaterLook> looks, Memory& memory) const;
    static void rank(Memory& memory, SlopeOrder order);
    void mirror_views(const WaterSurface& water, const ResolvedWater& resolved,
                      std::span<const WaterLook> looks, Memory& memory) const;
    void mirror_between_waves(const ResolvedWater& resolved, Memory& memory) const;
    void look_for_faces(Memory& memory) const;
    void look_for_sun(std::span<const WaterLook> looks, Memory& memory) const;
    Rgb mirrored(const Way& way, const Memory& memory) const;
    Rgb out_of_water(const WaterSurface& water, const Way& way, const Memory& memory) const;

    const Scene& scene_;
    Sky sky_;
    const FaceRays& faces_;
    SunDisc disc_;
};

}  // namespace keikan

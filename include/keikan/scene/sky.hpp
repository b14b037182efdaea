// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "keikan/scene/material.hpp"

namespace keikan {

/// Angular radius of the sun as seen from the earth: 0.2666 degrees (mean; it changes by 1.7 % over the
/// year).
inline constexpr double kSunRadius_rad = 0.2666 * 0.017453292519943295;

/// Rec. 709 luminance of linear light.
constexpr float luminance(Rgb c) {
    return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
}

/// Luminance of the CIE Standard Clear Sky beside that of its zenith (CIE S 003-1996, ISO 15469:1997), z the
/// zenith angle of the direction, g its angle to the sun, zs the sun's zenith angle:
///   (0.91 + 10 exp(-3 g) + 0.45 cos^2 g) (1 - exp(-0.32 / cos z))
///   -----------------------------------------------------------------------
///   0.27385 (0.91 + 10 exp(-3 zs) + 0.45 cos^2 zs)
/// At the zenith it is 1 but for the rounding of 0.27385 = 1 - exp(-0.32) (within 5e-6).
///
/// Requires: unit vectors. A direction below the horizon has the value of the horizon below it: cos z is 0.
double cie_clear_sky(const glm::dvec3& direction, const glm::dvec3& to_sun);

/// The light that comes from where no face is, without the sun's disc.
class Sky {
  public:
    Sky(const Background& background, const Light& light);

    /// Seen along a unit vector:
    ///   SkyModel::Gradient  from `horizon` (at and below it) to `zenith`, linear in the sine of the
    ///   elevation SkyModel::CieClear  the hue of that gradient, with the luminance of `zenith` times
    ///   cie_clear_sky
    Rgb colour(const glm::dvec3& direction) const;

    /// The same with the sun's disc, if the background shows it: the share of the disc that a round pixel of
    /// this angular diameter sees, times pi sun / (solid angle of the disc), so that the disc's irradiance is
    /// that of Light::sun.
    Rgb colour_with_sun(const glm::dvec3& direction, double pixel_rad) const;

  private:
    Background background_;
    glm::dvec3 to_sun_;
    Rgb disc_;                         ///< radiance of the sun's disc
    double per_zenith_luminance_ = 1;  ///< what is left of cie_clear_sky when the sun alone is known
};

}  // namespace keikan

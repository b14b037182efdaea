// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/scene/water.hpp"

namespace keikan {

/// Light that is weaker than this share of what it adds to is not followed: an eighth of a code of 8 bits.
inline constexpr double kFaint = 1.0 / 2048;

/// A view ray that goes on into the water.
struct InWater {
    double share = 0;  ///< of the light that comes up along it, what the viewer sees; 0: not worth following
    glm::dvec3 down{0, 0, -1};  ///< unit vector
    double mu_v = 1;            ///< its cosine to the vertical
    double visible_m = 0;       ///< how far any of its light could be seen
};

/// The view ray that is refracted to `down` (unit vector); `transmitted` is the share that is not mirrored.
InWater into_water(const WaterSurface& water, const glm::dvec3& down, double transmitted);

/// Where the ray ends.
struct Bed {
    double way_m = 0;  ///< may be infinite
    Rgb albedo;
};

/// Radiance that comes up along the refracted ray, inside the water: keikan/water/water_light.hpp, "In the
/// water".
Rgb light_from_water(const WaterSurface& water, const InWater& ray, const Bed& bed, Rgb sun, Rgb sky_ambient,
                     double sun_z);

}  // namespace keikan

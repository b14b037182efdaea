// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "keikan/image/image.hpp"

namespace keikan {

/// Colours of a terrain by height, and by slope where it is steep.
struct HeightSlopeRamp {
    struct Stop {
        float height_m;
        Rgb colour;
    };
    std::vector<Stop> stops;        ///< rising heights; linear between, constant beyond
    Rgb steep{0.3f, 0.28f, 0.26f};  ///< bare rock
    float steep_from_deg = 35;      ///< blends from the height's colour ...
    float steep_full_deg = 50;      ///< ... to `steep`

    /// Linear between the stops around it.
    Rgb colour_at(float height_m) const;
    /// How much of `steep` shows on a plane whose unit normal has this z, of either side: 0 to 1, linear in
    /// the slope angle.
    float steep_share(float normal_z) const;
};

inline Rgb mixed(Rgb from, Rgb to, float share) {
    return (1 - share) * from + share * to;
}

/// Phong reflection in linear light: ambient * albedo + sun * (diffuse * albedo * cos + specular *
/// cos^exponent).
struct Material {
    std::string name;
    Rgb colour{0.5f, 0.5f, 0.5f};  ///< albedo
    float diffuse = 1;
    float specular = 0;
    float exponent = 10;
    std::optional<HeightSlopeRamp> ramp;  ///< replaces `colour`
};

/// Whether faces hide the sun from one another, and from water.
enum class Shadows {
    Off,
    Hard,  ///< the sun is the middle of its disc
    Soft,  ///< the sun is a disc, of its true size: shadows have penumbras
};

/// The lights of the scene, all in linear light.
struct Light {
    glm::dvec3 to_sun{0, 0, 1};  ///< unit vector
    Rgb sun{1, 1, 1};
    Shadows shadows = Shadows::Off;
    Rgb sky_ambient{0.3f, 0.35f, 0.45f};     ///< on faces that look up; blends by the normal's z ...
    Rgb ground_ambient{0.12f, 0.11f, 0.1f};  ///< ... to this on faces that look down
};

enum class SkyModel {
    Gradient,  ///< over the elevation alone
    CieClear,  ///< the CIE Standard Clear Sky around the sun
};

/// The sky behind everything (keikan/scene/sky.hpp).
struct Background {
    SkyModel model = SkyModel::Gradient;
    bool sun_disc = false;  ///< the sun itself is seen
    Rgb zenith{0.2f, 0.38f, 0.75f};
    Rgb horizon{0.75f, 0.83f, 0.92f};
};

/// Distance haze: a fraction 1 - exp(-distance / range_m) of what is seen becomes `colour`.
struct Haze {
    Rgb colour{0.7f, 0.78f, 0.88f};
    double range_m = 0;  ///< 0: none
};

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

// What many samples of water compute alike, many at once, compiled once for every vector width. Plain data
// only, as wave/trace_lanes.hpp. Lists of floats are padded to kPadding of them and aligned to as many.
namespace keikan::lanes {

inline constexpr std::size_t kPadding = 8;

/// Where views are mirrored and refracted. For each sample: the slope of the waves, the unit vector towards
/// the viewer, and two uniform numbers, for which a slope that is not resolved is drawn (SeenSlopes).
struct MirrorJob {
    std::size_t count;
    const float *slope_x, *slope_y, *view_x, *view_y, *view_z, *u1, *u2;
    float xx, xy, yy;           ///< covariance of the slopes that are not resolved
    float disc;                 ///< what the sun's disc adds to xx and yy for the glitter
    float sun_x, sun_y, sun_z;  ///< unit vector; z <= 0: no glitter
    // Results.
    float* direction[3];  ///< of the mirrored ray, unit vector
    float* reflectance;
    float* glitter;  ///< WaterLight: pi F density / (4 h.z^4)
    float* down[3];  ///< of the refracted ray, unit vector
};

void mirror_with_any_processor(const MirrorJob& job);
void mirror_with_avx2(const MirrorJob& job);

}  // namespace keikan::lanes

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

// The inner loop of NearWaves, compiled once for every vector width. Plain data only, as trace_lanes.hpp.
namespace keikan::lanes {

/// One wave near a place: theta / 2 pi = turns_x x + turns_y y + turns_0, x and y from the place, c = cos
/// theta,
///   height             = height[0] c + height[1] c^2 + height[2] c^3 (the constant is in NearJob::level)
///   d height / d theta = sin theta (by_theta[0] + by_theta[1] c + by_theta[2] c^2)
struct NearWave {
    float turns_x, turns_y, turns_0;
    float height[3];
    float by_theta[3];
};

/// What is left of a bound after some of the waves, the longest: their number, what is to be added to the
/// height above those, and their curvature along a direction, xx dx^2 + 2 xy dx dy + yy dy^2.
struct NearPrefix {
    int waves;
    float level;
    float xx, xy, yy;
};

struct NearRay {
    float origin[3];
    float direction[3];
    float t_max;
};

struct NearHit {
    float t;
    float slope[2];
    int steps;
    bool met;
};

struct NearJob {
    const NearWave* waves;       ///< from the longest to the shortest
    const NearPrefix* prefixes;  ///< from no wave to all of them, at least these two where there are waves
    int prefix_count;
    float error;       ///< [m]
    float rate_error;  ///< of d height / dx and d height / dy together
    const NearRay* rays;
    std::size_t ray_count;
    NearHit* hits;  ///< one for each ray
};

/// As trace_with_...: the same bits for every vector width and whatever else is in the job.
void trace_near_with_any_processor(const NearJob& job);
void trace_near_with_avx2(const NearJob& job);

}  // namespace keikan::lanes

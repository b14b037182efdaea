// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "keikan/wave/wave_series.hpp"

// The inner loop of trace_waves, compiled once for every vector width. Plain data only: a source that is
// compiled for newer processors must not leave behind inline functions that others share.
namespace keikan::lanes {

struct Ray {
    double origin[3];
    double direction[3];
    double t_max;
};

struct Hit {
    double t;
    double slope[2];
    int steps;
    bool met;
};

struct Job {
    const WaveSeries* waves;  ///< from the longest to the shortest
    std::size_t wave_count;
    double crest_m;      ///< the sum of the waves'
    double trace_error;  ///< [m]
    const Ray* rays;
    std::size_t ray_count;
    Hit* hits;  ///< one for each ray
};

/// Each lane follows a ray; a lane that is done takes the next one. A ray's hit depends on nothing but
/// itself, and has the same bits for every vector width: + - * / and sqrt only.
void trace_with_any_processor(const Job& job);
void trace_with_avx2(const Job& job);  ///< where the processor has it; elsewhere not linked

/// The sums over all waves at (x, y): height, and slope along x and y.
struct Sums {
    double height, slope[2];
};
Sums sums_at(const WaveSeries* waves, std::size_t wave_count, double x, double y);

}  // namespace keikan::lanes

// SPDX-License-Identifier: Apache-2.0
#define KEIKAN_LANE_BYTES 16
#include "trace_lanes.inc"
#include "near_lanes.inc"

namespace keikan::lanes {

void trace_with_any_processor(const Job& job) {
    trace(job);
}

void trace_near_with_any_processor(const NearJob& job) {
    trace_near(job);
}

Sums sums_at(const WaveSeries* waves, std::size_t wave_count, double x, double y) {
    Sums sums{0, {0, 0}};
    for (std::size_t i = 0; i < wave_count; ++i) {
        const WaveSeries& w = waves[i];
        const SineCosine<double> s = sine_of_turns(w.turns_x * x + w.turns_y * y + w.turns_0);
        const double c = s.cosine;
        sums.height +=
            ((((w.height[5] * c + w.height[4]) * c + w.height[3]) * c + w.height[2]) * c + w.height[1]) * c +
            w.height[0];
        const double by_theta =
            s.sine * ((((w.by_theta[4] * c + w.by_theta[3]) * c + w.by_theta[2]) * c + w.by_theta[1]) * c +
                      w.by_theta[0]);
        sums.slope[0] += kTurn * w.turns_x * by_theta;
        sums.slope[1] += kTurn * w.turns_y * by_theta;
    }
    return sums;
}

}  // namespace keikan::lanes

// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/trace_wave.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "keikan/support/check.hpp"
#include "trace_lanes.hpp"

namespace keikan {

namespace {

using Trace = void (*)(const lanes::Job&);

Trace for_this_processor() {
#ifdef KEIKAN_HAS_AVX2_SOURCE
    if (__builtin_cpu_supports("avx2")) return lanes::trace_with_avx2;
#endif
    return lanes::trace_with_any_processor;
}

lanes::Ray plain(const WaveRay& ray) {
    KEIKAN_CHECK(std::isfinite(ray.t_max), "a ray without an end");
    return {{ray.origin.x, ray.origin.y, ray.origin.z},
            {ray.direction.x, ray.direction.y, ray.direction.z},
            ray.t_max};
}

}  // namespace

void trace_waves(const WaveSurface& water, std::span<const WaveRay> rays,
                 std::span<std::optional<WaveMeeting>> meetings) {
    KEIKAN_CHECK(rays.size() == meetings.size(), rays.size() << " rays, " << meetings.size() << " meetings");
    static const Trace trace = for_this_processor();
    constexpr std::size_t kTogether = 64;  // on the stack
    std::array<lanes::Ray, kTogether> plain_rays;
    std::array<lanes::Hit, kTogether> hits;
    const std::span<const WaveSeries> waves = water.series();
    for (std::size_t begin = 0; begin < rays.size(); begin += kTogether) {
        const std::size_t count = std::min(kTogether, rays.size() - begin);
        for (std::size_t i = 0; i < count; ++i) plain_rays[i] = plain(rays[begin + i]);
        trace({waves.data(), waves.size(), water.crest_bound_m(), kTraceError, plain_rays.data(), count,
               hits.data()});
        for (std::size_t i = 0; i < count; ++i) {
            const lanes::Hit& hit = hits[i];
            meetings[begin + i].reset();
            if (hit.met) meetings[begin + i] = WaveMeeting{hit.t, {hit.slope[0], hit.slope[1]}, hit.steps};
        }
    }
}

std::optional<WaveMeeting> trace_wave(const WaveSurface& water, const glm::dvec3& origin,
                                      const glm::dvec3& direction, double t_max) {
    const WaveRay ray{origin, direction, t_max};
    std::optional<WaveMeeting> meeting;
    trace_waves(water, std::span(&ray, 1), std::span(&meeting, 1));
    return meeting;
}

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "keikan/wave/trace_wave.hpp"

namespace keikan {

/// The waves of a surface near one place, for many short rays that need no more than a stated accuracy: those
/// of a pixel. They are followed in single precision, from phases that are worked out at the place in double.
///
/// Properties, E = error_m():
///   (1) At the meeting, the ray's height above the water is at most E.
///   (2) Before it, no point of the ray is below the water by more than E: no crest is stepped through.
///   (3) A ray that starts on the surface (within E/4, as a meeting is) and rises from it leaves it; one that
///       starts below it by E or more meets it at 0.
///   (4) A ray's meeting depends on the waves, the place, E and the ray alone: the same bits for any number
///   of
///       rays and on any processor.
/// Requires: as trace_wave.
/// Why (2):  the steps are trace_wave's, with the bounds lowered by what rounding may make of them. A height
/// is
///           within e = 2^-24 (16 R S + 128 H) of the true one, S the sum of the waves' largest slopes along
///           x and y, H that of their crests, R the larger of |x| and |y| from the place; harmonics that are
///           left out count for at most E/8. A ray for which e could be more than E/8 is followed by
///           trace_waves, E/2 higher. A step ends where the bound is at most E 3/4 below the water.
/// Cost:     a fifth of trace_waves' for each step, and fewer steps.
class NearWaves {
  public:
    /// `error_m`: E; at kTraceError or below everything is left to trace_waves. Does not allocate when as
    /// many waves were set before. Requires: `waves` outlives its use.
    void set(const WaveSurface& waves, glm::dvec2 place, double error_m);

    double error_m() const { return error_m_; }

    /// meetings[i] is that of rays[i]. Requires: both of equal size; one call at a time.
    void trace(std::span<const WaveRay> rays, std::span<std::optional<WaveMeeting>> meetings);

    struct Lists;

    NearWaves();
    ~NearWaves();
    NearWaves(NearWaves&&) noexcept;
    NearWaves& operator=(NearWaves&&) noexcept;

  private:
    std::unique_ptr<Lists> lists_;
    double error_m_ = kTraceError;
};

}  // namespace keikan

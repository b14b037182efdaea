// SPDX-License-Identifier: Apache-2.0
// Compiled for processors with AVX2 (CMakeLists.txt); trace_waves asks the processor before it comes here.
#define KEIKAN_LANE_BYTES 32
#include "near_lanes.inc"
#include "trace_lanes.inc"

namespace keikan::lanes {

void trace_with_avx2(const Job& job) {
    trace(job);
}

void trace_near_with_avx2(const NearJob& job) {
    trace_near(job);
}

}  // namespace keikan::lanes

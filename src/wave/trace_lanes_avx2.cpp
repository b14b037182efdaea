// SPDX-License-Identifier: Apache-2.0
// Compiled for processors with AVX2 (CMakeLists.txt); trace_waves asks the processor before it comes here.
#define KEIKAN_LANE_BYTES 32
#include "trace_lanes.inc"

namespace keikan::lanes {

void trace_with_avx2(const Job& job) {
    trace(job);
}

}  // namespace keikan::lanes

// SPDX-License-Identifier: Apache-2.0
// Compiled for processors with AVX2 (CMakeLists.txt); WaterLight asks the processor before it comes here.
#define KEIKAN_LANE_BYTES 32
#include "light_lanes.inc"

namespace keikan::lanes {

void mirror_with_avx2(const MirrorJob& job) {
    mirror(job);
}

}  // namespace keikan::lanes

// SPDX-License-Identifier: Apache-2.0
#define KEIKAN_LANE_BYTES 16
#include "light_lanes.inc"

namespace keikan::lanes {

void mirror_with_any_processor(const MirrorJob& job) {
    mirror(job);
}

}  // namespace keikan::lanes

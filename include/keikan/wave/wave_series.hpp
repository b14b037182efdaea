// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace keikan {

/// One wave as it is evaluated: theta / 2 pi = turns_x x + turns_y y + turns_0, c = cos theta, and
///   height             = height[0] + height[1] c + ... + height[5] c^5
///   d height / d theta = sin theta (by_theta[0] + by_theta[1] c + ... + by_theta[4] c^4)
/// Plain data: loops over it are compiled for several processors.
struct WaveSeries {
    double turns_x = 0, turns_y = 0, turns_0 = 0;
    double height[6] = {};
    double by_theta[5] = {};
    double crest_m = 0;   ///< |height| is at most this
    double second_m = 0;  ///< |d2 height / d theta2| is at most this
};

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>

#include "edge_moments.hpp"
#include "keikan/scan/scan_band.hpp"

namespace keikan {

/// A smaller share of a pixel is left out: rounding leaves as much of a face that only touches the pixel.
/// What is lost is a fifth of kVisibleAreaError.
inline constexpr double kLeastShare = 4 * 0x1p-53;

/// The part of a face that shows a region with these moments. Rounding may have moved a centroid just
/// outside of the pixel, and the area beyond 1. Requires: moments.area > kLeastShare.
inline SeenPart part_with(std::uint32_t face, const Moments& moments) {
    const auto within = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); };
    return {face, within(moments.x / moments.area), within(moments.y / moments.area),
            std::min(moments.area, 1.0)};
}

}  // namespace keikan

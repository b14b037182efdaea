// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "keikan/scan/scan_band.hpp"

namespace keikan {

/// What makes a band unfit for shading, or nothing. Looks at every index and number:
///   (1) each pixel of each row is in exactly one span or divided pixel, by rising x;
///   (2) spans and parts name faces of the band (spans also the background), divided pixels name parts;
///   (3) weights lie in (0, 1], backgrounds and centroids in [0, 1], and a pixel's weights with its
///       background add up to 1 within kWeightSumSlack;
///   (4) planes, normals and positions are finite.
/// Requires: span_begin and divided_begin have rows + 1 values.
std::optional<std::string> what_is_wrong(const ScanBand& band, int width);

/// Crowded pixels are off by 1e-13; a number that is not an area at all, by more than this.
inline constexpr double kWeightSumSlack = 1e-9;

}  // namespace keikan

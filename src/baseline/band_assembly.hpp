// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "keikan/baseline/faces_in_view.hpp"
#include "keikan/scan/band_builder.hpp"

namespace keikan::baseline {

/// The band so far, into `band`, with what shading must know of its faces.
void finish_band(BandBuilder& builder, const FacesInView& view, ScanBand& band);

/// Looks at water in the middle of a stretch of the row y of pixels, once in each pixel that it reaches into;
/// a whole pixel's stretch weighs `weight`.
void look_at_water(const Point& begin, double end_x, double weight, std::uint16_t object,
                   std::vector<WaterPoint>& water, int width);

}  // namespace keikan::baseline

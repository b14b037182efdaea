// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "keikan/baseline/faces_in_view.hpp"
#include "keikan/scan/band_builder.hpp"
#include "visible_stretches.hpp"

namespace keikan::baseline {

/// The band so far, into `band`, with what shading must know of its faces.
void finish_band(BandBuilder& builder, const FacesInView& view, ScanBand& band);

/// Looks at the water that is seen along the level line at `y` (image coordinates): in the middle of each
/// stretch of one water object, once in each pixel that it reaches into. A whole pixel's stretch weighs
/// `weight`.
void look_at_water(std::span<const Stretch> seen, double y, double weight, const FacesInView& view,
                   std::vector<WaterPoint>& water);

/// Makers that own a `Method`, made from these arguments, each.
template <typename Method, typename... Arguments>
std::function<BandMaker()> makers_of(const Arguments&... arguments) {
    return [=]() -> BandMaker {
        return [method = std::make_shared<Method>(arguments...)](BandRows rows, ScanBand& band,
                                                                 std::vector<WaterPoint>& water) {
            (*method)(rows, band, water);
        };
    };
}

}  // namespace keikan::baseline

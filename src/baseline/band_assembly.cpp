// SPDX-License-Identifier: Apache-2.0
#include "band_assembly.hpp"

#include <algorithm>
#include <cmath>

#include "keikan/scan/seen_face.hpp"

namespace keikan::baseline {

void finish_band(BandBuilder& builder, const FacesInView& view, ScanBand& band) {
    band.faces.clear();
    for (const std::uint32_t f : builder.seen())
        band.faces.push_back(seen_face(view.faces(), f, view.geometry(), view.object(f), view.camera()));
    builder.finish(band);
}

void look_at_water(const Point& begin, double end_x, double weight, std::uint16_t object,
                   std::vector<WaterPoint>& water, int width) {
    const int y = static_cast<int>(begin.y);
    const int first = static_cast<int>(begin.x);
    const int last = std::min(static_cast<int>(std::ceil(end_x)) - 1, width - 1);
    for (int x = first; x <= last; ++x) {
        const double from = x == first ? begin.x - x : 0, to = x == last ? end_x - x : 1;
        water.push_back({x, y, object, {(from + to) / 2, begin.y - y}, weight * (to - from)});
    }
}

}  // namespace keikan::baseline

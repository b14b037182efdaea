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

void look_at_water(std::span<const Stretch> seen, double y, double weight, const FacesInView& view,
                   std::vector<WaterPoint>& water) {
    const int row = static_cast<int>(y);
    for (std::size_t i = 0; i < seen.size();) {
        Stretch s = seen[i++];
        if (!view.is_water(s.face)) continue;
        const std::uint16_t object = view.object(s.face);
        for (; i < seen.size() && seen[i].begin == s.end && view.object(seen[i].face) == object; ++i)
            s.end = seen[i].end;
        const int first = static_cast<int>(s.begin);
        const int last = std::min(static_cast<int>(std::ceil(s.end)) - 1, view.camera().size.width - 1);
        for (int x = first; x <= last; ++x) {
            const double from = x == first ? s.begin - x : 0, to = x == last ? s.end - x : 1;
            water.push_back({x, row, object, {(from + to) / 2, y - row}, weight * (to - from)});
        }
    }
}

}  // namespace keikan::baseline

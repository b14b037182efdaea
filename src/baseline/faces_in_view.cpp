// SPDX-License-Identifier: Apache-2.0
#include "keikan/baseline/faces_in_view.hpp"

#include <algorithm>
#include <cmath>

#include "keikan/support/parallel.hpp"

namespace keikan::baseline {

namespace {

/// Bands [first, end) that a face meets.
struct BandRange {
    int first = 0;
    int end = 0;
};

BandRange bands_met(std::span<const Point> outline, ImageSize size) {
    double left = outline[0].x, right = left, top = outline[0].y, bottom = top;
    for (const Point p : outline) {
        left = std::min(left, p.x), right = std::max(right, p.x);
        top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    }
    if (!(right > 0 && left < size.width && bottom > 0 && top < size.height)) return {};
    const int first = static_cast<int>(std::max(top, 0.0)) / kBandRows;
    const int last = static_cast<int>(std::min(bottom, size.height - 1.0)) / kBandRows;
    return {first, last + 1};
}

}  // namespace

FacesInView::FacesInView(const Geometry& geometry, const ProjectedFaces& faces, const Camera& camera)
    : geometry_(geometry), faces_(faces), camera_(camera), object_(faces.size()) {
    std::vector<BandRange> met(faces.size());
    parallel_ranges(faces.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const auto next = std::ranges::upper_bound(geometry.first_face, faces.id[f]);
            object_[f] = static_cast<std::uint16_t>(next - geometry.first_face.begin() - 1);
            met[f] = bands_met(faces[f].outline, camera.size);
        }
    });
    const auto bands = static_cast<std::size_t>((camera.size.height + kBandRows - 1) / kBandRows);
    begin_.assign(bands + 1, 0);
    for (const BandRange range : met)
        for (int b = range.first; b < range.end; ++b) ++begin_[static_cast<std::size_t>(b) + 1];
    for (std::size_t b = 0; b < bands; ++b) begin_[b + 1] += begin_[b];
    in_band_.resize(begin_.back());
    std::vector<std::uint32_t> place(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t f = 0; f < met.size(); ++f)
        for (int b = met[f].first; b < met[f].end; ++b) in_band_[place[static_cast<std::size_t>(b)]++] = f;
}

std::span<const std::uint32_t> FacesInView::of_band(int first_row) const {
    const auto b = static_cast<std::size_t>(first_row / kBandRows);
    return std::span(in_band_).subspan(begin_[b], begin_[b + 1] - begin_[b]);
}

}  // namespace keikan::baseline

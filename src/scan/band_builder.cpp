// SPDX-License-Identifier: Apache-2.0
#include "keikan/scan/band_builder.hpp"

namespace keikan {

void BandBuilder::begin(int first_row, int rows) {
    first_row_ = first_row;
    rows_ = rows;
    if (const auto n = static_cast<std::size_t>(rows); spans_.size() < n) {
        spans_.resize(n);
        divided_.resize(n);
    }
}

void BandBuilder::add_span(int row, int x_begin, int x_end, std::uint32_t face) {
    const std::uint32_t number = face == kBackground ? Span::kBackground : band_index(face);
    std::vector<Span>& spans = spans_[static_cast<std::size_t>(row)];
    if (!spans.empty() && spans.back().x_end == x_begin && spans.back().face == number)
        spans.back().x_end = x_end;
    else
        spans.push_back({x_begin, x_end, number});
}

void BandBuilder::add_divided(int row, int x, Division division, std::span<const SeenPart> parts,
                              double background) {
    const auto begin = static_cast<std::uint32_t>(parts_.size());
    for (SeenPart part : parts) {
        part.face = band_index(part.face);
        parts_.push_back(part);
    }
    divided_[static_cast<std::size_t>(row)].push_back(
        {x, division, begin, static_cast<std::uint32_t>(parts_.size()), background});
}

void BandBuilder::finish(ScanBand& band) {
    band.first_row = first_row_;
    band.rows = rows_;
    band.spans.clear();
    band.span_begin.assign(1, 0);
    band.divided.clear();
    band.divided_begin.assign(1, 0);
    band.parts.clear();
    band.parts.reserve(parts_.size());
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows_); ++row) {
        band.spans.insert(band.spans.end(), spans_[row].begin(), spans_[row].end());
        band.span_begin.push_back(static_cast<std::uint32_t>(band.spans.size()));
        for (DividedPixel pixel : divided_[row]) {
            const auto begin = static_cast<std::uint32_t>(band.parts.size());
            band.parts.insert(band.parts.end(), parts_.begin() + pixel.part_begin,
                              parts_.begin() + pixel.part_end);
            pixel.part_begin = begin;
            pixel.part_end = static_cast<std::uint32_t>(band.parts.size());
            band.divided.push_back(pixel);
        }
        band.divided_begin.push_back(static_cast<std::uint32_t>(band.divided.size()));
        spans_[row].clear();
        divided_[row].clear();
    }
    for (const std::uint32_t face : seen_) band_index_[face] = kUnseen;
    seen_.clear();
    parts_.clear();
}

}  // namespace keikan

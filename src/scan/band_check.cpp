// SPDX-License-Identifier: Apache-2.0
#include "band_check.hpp"

#include <cmath>

namespace keikan {
namespace {

bool rises_to(const std::vector<std::uint32_t>& begin, std::size_t end) {
    if (begin.front() != 0 || begin.back() != end) return false;
    for (std::size_t i = 1; i < begin.size(); ++i)
        if (begin[i] < begin[i - 1]) return false;
    return true;
}

bool finite(const SeenFace& face) {
    // A sum is finite only if its terms are; the terms are halved so that it does not overflow by itself.
    double sum = 0x1p-8 * face.plane.a + 0x1p-8 * face.plane.b + 0x1p-8 * face.plane.c +
                 0x1p-8 * face.normal_at.x + 0x1p-8 * face.normal_at.y;
    for (const auto& row : face.normal)
        for (const float v : row) sum += 0x1p-8 * v;
    for (const float v : face.flat_normal) sum += 0x1p-8 * v;
    return std::isfinite(sum);
}

/// Whether the spans and divided pixels of one row, by rising x, divide [0, width).
bool covers_row(const ScanBand& band, std::size_t row, int width) {
    std::uint32_t span = band.span_begin[row], divided = band.divided_begin[row];
    std::int32_t x = 0;
    while (x < width) {
        if (span < band.span_begin[row + 1] && band.spans[span].x_begin == x) {
            if (band.spans[span].x_end <= x || band.spans[span].x_end > width) return false;
            x = band.spans[span++].x_end;
        } else if (divided < band.divided_begin[row + 1] && band.divided[divided].x == x) {
            ++divided;
            ++x;
        } else {
            return false;
        }
    }
    return span == band.span_begin[row + 1] && divided == band.divided_begin[row + 1];
}

bool is_fraction(double v) {
    return v >= 0 && v <= 1;
}  // false for NaN

}  // namespace

std::optional<std::string> what_is_wrong(const ScanBand& band, int width) {
    if (!rises_to(band.span_begin, band.spans.size()) || !rises_to(band.divided_begin, band.divided.size()))
        return "the rows do not share out the spans and divided pixels";
    for (std::size_t row = 0; row + 1 < band.span_begin.size(); ++row)
        if (!covers_row(band, row, width))
            return "row " + std::to_string(band.first_row + static_cast<int>(row)) +
                   " is not covered once by its spans and divided pixels";
    for (const Span& span : band.spans)
        if (span.face != Span::kBackground && span.face >= band.faces.size())
            return "a span names a face that is not there";
    std::uint32_t next_part = 0;
    for (const DividedPixel& pixel : band.divided) {
        if (pixel.part_begin != next_part || pixel.part_end <= pixel.part_begin ||
            pixel.part_end > band.parts.size())
            return "a divided pixel names parts that are not its own";
        next_part = pixel.part_end;
        if (!is_fraction(pixel.background)) return "a background is no fraction of the pixel";
        double sum = pixel.background;
        for (std::uint32_t p = pixel.part_begin; p < pixel.part_end; ++p) {
            const SeenPart& part = band.parts[p];
            if (part.face >= band.faces.size()) return "a part names a face that is not there";
            if (!(part.weight > 0 && part.weight <= 1)) return "a weight is no fraction of the pixel";
            if (!is_fraction(part.x) || !is_fraction(part.y)) return "a centroid lies outside its pixel";
            sum += part.weight;
        }
        if (!(std::abs(sum - 1) <= kWeightSumSlack)) return "the weights of a pixel do not add up to 1";
    }
    if (next_part != band.parts.size()) return "there are parts without a pixel";
    for (const SeenFace& face : band.faces)
        if (!finite(face)) return "a face holds a number that is not finite";
    return std::nullopt;
}

}  // namespace keikan

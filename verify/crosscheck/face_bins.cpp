// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_bins.hpp"

#include <algorithm>
#include <cmath>

namespace keikan::crosscheck {
namespace {

/// Pixels [begin, end) of a side of `length` pixels whose open interval meets (low, high).
struct Range {
    std::int32_t begin = 0;
    std::int32_t end = 0;
};

Range pixels_between(double low, double high, int length) {
    const double last = length;
    return {static_cast<std::int32_t>(std::clamp(std::floor(low), 0.0, last)),
            static_cast<std::int32_t>(std::clamp(std::ceil(high), 0.0, last))};
}

}  // namespace

FaceBins::FaceBins(const ProjectedFaces& faces, ImageSize size) : size_(size), columns_(faces.size()) {
    std::vector<Range> rows(faces.size());
    row_begin_.assign(static_cast<std::size_t>(size.height) + 1, 0);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const auto outline = faces[i].outline;
        if (outline.empty()) continue;
        const auto [left, right] = std::ranges::minmax(outline, {}, &Point::x);
        const auto [top, bottom] = std::ranges::minmax(outline, {}, &Point::y);
        const Range columns = pixels_between(left.x, right.x, size.width);
        columns_[i] = {columns.begin, columns.end};
        if (columns.begin < columns.end) rows[i] = pixels_between(top.y, bottom.y, size.height);
        for (auto y = rows[i].begin; y < rows[i].end; ++y) ++row_begin_[static_cast<std::size_t>(y) + 1];
    }
    for (std::size_t y = 1; y < row_begin_.size(); ++y) row_begin_[y] += row_begin_[y - 1];
    row_face_.resize(row_begin_.back());
    std::vector<std::size_t> next(row_begin_.begin(), row_begin_.end() - 1);
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (auto y = rows[i].begin; y < rows[i].end; ++y)
            row_face_[next[static_cast<std::size_t>(y)]++] = static_cast<std::uint32_t>(i);
}

FaceBins::Row FaceBins::row(int y) const {
    const auto at = static_cast<std::size_t>(y);
    const auto faces = std::span(row_face_).subspan(row_begin_[at], row_begin_[at + 1] - row_begin_[at]);
    Row result;
    result.begin.assign(static_cast<std::size_t>(size_.width) + 1, 0);
    for (const std::uint32_t face : faces)
        for (auto x = columns_[face].begin; x < columns_[face].end; ++x)
            ++result.begin[static_cast<std::size_t>(x) + 1];
    for (std::size_t x = 1; x < result.begin.size(); ++x) result.begin[x] += result.begin[x - 1];
    result.face.resize(result.begin.back());
    std::vector<std::uint32_t> next(result.begin.begin(), result.begin.end() - 1);
    for (const std::uint32_t face : faces)
        for (auto x = columns_[face].begin; x < columns_[face].end; ++x)
            result.face[next[static_cast<std::size_t>(x)]++] = face;
    return result;
}

}  // namespace keikan::crosscheck

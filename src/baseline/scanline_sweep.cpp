// SPDX-License-Identifier: Apache-2.0
#include "scanline_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace keikan::baseline {

namespace {

std::size_t next_corner(std::size_t corner, std::size_t corners, bool forwards) {
    if (forwards) return corner + 1 < corners ? corner + 1 : 0;
    return corner > 0 ? corner - 1 : corners - 1;
}

/// The first line at or below `y`, at most `count`.
int first_line_from(const Scanlines& lines, double y) {
    const double guess = y * lines.per_row - lines.offset - static_cast<double>(lines.first);
    if (!(guess > 0)) return 0;
    if (guess >= lines.count) return lines.count;
    int k = static_cast<int>(guess);
    while (k > 0 && lines.y(k - 1) >= y) --k;
    while (k < lines.count && lines.y(k) < y) ++k;
    return k;
}

}  // namespace

void ScanlineSweep::sort_by_first_line(std::span<const std::uint32_t> faces, const Scanlines& lines) {
    const auto count = static_cast<std::size_t>(lines.count);
    first_line_.resize(faces.size());
    first_line_begin_.assign(count + 2, 0);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const auto outline = faces_[faces[i]].outline;
        double top = outline[0].y, bottom = top;
        for (const Point p : outline) top = std::min(top, p.y), bottom = std::max(bottom, p.y);
        int first = first_line_from(lines, top);
        if (first < lines.count && !(lines.y(first) < bottom)) first = lines.count;  // between two lines
        first_line_[i] = static_cast<std::uint32_t>(first);
        ++first_line_begin_[static_cast<std::size_t>(first) + 1];
    }
    for (std::size_t k = 0; k <= count; ++k) first_line_begin_[k + 1] += first_line_begin_[k];
    by_first_line_.resize(faces.size());
    for (std::size_t i = faces.size(); i-- > 0;)
        by_first_line_[--first_line_begin_[first_line_[i] + 1]] = faces[i];
    // The ends have moved down to the begins, one place on.
    first_line_begin_.erase(first_line_begin_.begin());
    first_line_begin_.push_back(static_cast<std::uint32_t>(faces.size()));
}

/// On to the edge that the line crosses. Requires: the line is above the face's bottom.
void ScanlineSweep::go_down(Side& side, std::span<const Point> outline, bool forwards, double line) const {
    if (line < side.bottom) return;
    std::size_t from = side.corner, to = from;
    while (!(line < outline[to].y)) {
        from = to;
        to = next_corner(from, outline.size(), forwards);
    }
    const Point p = outline[from], q = outline[to];
    side = {p.x, p.y, (q.x - p.x) / (q.y - p.y), q.y, static_cast<std::uint32_t>(to)};
}

void ScanlineSweep::cross(Active& active, double line) const {
    const FaceView face = faces_[active.face];
    go_down(active.one, face.outline, true, line);
    go_down(active.other, face.outline, false, line);
    const double x = active.one.at(line), x2 = active.other.at(line);
    active.crossed.begin = std::min(x, x2);
    active.crossed.end = std::max(x, x2);
    active.crossed.start = face.depth.b * line + face.depth.c;
}

std::uint32_t ScanlineSweep::activate(std::uint32_t face, double line) {
    if (free_.empty()) {
        free_.push_back(static_cast<std::uint32_t>(active_.size()));
        active_.emplace_back();
    }
    const std::uint32_t place = free_.back();
    free_.pop_back();
    Active& active = active_[place];
    const auto outline = faces_[face].outline;
    const auto [top, bottom] =
        std::minmax_element(outline.begin(), outline.end(), [](Point p, Point q) { return p.y < q.y; });
    active.face = face;
    active.bottom = bottom->y;
    active.one = {0, 0, 0, top->y, static_cast<std::uint32_t>(top - outline.begin())};
    active.other = active.one;
    active.crossed.slope = faces_[face].depth.a;
    active.crossed.face = face;
    cross(active, line);
    return place;
}

void ScanlineSweep::keep_what_is_crossed(double line) {
    std::size_t kept = 0;
    for (Place place : order_) {
        Active& active = active_[place.active];
        if (!(line < active.bottom)) {
            free_.push_back(place.active);
            continue;
        }
        cross(active, line);
        place.begin = active.crossed.begin;
        // Nearly in order already: each goes back past those that it has overtaken.
        std::size_t at = kept++;
        for (; at > 0 && order_[at - 1].begin > place.begin; --at) order_[at] = order_[at - 1];
        order_[at] = place;
    }
    order_.resize(kept);
}

void ScanlineSweep::add_what_begins(std::span<const std::uint32_t> faces, double line) {
    if (faces.empty()) return;
    fresh_.clear();
    for (const std::uint32_t face : faces) {
        const std::uint32_t place = activate(face, line);
        fresh_.push_back({active_[place].crossed.begin, place});
    }
    const auto before = [](const Place& p, const Place& q) { return p.begin < q.begin; };
    std::sort(fresh_.begin(), fresh_.end(), before);
    merged_.clear();
    std::merge(order_.begin(), order_.end(), fresh_.begin(), fresh_.end(), std::back_inserter(merged_),
               before);
    std::swap(order_, merged_);
}

void ScanlineSweep::operator()(std::span<const std::uint32_t> faces, const Scanlines& lines, double width,
                               const std::function<void(int, std::span<const Stretch>)>& take) {
    sort_by_first_line(faces, lines);
    active_.clear();
    free_.clear();
    order_.clear();
    for (int k = 0; k < lines.count; ++k) {
        const double line = lines.y(k);
        const std::size_t first = first_line_begin_[static_cast<std::size_t>(k)];
        const std::size_t end = first_line_begin_[static_cast<std::size_t>(k) + 1];
        keep_what_is_crossed(line);
        add_what_begins(std::span(by_first_line_).subspan(first, end - first), line);
        crossed_.clear();
        for (const Place& place : order_) {
            const Crossed& crossed = active_[place.active].crossed;
            if (crossed.begin >= width) break;
            if (crossed.end > 0) crossed_.push_back(crossed);
        }
        take(k, visible_(crossed_, width));
    }
}

}  // namespace keikan::baseline

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "convex_outline.hpp"
#include "double_double.hpp"
#include "keikan/model/point.hpp"

namespace keikan::clip {

/// An edge as a cut: what lies to its side +x -> +y is inside. Its ends are snapped points.
struct EdgeCut {
    Point from, to;
    double along_x = 0, along_y = 0;  ///< to - from, exactly
    double on_line = 0;               ///< sides no larger than this count as on the line

    EdgeCut() = default;
    EdgeCut(Point a, Point b)
        : from(a),
          to(b),
          along_x(b.x - a.x),
          along_y(b.y - a.y),
          on_line(kHalfUlp * (std::abs(along_x) + std::abs(along_y))) {}

    /// Distance to the line times the length of the edge. Points that rounding has moved off the line by
    /// less than one step of their grid have |side| <= on_line.
    double side(Point p) const { return along_x * (p.y - from.y) - along_y * (p.x - from.x); }

    /// The ends of the edge itself, where a crossing falls on one of them: so that the corners of a face
    /// stay the same points in every cell.
    Point weld(Point p) const {
        constexpr double kWeld = 4 * kHalfUlp;  // two roundings of either coordinate
        if (std::abs(p.x - from.x) + std::abs(p.y - from.y) <= kWeld) return from;
        if (std::abs(p.x - to.x) + std::abs(p.y - to.y) <= kWeld) return to;
        return p;
    }
};

/// The corners of a ring strictly inside and strictly outside a cut; the others are on its line. Rings of
/// more than 64 corners do not fit: they have `counts_only`, 1 standing for "some".
struct Sides {
    std::uint64_t inside = 0;
    std::uint64_t outside = 0;
    bool counts_only = false;
};

/// Evaluates the side of each corner.
template <class Cut>
Sides sides_of(const Cut& cut, const Point* ring, std::size_t n, double* side) {
    Sides sides;
    if (n <= 64) [[likely]] {
        for (std::size_t i = 0; i < n; ++i) {
            side[i] = cut.side(ring[i]);
            sides.inside |= static_cast<std::uint64_t>(side[i] > cut.on_line) << i;
            sides.outside |= static_cast<std::uint64_t>(side[i] < -cut.on_line) << i;
        }
        return sides;
    }
    sides.counts_only = true;
    for (std::size_t i = 0; i < n; ++i) {
        side[i] = cut.side(ring[i]);
        sides.inside |= side[i] > cut.on_line;
        sides.outside |= side[i] < -cut.on_line;
    }
    return sides;
}

/// Rings are worked on four corners at a time, so that their sizes, which nobody can foretell, steer no jump:
/// a ring of n corners has room for padded(n), and pad() fills it with repeats of the first.
constexpr std::size_t padded(std::size_t n) {
    return (n + 3) & ~std::size_t{3};
}
inline void pad(Point* ring, std::size_t n) {
    // At most three are missing, and the room of a ring that lacks one is at least four.
    const std::size_t end = padded(n);
    for (std::size_t i = end - 3; i < end; ++i) ring[i] = i < n ? ring[i] : ring[0];
}

/// Room for either part of a ring of n corners, padding included.
constexpr std::size_t room_of_part(std::size_t n) {
    return padded(2 * n);
}

/// Whether any corner is strictly inside a cut, and whether any is strictly outside.
struct Reach {
    bool inside = false;
    bool outside = false;
};

/// Of four corners.
template <class Cut>
Reach reach_of_four(const Cut& cut, const Point* corner) {
    const double a = cut.side(corner[0]), b = cut.side(corner[1]);
    const double c = cut.side(corner[2]), d = cut.side(corner[3]);
    return {std::max(std::max(a, b), std::max(c, d)) > cut.on_line,
            std::min(std::min(a, b), std::min(c, d)) < -cut.on_line};
}

/// Of a padded ring.
template <class Cut>
Reach reach_of(const Cut& cut, const Point* ring, std::size_t n) {
    Reach all = reach_of_four(cut, ring);
    for (std::size_t begin = 4; begin < n; begin += 4) {
        const Reach more = reach_of_four(cut, ring + begin);
        all.inside |= more.inside;
        all.outside |= more.outside;
    }
    return all;
}

/// Where the segment p q passes side 0, snapped; the same for q p. Requires sides of opposite sign.
inline Point crossing(Point p, double side_p, Point q, double side_q) {
    // From the end nearer to the line, so that the rounding of the way there stays below half an ulp.
    const double size_p = std::abs(side_p), size_q = std::abs(side_q);
    const bool from_q = size_q < size_p || (size_q == size_p && side_q > 0);
    const Point start = from_q ? q : p, end = from_q ? p : q;
    const double t = (from_q ? side_q : side_p) / (from_q ? side_q - side_p : side_p - side_q);
    return {snap(start.x + t * (end.x - start.x)), snap(start.y + t * (end.y - start.y))};
}

struct SplitSizes {
    std::size_t inside = 0;
    std::size_t outside = 0;
};

/// The splitting of any ring, however rounding may have bent it.
template <class Cut>
SplitSizes split_bent(const Cut& cut, const Point* ring, const double* side, std::size_t n, Point* inside,
                      Point* outside) {
    SplitSizes size;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = i + 1 < n ? i + 1 : 0;
        const bool in = side[i] > cut.on_line, out = side[i] < -cut.on_line;
        if (!out) inside[size.inside++] = ring[i];
        if (!in) outside[size.outside++] = ring[i];
        if ((in && side[next] < -cut.on_line) || (out && side[next] > cut.on_line)) {
            const Point p = cut.weld(crossing(ring[i], side[i], ring[next], side[next]));
            inside[size.inside++] = p;
            outside[size.outside++] = p;
        }
    }
    return size;
}

/// Divides a ring, some corners of which are on either side of the cut, along its line. A part has at most
/// 2 n corners; both parts hold the same points on the line.
template <class Cut>
SplitSizes split(const Cut& cut, const Sides& sides, const Point* ring, const double* side, std::size_t n,
                 Point* inside, Point* outside) {
    if (sides.counts_only) [[unlikely]]
        return split_bent(cut, ring, side, n, inside, outside);
    // A convex ring has one run of corners on either side and at most one corner on the line between them.
    const std::uint64_t all = ~std::uint64_t{0} >> (64 - n);
    const auto before = [n, all](std::uint64_t set) { return (set << 1 | set >> (n - 1)) & all; };
    const auto after = [n](std::uint64_t set) { return set >> 1 | (set & 1) << (n - 1); };
    const std::uint64_t in_first = sides.inside & ~before(sides.inside);
    const std::uint64_t out_first = sides.outside & ~before(sides.outside);
    const auto single = [](std::uint64_t set) { return (set & (set - 1)) == 0; };
    if (!single(in_first) || !single(out_first)) [[unlikely]]
        return split_bent(cut, ring, side, n, inside, outside);
    const auto index = [](std::uint64_t set) { return static_cast<std::size_t>(std::countr_zero(set)); };
    const std::size_t first_in = index(in_first), last_in = index(sides.inside & ~after(sides.inside));
    const std::size_t first_out = index(out_first), last_out = index(sides.outside & ~after(sides.outside));
    const auto following = [n](std::size_t i) { return i + 1 < n ? i + 1 : 0; };
    const auto passage = [&](std::size_t from, std::size_t to, Point& point) {
        const std::size_t on = following(from);
        if (on == to)
            point = cut.weld(crossing(ring[from], side[from], ring[to], side[to]));
        else if (following(on) == to)
            point = ring[on];
        else
            return false;
        return true;
    };
    Point leaves, enters;
    if (!passage(last_in, first_out, leaves) || !passage(last_out, first_in, enters)) [[unlikely]]
        return split_bent(cut, ring, side, n, inside, outside);
    SplitSizes size;
    for (std::size_t i = first_in;; i = following(i)) {
        inside[size.inside++] = ring[i];
        if (i == last_in) break;
    }
    inside[size.inside++] = leaves;
    inside[size.inside++] = enters;
    for (std::size_t i = first_out;; i = following(i)) {
        outside[size.outside++] = ring[i];
        if (i == last_out) break;
    }
    outside[size.outside++] = enters;
    outside[size.outside++] = leaves;
    return size;
}

}  // namespace keikan::clip

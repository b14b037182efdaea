// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <cstddef>

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
};

/// How many corners of a ring lie strictly inside and strictly outside a cut.
struct SideCount {
    std::size_t inside = 0;
    std::size_t outside = 0;
};

/// Brings the sides of points on the line to exactly 0 and counts the others.
inline SideCount settle_sides(double* side, std::size_t n, double on_line) {
    SideCount count;
    for (std::size_t i = 0; i < n; ++i) {
        const bool in = side[i] > on_line, out = side[i] < -on_line;
        if (!in && !out) side[i] = 0;
        count.inside += in;
        count.outside += out;
    }
    return count;
}

/// Where the segment p q passes side 0, snapped; the same for q p. Requires sides of opposite sign.
inline Point crossing(Point p, double side_p, Point q, double side_q) {
    // From the end nearer to the line, so that the rounding of the way there stays below half an ulp.
    const double size_p = std::abs(side_p), size_q = std::abs(side_q);
    if (size_q < size_p || (size_q == size_p && side_q > 0)) {
        std::swap(p, q);
        std::swap(side_p, side_q);
    }
    const double t = side_p / (side_p - side_q);
    return {snap(p.x + t * (q.x - p.x)), snap(p.y + t * (q.y - p.y))};
}

struct SplitSizes {
    std::size_t inside = 0;
    std::size_t outside = 0;
};

/// Divides a ring along a line. `side` holds the settled side of each corner, some of them of either sign.
/// Each part has at most n + 1 corners; both hold the same points on the line. `weld` may replace a
/// crossing by a point within its rounding error.
template <class Weld>
SplitSizes split(const Point* ring, const double* side, std::size_t n, Point* inside, Point* outside,
                 Weld weld) {
    SplitSizes size;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = i + 1 < n ? i + 1 : 0;
        if (side[i] >= 0) inside[size.inside++] = ring[i];
        if (side[i] <= 0) outside[size.outside++] = ring[i];
        if ((side[i] > 0 && side[next] < 0) || (side[i] < 0 && side[next] > 0)) {
            const Point p = weld(crossing(ring[i], side[i], ring[next], side[next]));
            inside[size.inside++] = p;
            outside[size.outside++] = p;
        }
    }
    return size;
}

/// The ends of the edge itself, where a crossing falls on one of them: so that the corners of a face stay
/// the same points in every cell.
struct WeldToEdge {
    const EdgeCut& cut;
    Point operator()(Point p) const {
        constexpr double kWeld = 4 * kHalfUlp;  // two roundings of either coordinate
        if (std::abs(p.x - cut.from.x) + std::abs(p.y - cut.from.y) <= kWeld) return cut.from;
        if (std::abs(p.x - cut.to.x) + std::abs(p.y - cut.to.y) <= kWeld) return cut.to;
        return p;
    }
};

}  // namespace keikan::clip

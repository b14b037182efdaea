// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <boost/rational.hpp>
#include <cmath>
#include <vector>

#include "keikan/clip/orient2d.hpp"
#include "keikan/model/point.hpp"

namespace keikan::test {

/// Small integers and the crossing points of lines through them: 64 bits hold every sum here exactly.
using GridRational = boost::rational<long long>;

struct RationalPoint {
    GridRational x, y;
};
using RationalRing = std::vector<RationalPoint>;

/// Requires: integer coordinates.
inline RationalRing rational(std::span<const Point> ring) {
    RationalRing result;
    for (const Point p : ring)
        result.push_back(
            {GridRational(static_cast<long long>(p.x)), GridRational(static_cast<long long>(p.y))});
    return result;
}

inline GridRational cross(const RationalPoint& a, const RationalPoint& b, const RationalPoint& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Of a ring that may wind around points any number of times: its area with multiplicity.
inline GridRational area(const RationalRing& ring) {
    GridRational twice = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += cross(ring[0], ring[i], ring[i + 1]);
    return twice / 2;
}

/// The part of `ring` to the side +x -> +y of the line through a and b.
inline RationalRing half_plane(const RationalRing& ring, const RationalPoint& a, const RationalPoint& b) {
    RationalRing result;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RationalPoint& p = ring[i];
        const RationalPoint& q = ring[(i + 1) % ring.size()];
        const GridRational s = cross(a, b, p), t = cross(a, b, q);
        if (s >= 0) result.push_back(p);
        if ((s > 0 && t < 0) || (s < 0 && t > 0)) {
            const GridRational k = s / (s - t);
            result.push_back({p.x + k * (q.x - p.x), p.y + k * (q.y - p.y)});
        }
    }
    return result;
}

/// The part of `ring`, which may be any polygon, in the convex `clip`; its area with multiplicity is exact,
/// since the bridges that half-plane clipping leaves enclose nothing.
inline RationalRing intersection(RationalRing ring, const RationalRing& clip) {
    for (std::size_t j = 0; j < clip.size() && !ring.empty(); ++j)
        ring = half_plane(ring, clip[j], clip[(j + 1) % clip.size()]);
    return ring;
}

/// Strictly convex and turning from +x towards +y, once round.
inline bool turns_convex(const Ring& ring) {
    double turned = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
        if (orient2d(a, b, c) != Sign::Positive) return false;
        turned += std::atan2((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x),
                             (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y));
    }
    return turned < 7;  // 2 pi, not 4 pi
}

/// All triangles, and with `quads` all convex quadrilaterals, with vertices on the side x side grid.
inline std::vector<Ring> grid_polygons(int side, bool quads) {
    const int n = side * side;
    const auto point = [side](int i) {
        return Point{static_cast<double>(i % side), static_cast<double>(i / side)};
    };
    std::vector<Ring> found;
    const auto add = [&found](const Ring& ring) {
        if (turns_convex(ring)) found.push_back(ring);
    };
    for (int a = 0; a < n; ++a)
        for (int b = a + 1; b < n; ++b)
            for (int c = a + 1; c < n; ++c) {
                if (c == b) continue;
                add({point(a), point(b), point(c)});
                for (int d = a + 1; quads && d < n; ++d)
                    if (d != b && d != c) add({point(a), point(b), point(c), point(d)});
            }
    return found;
}

}  // namespace keikan::test

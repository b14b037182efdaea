// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/prepared_pixel.hpp"

#include <gmpxx.h>

#include <algorithm>

#include "oracle/exact_hull.hpp"

namespace keikan::peers {
namespace {

struct RationalPoint {
    mpq_class x;
    mpq_class y;
};
using RationalRing = std::vector<RationalPoint>;

/// The part of the convex `ring` where `inside` (an affine function of the point) is not negative.
template <typename Inside>
RationalRing half(const RationalRing& ring, const Inside& inside) {
    RationalRing part;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RationalPoint& p = ring[i];
        const RationalPoint& q = ring[i + 1 == ring.size() ? 0 : i + 1];
        const mpq_class at_p = inside(p), at_q = inside(q);
        if (at_p >= 0) part.push_back(p);
        if (at_p * at_q < 0) {
            const mpq_class t = at_p / (at_p - at_q);
            part.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
    }
    return part;
}

RationalRing in_unit_square(RationalRing ring) {
    ring = half(ring, [](const RationalPoint& p) { return p.x; });
    ring = half(ring, [](const RationalPoint& p) { return p.y; });
    ring = half(ring, [](const RationalPoint& p) { return mpq_class(1 - p.x); });
    return half(ring, [](const RationalPoint& p) { return mpq_class(1 - p.y); });
}

/// The convex hull by exact signs, from +x towards +y; empty if it has no area.
Ring strictly_convex(const Ring& points) {
    Ring hull = oracle::exact_hull(points);
    if (hull.size() < 3) hull.clear();
    return hull;
}

bool is_inside_already(std::span<const Point> ring, PixelIndex pixel) {
    return pixel == PixelIndex{} &&
           std::ranges::all_of(ring, [](Point p) { return p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1; });
}

}  // namespace

Ring ring_in_pixel(std::span<const Point> ring, PixelIndex pixel) {
    if (is_inside_already(ring, pixel)) return strictly_convex(Ring(ring.begin(), ring.end()));
    RationalRing exact;
    for (const Point p : ring) exact.push_back({mpq_class(p.x) - pixel.x, mpq_class(p.y) - pixel.y});
    Ring rounded;
    for (const RationalPoint& p : in_unit_square(std::move(exact)))
        rounded.push_back({std::clamp(p.x.get_d(), 0.0, 1.0), std::clamp(p.y.get_d(), 0.0, 1.0)});
    return strictly_convex(rounded);
}

PreparedPixel prepared_pixel(const PixelCase& pixel_case) {
    PreparedPixel prepared{pixel_case.pixel, pixel_case.nearness(), pixel_case.faces(), {}};
    for (const Ring& polygon : pixel_case.polygons)
        prepared.in_pixel.push_back(ring_in_pixel(polygon, pixel_case.pixel));
    return prepared;
}

}  // namespace keikan::peers

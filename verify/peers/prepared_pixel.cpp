// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/prepared_pixel.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <iterator>

namespace keikan::peers {
namespace {

using CGAL::Gmpq;

struct RationalPoint {
    Gmpq x;
    Gmpq y;
};
using RationalRing = std::vector<RationalPoint>;

/// The part of the convex `ring` where `inside` (an affine function of the point) is not negative.
template <typename Inside>
RationalRing half(const RationalRing& ring, const Inside& inside) {
    RationalRing part;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RationalPoint& p = ring[i];
        const RationalPoint& q = ring[i + 1 == ring.size() ? 0 : i + 1];
        const Gmpq at_p = inside(p), at_q = inside(q);
        if (at_p >= 0) part.push_back(p);
        if (at_p * at_q < 0) {
            const Gmpq t = at_p / (at_p - at_q);
            part.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
    }
    return part;
}

RationalRing in_unit_square(RationalRing ring) {
    ring = half(ring, [](const RationalPoint& p) { return p.x; });
    ring = half(ring, [](const RationalPoint& p) { return p.y; });
    ring = half(ring, [](const RationalPoint& p) { return Gmpq(1) - p.x; });
    return half(ring, [](const RationalPoint& p) { return Gmpq(1) - p.y; });
}

/// The convex hull by exact signs, from +x towards +y; empty if it has no area.
Ring strictly_convex(const Ring& points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_2> in;
    std::vector<Kernel::Point_2> out;
    for (const Point p : points) in.emplace_back(p.x, p.y);
    CGAL::convex_hull_2(in.begin(), in.end(), std::back_inserter(out));
    Ring ring;
    if (out.size() < 3) return ring;
    for (const Kernel::Point_2& p : out) ring.push_back({p.x(), p.y()});
    return ring;
}

bool is_inside_already(std::span<const Point> ring, PixelIndex pixel) {
    return pixel == PixelIndex{} &&
           std::ranges::all_of(ring, [](Point p) { return p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1; });
}

}  // namespace

Ring ring_in_pixel(std::span<const Point> ring, PixelIndex pixel) {
    if (is_inside_already(ring, pixel)) return strictly_convex(Ring(ring.begin(), ring.end()));
    RationalRing exact;
    for (const Point p : ring) exact.push_back({Gmpq(p.x) - pixel.x, Gmpq(p.y) - pixel.y});
    Ring rounded;
    for (const RationalPoint& p : in_unit_square(std::move(exact)))
        rounded.push_back(
            {std::clamp(CGAL::to_double(p.x), 0.0, 1.0), std::clamp(CGAL::to_double(p.y), 0.0, 1.0)});
    return strictly_convex(rounded);
}

PreparedPixel prepared_pixel(const PixelCase& pixel_case) {
    PreparedPixel prepared{pixel_case.pixel, pixel_case.nearness(), pixel_case.faces(), {}};
    for (const Ring& polygon : pixel_case.polygons)
        prepared.in_pixel.push_back(ring_in_pixel(polygon, pixel_case.pixel));
    return prepared;
}

}  // namespace keikan::peers

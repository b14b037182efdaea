// SPDX-License-Identifier: GPL-3.0-or-later
#include "convex_outline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact_double.hpp"

namespace keikan::oracle {
namespace {

bool before(Point p, Point q) {
    return p.x != q.x ? p.x < q.x : p.y < q.y;
}

/// A ring that only turns one way (1 or -1) and goes round once; else 0. It goes round once if, read around,
/// its points rise in lexicographic order and fall again, once each.
int strictly_convex(std::span<const Point> ring) {
    const std::size_t n = ring.size();
    if (n < 3) return 0;
    const int turn = orientation(ring[n - 1], ring[0], ring[1]);
    if (turn == 0) return 0;
    int changes = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Point p = ring[i], q = ring[(i + 1) % n], r = ring[(i + 2) % n];
        if (i + 1 < n && orientation(p, q, r) != turn) return 0;
        changes += before(p, q) != before(q, r);
    }
    return changes == 2 ? turn : 0;
}

/// Andrew's monotone chains, with exact turns.
void hull(std::vector<Point>& points) {
    std::ranges::sort(points, before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::vector<Point> ring;
    const auto add_chain = [&ring](auto from, auto to) {
        const std::size_t start = ring.size();
        for (; from != to; ++from) {
            while (ring.size() >= start + 2 && orientation(ring[ring.size() - 2], ring.back(), *from) <= 0)
                ring.pop_back();
            ring.push_back(*from);
        }
        ring.pop_back();
    };
    if (points.size() >= 3) {
        add_chain(points.begin(), points.end());
        add_chain(points.rbegin(), points.rend());
    }
    if (ring.size() < 3) ring.clear();
    points = std::move(ring);
}

}  // namespace

void convex_outline(std::span<const Point> outline, std::vector<Point>& ring) {
    ring.clear();
    for (const Point& p : outline)
        if (ring.empty() || ring.back() != p) ring.push_back(p);
    while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
    const int turn = strictly_convex(ring);
    if (turn < 0) std::ranges::reverse(ring);
    if (turn == 0) hull(ring);
}

PixelSide pixel_side(Point p, Point q, PixelIndex pixel) {
    // For a rounded difference of the corner's products, see `orientation`: the same bound, for all four
    // corners. The corners are exact doubles.
    constexpr double kRelativeError = 3.3306690738754716e-16;
    constexpr double kNoUnderflow = 1e-280;
    int left = 0, right = 0;
    for (int corner = 0; corner < 4; ++corner) {
        const double x = pixel.x + (corner & 1), y = pixel.y + (corner >> 1);
        const double first = (p.x - x) * (q.y - y), second = (p.y - y) * (q.x - x);
        const double size = std::abs(first) + std::abs(second);
        if (!(size > kNoUnderflow && std::abs(first - second) > kRelativeError * size))
            return PixelSide::Unknown;
        (first > second ? left : right) += 1;
    }
    return left == 4 ? PixelSide::Left : right == 4 ? PixelSide::Right : PixelSide::Unknown;
}

}  // namespace keikan::oracle

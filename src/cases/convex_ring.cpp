// SPDX-License-Identifier: Apache-2.0
#include "keikan/cases/convex_ring.hpp"

#include <vector>

#include "keikan/clip/orient2d.hpp"

namespace keikan {
namespace {

std::vector<Point> without_repeats(std::span<const Point> ring) {
    std::vector<Point> distinct;
    for (const Point& p : ring)
        if (distinct.empty() || distinct.back() != p) distinct.push_back(p);
    while (distinct.size() > 1 && distinct.front() == distinct.back()) distinct.pop_back();
    return distinct;
}

/// Whether travel from `a` to `b` rises in the order by x, then y.
bool rises(Point a, Point b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

}  // namespace

bool is_convex_ring(std::span<const Point> ring) {
    const std::vector<Point> corners = without_repeats(ring);
    const std::size_t n = corners.size();
    bool turns_left = false;
    bool turns_right = false;
    int reversals = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Point& a = corners[i];
        const Point& b = corners[(i + 1) % n];
        const Point& c = corners[(i + 2) % n];
        const Sign turn = orient2d(a, b, c);
        turns_left |= turn == Sign::Positive;
        turns_right |= turn == Sign::Negative;
        reversals += rises(a, b) != rises(b, c);
    }
    if (!turns_left && !turns_right) return true;  // all on one line
    if (turns_left && turns_right) return false;
    // A ring that always turns to the same side and goes round k times changes between rising and falling
    // 2 k times; a spike turns by 180 degrees, and no ring with one closes within a single round.
    return reversals == 2;
}

}  // namespace keikan

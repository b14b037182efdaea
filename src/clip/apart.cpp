// SPDX-License-Identifier: Apache-2.0
#include "apart.hpp"

#include <cmath>

namespace keikan::clip {
namespace {

bool boxes_apart(const Box& a, const Box& b) {
    return a.max_x <= b.min_x || b.max_x <= a.min_x || a.max_y <= b.min_y || b.max_y <= a.min_y;
}

/// Whether an edge of `a` has all of `b` on its outer side.
bool edge_separates(std::span<const Point> a, std::span<const Point> b) {
    Point p = a.back();
    for (const Point q : a) {
        const double dx = q.x - p.x, dy = q.y - p.y;
        const double on_line = kHalfUlp * (std::abs(dx) + std::abs(dy));
        bool outside = true;
        for (const Point r : b) {
            if (dx * (r.y - p.y) - dy * (r.x - p.x) > on_line) {
                outside = false;
                break;
            }
        }
        if (outside) return true;
        p = q;
    }
    return false;
}

}  // namespace

bool pairwise_apart(const Entrants& entrants) {
    for (std::size_t i = 0; i < entrants.faces.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Entrant &a = entrants.faces[i], &b = entrants.faces[j];
            if (boxes_apart(a.box, b.box)) continue;
            const std::span<const Point> ring_a = entrants.ring(a), ring_b = entrants.ring(b);
            if (!edge_separates(ring_a, ring_b) && !edge_separates(ring_b, ring_a)) return false;
        }
    return true;
}

}  // namespace keikan::clip

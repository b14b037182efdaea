// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "double_double.hpp"
#include "keikan/clip/orient2d.hpp"
#include "keikan/model/point.hpp"

namespace keikan::clip {

/// Of up to 64 points, by bits: those strictly to the outer side of a line, and those exactly on it.
struct SideSets {
    std::uint64_t outside = 0;
    std::uint64_t on = 0;
};

/// The line a -> b through any two points; the side +x -> +y is inside. Exact as orient2d.
class AnyLine {
  public:
    AnyLine(Point a, Point b) : a_(a), b_(b) {}

    /// +1 inside, -1 outside, 0 on the line.
    int side(Point p) const { return static_cast<int>(orient2d(a_, b_, p)); }

    SideSets sides(const Point* point, std::size_t n) const {
        SideSets sets;
        for (std::size_t i = 0; i < n; ++i) {
            const int s = side(point[i]);
            sets.outside |= static_cast<std::uint64_t>(s < 0) << i;
            sets.on |= static_cast<std::uint64_t>(s == 0) << i;
        }
        return sets;
    }

  private:
    Point a_, b_;
};

/// The same for points that are multiples of 2^-53 in the unit square: their differences are doubles, and no
/// product of two differences underflows. So a side is the exact comparison of two products of doubles.
class LatticeLine {
  public:
    LatticeLine(Point a, Point b)
        : a_(a),
          dx_(b.x - a.x),
          dy_(b.y - a.y),
          unsure_(4 * kHalfUlp * std::min(std::abs(dx_), std::abs(dy_))) {}

    int side(Point p) const {
        const double rough = rough_side(p);
        if (std::abs(rough) > unsure_) return rough > 0 ? 1 : -1;
        return exact_side(p);
    }

    SideSets sides(const Point* point, std::size_t n) const {
        SideSets sets;
        for (std::size_t i = n; i-- > 0;) {
            const double rough = rough_side(point[i]);
            sets.outside = 2 * sets.outside + static_cast<std::uint64_t>(rough < -unsure_);
            sets.on = 2 * sets.on + static_cast<std::uint64_t>(std::abs(rough) <= unsure_);
        }
        if (sets.on != 0 && unsure_ != 0) settle(point, sets);
        return sets;
    }

  private:
    /// A difference of two products l and r, each off by at most half an ulp of itself; that the difference
    /// is rounded, too, changes no sign. It has the wrong one only if l - r is so small that |l| and |r|
    /// agree to an ulp: then neither is larger than the smaller of |dx| and |dy|, since their other factors
    /// are at most 1, and the difference as computed is at most 2 kHalfUlp of that. unsure_ is twice as much;
    /// along an axis it is 0, and rightly so: one of the products is 0.
    double rough_side(Point p) const { return dx_ * (p.y - a_.y) - dy_ * (p.x - a_.x); }

    int exact_side(Point p) const {
        const double px = p.x - a_.x, py = p.y - a_.y;
        const DoubleDouble left = two_product(dx_, py), right = two_product(dy_, px);
        if (left.hi != right.hi) return left.hi > right.hi ? 1 : -1;
        return left.lo == right.lo ? 0 : left.lo > right.lo ? 1 : -1;
    }

    /// Looks again at the points that are too close to call.
    void settle(const Point* point, SideSets& sets) const {
        for (std::uint64_t unsure = sets.on; unsure != 0; unsure &= unsure - 1) {
            const std::uint64_t here = unsure & (~unsure + 1);
            const Point p = point[std::countr_zero(unsure)];
            if (p == a_) continue;
            const int s = exact_side(p);
            if (s != 0) sets.on ^= here;
            if (s < 0) sets.outside |= here;
        }
    }

    Point a_;
    double dx_, dy_;
    double unsure_;
};

}  // namespace keikan::clip

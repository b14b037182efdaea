// SPDX-License-Identifier: Apache-2.0
#pragma once
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
        : a_(a), dx_(b.x - a.x), dy_(b.y - a.y), unsure_(2 * kHalfUlp * (std::abs(dx_) + std::abs(dy_))) {}

    int side(Point p) const {
        const double rough = rough_side(p);
        if (std::abs(rough) > unsure_) return rough > 0 ? 1 : -1;
        return exact_side(p);
    }

    SideSets sides(const Point* point, std::size_t n) const {
        SideSets sets;
        std::uint64_t unsure = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double rough = rough_side(point[i]);
            sets.outside |= static_cast<std::uint64_t>(rough < -unsure_) << i;
            unsure |= static_cast<std::uint64_t>(std::abs(rough) <= unsure_) << i;
        }
        for (std::size_t i = 0; unsure != 0; ++i, unsure >>= 1) {
            if ((unsure & 1) == 0) continue;
            const int s = exact_side(point[i]);
            sets.outside |= static_cast<std::uint64_t>(s < 0) << i;
            sets.on |= static_cast<std::uint64_t>(s == 0) << i;
        }
        return sets;
    }

  private:
    /// Both products are rounded, by at most half an ulp of |dx| and |dy| since the other factor is at most
    /// 1; that their difference is rounded, too, changes no sign. Twice that is unsure_.
    double rough_side(Point p) const { return dx_ * (p.y - a_.y) - dy_ * (p.x - a_.x); }

    int exact_side(Point p) const {
        const double px = p.x - a_.x, py = p.y - a_.y;
        if ((px == 0 && py == 0) || (px == dx_ && py == dy_)) return 0;
        const DoubleDouble left = two_product(dx_, py), right = two_product(dy_, px);
        if (left.hi != right.hi) return left.hi > right.hi ? 1 : -1;
        return left.lo == right.lo ? 0 : left.lo > right.lo ? 1 : -1;
    }

    Point a_;
    double dx_, dy_;
    double unsure_;
};

}  // namespace keikan::clip

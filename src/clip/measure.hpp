// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "double_double.hpp"
#include "keikan/model/point.hpp"

namespace keikan::clip {

/// A sum of many numbers as if in twice the precision (Neumaier 1974).
class CarefulSum {
  public:
    void add(double value) {
        const DoubleDouble sum = two_sum(sum_, value);
        sum_ = sum.hi;
        rest_ += sum.lo;
    }
    double value() const { return sum_ + rest_; }

  private:
    double sum_ = 0, rest_ = 0;
};

/// Area and first moments of a sum of rings.
struct Measure {
    CarefulSum area, x, y;

    /// Adds a ring, seen from its first corner: differences are exact, and the terms as small as the ring.
    void add(std::span<const Point> ring, int sign = 1) {
        const Point from = ring[0];
        double twice_area = 0, moment_x = 0, moment_y = 0;
        double ux = ring[1].x - from.x, uy = ring[1].y - from.y;
        for (std::size_t i = 2; i < ring.size(); ++i) {
            const double vx = ring[i].x - from.x, vy = ring[i].y - from.y;
            const double cross = ux * vy - uy * vx;
            twice_area += cross;
            moment_x += cross * (ux + vx);
            moment_y += cross * (uy + vy);
            ux = vx, uy = vy;
        }
        const double ring_area = 0.5 * sign * twice_area;
        area.add(ring_area);
        x.add(ring_area * from.x + sign * moment_x / 6);
        y.add(ring_area * from.y + sign * moment_y / 6);
    }
};

}  // namespace keikan::clip

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "keikan/model/point.hpp"

namespace keikan {

/// A region of the pixel, from which points are drawn uniformly: the whole pixel, or convex pieces.
class WaterRegion {
  public:
    void set_whole() { triangles_.clear(); }

    void clear() {
        triangles_.clear();
        area_ = 0;
    }
    void add(std::span<const Point> ring) {
        for (std::size_t i = 2; i < ring.size(); ++i) {
            const Point a = ring[0], b = ring[i - 1], c = ring[i];
            const double area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
            if (!(area > 0)) continue;
            area_ += area;
            triangles_.push_back({a, b, c, area_});
        }
    }
    bool empty() const { return triangles_.empty(); }
    double area() const { return area_; }

    /// The point of the region for a uniform point of the unit square: areas are kept, and pieces lie side by
    /// side along u, so that well-spread points stay so.
    Point at(Point u) const {
        if (triangles_.empty()) return u;
        const double along = u.x * area_;
        const auto found = std::partition_point(triangles_.begin(), triangles_.end() - 1,
                                                [&](const Triangle& t) { return t.area_to_here <= along; });
        const double before = found == triangles_.begin() ? 0 : (found - 1)->area_to_here;
        const double share = std::clamp((along - before) / (found->area_to_here - before), 0.0, 1.0);
        const double r = std::sqrt(share), s = r * (1 - u.y), t = r * u.y;
        return {(1 - r) * found->a.x + s * found->b.x + t * found->c.x,
                (1 - r) * found->a.y + s * found->b.y + t * found->c.y};
    }

  private:
    struct Triangle {
        Point a, b, c;
        double area_to_here;
    };
    std::vector<Triangle> triangles_;
    double area_ = 0;
};

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/convex_hull.hpp"

#include <algorithm>

#include "keikan/clip/orient2d.hpp"

namespace keikan::clip {

void replace_by_hull(std::vector<Point>& points) {
    const auto before = [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const std::size_t n = points.size();
    if (n < 3) return;
    // Andrew's monotone chain; the second half of the vector is where the hull grows.
    points.resize(3 * n + 1);
    Point* const hull = points.data() + n;
    std::size_t size = 0;
    const auto extend = [&](Point p, std::size_t keep) {
        while (size > keep && orient2d(hull[size - 2], hull[size - 1], p) != Sign::Positive) --size;
        hull[size++] = p;
    };
    for (std::size_t i = 0; i < n; ++i) extend(points[i], 1);
    const std::size_t upper = size;
    for (std::size_t i = n - 1; i-- > 0;) extend(points[i], upper);
    std::copy(hull, hull + (size - 1), points.begin());
    points.resize(size - 1);
}

}  // namespace keikan::clip

// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_hull.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <iterator>
#include <vector>

namespace keikan::oracle {

Ring exact_hull(std::span<const Point> points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_2> in;
    std::vector<Kernel::Point_2> out;
    for (const Point p : points) in.emplace_back(p.x, p.y);
    CGAL::convex_hull_2(in.begin(), in.end(), std::back_inserter(out));
    Ring ring;
    for (const Kernel::Point_2& p : out) ring.push_back({p.x(), p.y()});
    return ring;
}

}  // namespace keikan::oracle

// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/version.h>

#include <iterator>

#include "peers/repeated_differences.hpp"

namespace keikan::peers {
namespace {

/// The failed checks of CGAL are thrown; the terminal need not hear of them.
void quiet_failure(const char*, const char*, const char*, int, const char*) {}

template <typename Kernel>
struct CgalSets {
    using Region = CGAL::Polygon_set_2<Kernel>;

    Region region(const Ring& ring) const {
        CGAL::Polygon_2<Kernel> polygon;
        for (const Point p : ring) polygon.push_back(typename Kernel::Point_2(p.x, p.y));
        return Region(polygon);
    }
    bool is_empty(const Region& region) const { return region.is_empty(); }
    Region difference(Region from, const Region& what) const {
        from.difference(what);
        return from;
    }
    double area(const Region& region) const {
        std::vector<CGAL::Polygon_with_holes_2<Kernel>> parts;
        region.polygons_with_holes(std::back_inserter(parts));
        typename Kernel::FT area = 0;
        for (const auto& part : parts) {
            area += part.outer_boundary().area();
            for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) area += hole->area();
        }
        return CGAL::to_double(CGAL::exact(area));  // of a lazy number it would be rough
    }
};

template <typename Kernel>
Ask start_sets() {
    CGAL::set_error_handler(quiet_failure);
    return [library = CgalSets<Kernel>()](const PreparedPixel& pixel, Answer& answer) mutable {
        ask_by_repeated_differences(library, pixel, answer);
    };
}

}  // namespace

Peer cgal_inexact() {
    return {.name = "cgal-inexact",
            .version = "CGAL " CGAL_VERSION_STR ", inexact constructions",
            .start = start_sets<CGAL::Exact_predicates_inexact_constructions_kernel>};
}

Peer cgal_exact() {
    return {.name = "cgal-exact",
            .version = "CGAL " CGAL_VERSION_STR ", exact constructions",
            .start = start_sets<CGAL::Exact_predicates_exact_constructions_kernel>};
}

}  // namespace keikan::peers

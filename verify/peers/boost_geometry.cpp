// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/geometry/algorithms/append.hpp>
#include <boost/geometry/algorithms/area.hpp>
#include <boost/geometry/algorithms/correct.hpp>
#include <boost/geometry/algorithms/difference.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/version.hpp>

#include "peers/repeated_differences.hpp"

namespace keikan::peers {
namespace {

namespace bg = boost::geometry;

struct BoostGeometry {
    using Polygon = bg::model::polygon<bg::model::d2::point_xy<double>>;
    using Region = bg::model::multi_polygon<Polygon>;

    Region region(const Ring& ring) const {
        Polygon polygon;
        for (const Point p : ring) bg::append(polygon.outer(), bg::model::d2::point_xy<double>(p.x, p.y));
        bg::correct(polygon);  // closes the ring and turns it as the library wants it
        Region one;
        one.push_back(std::move(polygon));
        return one;
    }
    bool is_empty(const Region& region) const { return region.empty(); }
    Region difference(const Region& from, const Region& what) const {
        Region rest;
        bg::difference(from, what.front(), rest);
        return rest;
    }
    double area(const Region& region) const { return bg::area(region); }
};

}  // namespace

Peer boost_geometry() {
    constexpr int kMajor = BOOST_VERSION / 100'000, kMinor = BOOST_VERSION / 100 % 1000;
    std::string version = "Boost.Geometry " + std::to_string(kMajor) + "." + std::to_string(kMinor);
#ifndef BOOST_GEOMETRY_USE_RESCALING
    version += ", without rescaling";
#endif
    return {.name = "boost-geometry", .version = version, .start = []() -> Ask {
                return [library = BoostGeometry()](const PreparedPixel& pixel, Answer& answer) mutable {
                    ask_by_repeated_differences(library, pixel, answer);
                };
            }};
}

}  // namespace keikan::peers

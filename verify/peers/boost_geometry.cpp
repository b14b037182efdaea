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

Peer peer_named(const std::string& name) {
    constexpr int kMajor = BOOST_VERSION / 100'000, kMinor = BOOST_VERSION / 100 % 1000;
    std::string version = "Boost.Geometry " + std::to_string(kMajor) + "." + std::to_string(kMinor);
#ifdef BOOST_GEOMETRY_NO_ROBUSTNESS
    version += ", without rescaling";
#endif
    return {.name = name, .version = version, .start = []() -> Ask {
                return [library = BoostGeometry()](const PreparedPixel& pixel, Answer& answer) mutable {
                    ask_by_repeated_differences(library, pixel, answer);
                };
            }};
}

}  // namespace

#ifdef KEIKAN_BOOST_1_81
// Compiled a second time, against other headers, into a library that shows nothing but this function: the two
// Boosts give their functions the same names.
static_assert(BOOST_VERSION / 100 == 1081);
[[gnu::visibility("default")]] std::optional<Peer> boost_geometry_1_81() {
    return peer_named("boost-geometry-1.81");
}
#else
Peer boost_geometry() {
    return peer_named("boost-geometry");
}
#endif

}  // namespace keikan::peers

// SPDX-License-Identifier: Apache-2.0
#include "simple_polygon.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

using namespace keikan;

namespace {

using Outline = std::vector<glm::dvec2>;

double area(const Outline& outline) {
    double sum = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i] - outline[0], b = outline[(i + 1) % outline.size()] - outline[0];
        sum += (a.x * b.y - a.y * b.x) / 2;
    }
    return sum;
}

/// Triangles with area, as many as there should be, which share their inner edges whole.
void check_triangulation(const Outline& outline) {
    REQUIRE_FALSE(why_not_simple(outline));
    const auto triangles = triangulate(outline);
    REQUIRE(triangles.size() == outline.size() - 2);
    double sum = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : triangles) {
        const double part = area({outline[t[0]], outline[t[1]], outline[t[2]]});
        CHECK(part > 0);
        sum += part;
        for (std::size_t k = 0; k < 3; ++k)
            ++edges[{std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])}];
    }
    CHECK(sum == Approx(std::abs(area(outline))));
    const auto once = std::count_if(edges.begin(), edges.end(), [](const auto& e) { return e.second == 1; });
    CHECK(static_cast<std::size_t>(once) == outline.size());
}

}  // namespace

TEST_CASE("triangulate: convex, concave, spiral and flat-cornered outlines of either orientation",
          "[scene][water]") {
    const std::vector<Outline> outlines{
        {{0, 0}, {4, 0}, {4, 3}},
        {{0, 0}, {4, 0}, {4, 3}, {0, 3}},
        {{0, 0}, {5, 0}, {5, 1}, {1, 1}, {1, 4}, {5, 4}, {5, 5}, {0, 5}},
        {{0, 0}, {2, 0}, {4, 0}, {4, 2}, {4, 4}, {2, 4}, {0, 4}, {0, 2}},
        {{0, 0},
         {9, 0},
         {9, 9},
         {2, 9},
         {2, 4},
         {6, 4},
         {6, 6},
         {4, 6},
         {4, 7},
         {7, 7},
         {7, 2},
         {1, 2},
         {1, 9},
         {0, 9}},
        {{0, 0}, {10, 1}, {20, 0}, {11, 10}, {20, 20}, {10, 19}, {0, 20}, {9, 10}},
    };
    for (Outline outline : outlines) {
        check_triangulation(outline);
        std::reverse(outline.begin(), outline.end());
        check_triangulation(outline);
        std::rotate(outline.begin(), outline.begin() + 2, outline.end());
        check_triangulation(outline);
    }
}

TEST_CASE("triangulate: a coast of a thousand corners far from the origin", "[scene][water]") {
    Outline coast;
    for (int i = 0; i < 1000; ++i) {
        const double angle = i * 0.00628;
        const double radius = 500 + 60 * std::sin(31 * angle) + 25 * std::sin(137 * angle);
        coast.emplace_back(288821.25 + radius * std::cos(angle), 9110816.4 + radius * std::sin(angle));
    }
    check_triangulation(coast);
}

TEST_CASE("why_not_simple: names what is wrong with an outline", "[scene][water]") {
    CHECK(why_not_simple(Outline{{0, 0}, {1, 0}}));
    CHECK(why_not_simple(Outline{{0, 0}, {1, 1}, {2, 2}}));                  // no area
    CHECK(why_not_simple(Outline{{0, 0}, {1, 0}, {1, 0}, {0, 1}}));          // a corner twice
    CHECK(why_not_simple(Outline{{0, 0}, {2, 2}, {2, 0}, {0, 2}}));          // a bow tie
    CHECK(why_not_simple(Outline{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}));  // touches itself
    CHECK(why_not_simple(Outline{{0, 0}, {4, 0}, {2, 0}, {2, 3}}));          // runs back along itself
    CHECK_FALSE(why_not_simple(Outline{{0, 0}, {4, 0}, {4, 4}, {2, 0.5}, {0, 4}}));
}

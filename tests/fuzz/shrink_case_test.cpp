// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/shrink_case.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "fuzz/degenerate_families.hpp"
#include "keikan/cases/convex_ring.hpp"

using namespace keikan;
using namespace keikan::fuzz;

namespace {

/// Whether some polygon covers the point, its border included.
bool covers(const Ring& ring, Point p) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        left |= side > 0;
        right |= side < 0;
    }
    return ring.size() >= 3 && left != right;
}

}  // namespace

TEST_CASE("bits_of: the binary digits from the first to the last, or from the point", "[fuzz][shrink]") {
    CHECK(bits_of(0) == 0);
    CHECK(bits_of(-0.0) == 0);
    CHECK(bits_of(1) == 1);
    CHECK(bits_of(-2) == 1);
    CHECK(bits_of(0x1p900) == 1);
    CHECK(bits_of(3) == 2);
    CHECK(bits_of(0.5) == 1);
    CHECK(bits_of(0.625) == 3);
    CHECK(bits_of(0.0625) == 4);
    CHECK(bits_of(15.0 / 16) == 4);
    CHECK(bits_of(1.25) == 3);
    CHECK(bits_of(0.1) == 55);
    CHECK(bits_of(std::numeric_limits<double>::denorm_min()) == 1074);
}

TEST_CASE("shrunk: what the finding does not need is gone, and every question is a valid case",
          "[fuzz][shrink]") {
    // The finding: two polygons that both cover the middle of the pixel, the second one less far up.
    const auto still_fails = [](const PixelCase& c) {
        for (const Ring& ring : c.polygons) CHECK(is_convex_ring(ring));
        if (c.depth) CHECK(c.depth->size() == c.polygons.size());
        const Point middle{c.pixel.x + 0.5, c.pixel.y + 0.5};
        return std::ranges::count_if(c.polygons, [&](const Ring& ring) { return covers(ring, middle); }) >= 2;
    };
    int shrunken = 0;
    for (std::uint64_t i = 0; i < 200; ++i)
        for (const Family family :
             {Family::Random, Family::Huge, Family::Interpenetrating, Family::Duplicates}) {
            const PixelCase found = degenerate_case(family, 7, i);
            if (!still_fails(found)) continue;
            ++shrunken;
            const PixelCase small = shrunk(found, still_fails);
            INFO(found.id);
            CHECK(still_fails(small));
            CHECK(small.polygons.size() == 2);
            CHECK_FALSE(small.depth);
            CHECK(small.pixel == PixelIndex{0, 0});
            for (const Ring& ring : small.polygons) {
                CHECK(ring.size() == 3);
                for (const Point p : ring) CHECK(std::max(bits_of(p.x), bits_of(p.y)) <= 2);
            }
        }
    CHECK(shrunken > 100);
}

TEST_CASE("shrunk: what depends on its depth planes keeps them, with few bits", "[fuzz][shrink]") {
    const auto still_fails = [](const PixelCase& c) {
        return c.depth && !c.depth->empty() && (*c.depth)[0].a > 0.3 && (*c.depth)[0].a != 1;
    };
    PixelCase found = degenerate_case(Family::Coplanar, 1, 0);
    (*found.depth)[0].a = 0.8146937216;
    const PixelCase small = shrunk(found, still_fails);
    REQUIRE(small.depth);
    CHECK(small.polygons.size() == 1);
    CHECK(bits_of((*small.depth)[0].a) == 1);
    CHECK((*small.depth)[0].b == 0);
}

TEST_CASE("shrunk: the number of questions is bounded", "[fuzz][shrink]") {
    std::size_t questions = 0;
    const auto still_fails = [&](const PixelCase&) { return ++questions % 2 == 0; };
    shrunk(degenerate_case(Family::Random, 1, 3), still_fails, 25);
    CHECK(questions <= 25);
}

// SPDX-License-Identifier: Apache-2.0
#include "keikan/cases/convex_ring.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using keikan::is_convex_ring;
using keikan::Ring;

namespace {

/// The answer for `ring`, which must not depend on where it starts, on its orientation or on repeated points.
bool convex_from_everywhere(Ring ring) {
    const bool answer = is_convex_ring(ring);
    for (int side = 0; side < 2; ++side) {
        for (std::size_t start = 0; start < ring.size(); ++start) {
            std::rotate(ring.begin(), ring.begin() + 1, ring.end());
            CHECK(is_convex_ring(ring) == answer);
            Ring repeated = ring;
            repeated.insert(repeated.begin() + 1, ring.front());
            repeated.push_back(ring.front());
            CHECK(is_convex_ring(repeated) == answer);
        }
        std::reverse(ring.begin(), ring.end());
    }
    return answer;
}

}  // namespace

TEST_CASE("is_convex_ring: triangles, squares and corners of 180 degrees are convex", "[cases][convex]") {
    CHECK(convex_from_everywhere({{0, 0}, {1, 0}, {0, 1}}));
    CHECK(convex_from_everywhere({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    CHECK(convex_from_everywhere({{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0.25, 1}, {0, 1}, {0, 0.125}}));
}

TEST_CASE("is_convex_ring: a polygon without area that keeps to one line is allowed",
          "[cases][convex][degenerate]") {
    CHECK(is_convex_ring({}));
    CHECK(convex_from_everywhere({{3, 4}}));
    CHECK(convex_from_everywhere({{0, 0}, {1, 2}}));
    CHECK(convex_from_everywhere({{0, 0}, {2, 4}, {1, 2}}));
    CHECK(convex_from_everywhere({{0, 0}, {2, 4}, {1, 2}, {4, 8}, {3, 6}}));
}

TEST_CASE("is_convex_ring: a reflex corner, a bow-tie and a spike are not convex", "[cases][convex]") {
    CHECK_FALSE(convex_from_everywhere({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}}));
    CHECK_FALSE(convex_from_everywhere({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
    CHECK_FALSE(convex_from_everywhere({{0, 0}, {2, 0}, {1, 0}, {1, 1}}));
    CHECK_FALSE(convex_from_everywhere({{0, 0}, {1, 0}, {1, 1}, {1, 0}}));
}

TEST_CASE("is_convex_ring: a ring that goes round more than once is not convex", "[cases][convex]") {
    CHECK_FALSE(convex_from_everywhere({{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 0}, {1, 1}}));
    Ring star;  // every corner turns to the same side
    for (int i = 0; i < 5; ++i) star.push_back({std::cos(0.8 * M_PI * i), std::sin(0.8 * M_PI * i)});
    CHECK_FALSE(convex_from_everywhere(star));
}

TEST_CASE("is_convex_ring: one unit in the last place decides", "[cases][convex][exact]") {
    const double up = std::nextafter(0.5, 1.0);
    const double down = std::nextafter(0.5, 0.0);
    CHECK(convex_from_everywhere({{0, 0}, {0.5, 0.5}, {1, 1}, {0, 1}}));
    CHECK(convex_from_everywhere({{0, 0}, {up, 0.5}, {1, 1}, {0, 1}}));
    CHECK_FALSE(convex_from_everywhere({{0, 0}, {down, 0.5}, {1, 1}, {0, 1}}));
    // Far from the origin, where the products need 100 bits.
    const double x = 4095 + 1.0 / 3;
    CHECK(convex_from_everywhere({{0, 0}, {x, x}, {2 * x, 2 * x}, {0, 1}}));
    CHECK_FALSE(convex_from_everywhere({{0, 0}, {std::nextafter(x, 0.0), x}, {2 * x, 2 * x}, {0, 1}}));
}

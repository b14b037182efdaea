// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/prepared_pixel.hpp"

#include <catch2/catch.hpp>

using namespace keikan;
using namespace keikan::peers;

TEST_CASE("ring_in_pixel: what a polygon has in the pixel, pixel-local, from +x towards +y", "[peers]") {
    // A square of 2 x 2 around the corner (5, 7), clockwise and counter-clockwise.
    const Ring square{{4, 6}, {6, 6}, {6, 8}, {4, 8}}, reversed{{4, 8}, {6, 8}, {6, 6}, {4, 6}};
    const Ring whole{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    CHECK(ring_in_pixel(square, {5, 7}) == whole);
    CHECK(ring_in_pixel(reversed, {5, 7}) == whole);
    CHECK(ring_in_pixel(square, {6, 7}).empty());  // it touches that pixel along an edge
    CHECK(ring_in_pixel(square, {9, 9}).empty());
}

TEST_CASE("ring_in_pixel: repeated and collinear points go, rings without area are empty",
          "[peers][degenerate]") {
    CHECK(ring_in_pixel(Ring{{0, 0}, {0, 0}, {0.5, 0}, {1, 0}, {0, 1}, {0, 0.5}}, {}) ==
          Ring{{0, 0}, {1, 0}, {0, 1}});
    CHECK(ring_in_pixel(Ring{{0, 0}, {0.5, 0.5}, {1, 1}}, {}).empty());
    CHECK(ring_in_pixel(Ring{{0.5, 0.5}}, {}).empty());
    CHECK(ring_in_pixel(Ring{}, {}).empty());
}

TEST_CASE("ring_in_pixel: an edge of a million pixels is cut where it crosses, to the last bit",
          "[peers][degenerate]") {
    // Through (1/2, 1/2), from (-1e6, -1e6) to (1e6, 1e6) and far below: the lower right half.
    const Ring huge{{-1e6, -1e6}, {1e6, 1e6}, {1e6, -1e6}};
    CHECK(ring_in_pixel(huge, {}) == Ring{{0, 0}, {1, 0}, {1, 1}});
    // y = x / 3 crosses x = 1 at the double nearest to 1/3.
    const Ring third{{-3e6, -1e6}, {3e6, -1e6}, {3e6, 1e6}};
    CHECK(ring_in_pixel(third, {}) == Ring{{0, 0}, {1, 0}, {1, 1.0 / 3}});
}

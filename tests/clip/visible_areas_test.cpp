// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/visible_areas.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "answers.hpp"

using namespace keikan;
using namespace keikan::test;

TEST_CASE("visible_areas: without faces all is background", "[clip]") {
    const Answer seen = ask(std::vector<Ring>{});
    CHECK(seen.parts.empty());
    CHECK(seen.background == 1);
}

TEST_CASE("visible_areas: a face over the whole pixel has area 1 and its centre as centroid, exactly",
          "[clip]") {
    for (const Ring& ring : {kPixel, Ring{{-3, -8}, {9, 0.5}, {-2, 8}},
                             Ring{{1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}, {-1e6, -1e6}}}) {
        const Answer seen = ask({ring});
        REQUIRE(seen.parts.size() == 1);
        CHECK(seen.parts[0].area == 1);
        CHECK(seen.parts[0].centroid == Point{0.5, 0.5});
        CHECK(seen.background == 0);
    }
}

TEST_CASE("visible_areas: a face hidden behind one over the whole pixel takes nothing from it, exactly",
          "[clip][depth]") {
    // The triangle's plane reaches nearer than the square's, but not where the triangle is.
    const Answer seen =
        ask({Ring{{0.1, 0.1}, {0.9, 0.2}, {0.3, 0.7}}, Ring{{-1, -1}, {3, -1}, {-1, 3}}, kPixel},
            {{{0, 0, 1}, {1, 1, 1.5}, {0, 0, 1}}});
    REQUIRE(seen.parts.size() == 1);
    CHECK(seen.parts[0].face == 1);
    CHECK(seen.parts[0].area == 1);
    CHECK(seen.parts[0].centroid == Point{0.5, 0.5});
    CHECK(seen.background == 0);
}

TEST_CASE("visible_areas: a wire a sixteenth of a pixel thick covers a sixteenth", "[clip][wire]") {
    const Answer seen = ask({Ring{{-100, 0.25}, {100, 0.25}, {100, 0.3125}, {-100, 0.3125}}});
    REQUIRE(seen.parts.size() == 1);
    CHECK(seen.parts[0].area == Approx(1.0 / 16).margin(kVisibleAreaError).epsilon(0));
    CHECK(seen.parts[0].centroid.x == Approx(0.5).margin(1e-15).epsilon(0));
    CHECK(seen.parts[0].centroid.y == Approx(0.28125).margin(1e-15).epsilon(0));
}

TEST_CASE("visible_areas: two faces that share an edge leave no gap between them", "[clip][degenerate]") {
    const Point a{-0.3, 0.1}, b{1.7, 0.9};
    const Answer seen = ask({Ring{a, b, {3, -5}, {-3, -5}}, Ring{a, b, {3, 6}, {-3, 6}}});
    CHECK(seen.background == 0);
    CHECK(seen.sum() == Approx(1).margin(kAreaSumError).epsilon(0));
}

TEST_CASE("visible_areas: faces without area show nothing", "[clip][degenerate]") {
    const Answer seen = ask({Ring{}, Ring{{0.5, 0.5}}, Ring{{0, 0}, {1, 1}}, Ring{{0, 0}, {0.5, 0.5}, {1, 1}},
                             Ring{{0.2, 0.2}, {0.2, 0.2}, {0.2, 0.2}}, Ring{{-1, -1}, {0, 3}, {0, 0}},
                             Ring{{1, 0}, {2, 0}, {2, 1}, {1, 1}}});
    CHECK(seen.parts.empty());
    CHECK(seen.background == 1);
}

TEST_CASE("visible_areas: an outline that rounding folded is taken as its convex hull",
          "[clip][degenerate]") {
    const Answer seen = ask({Ring{{0, 0}, {1, 1}, {1, 0}, {0, 1}}});
    CHECK(seen.area(0) == 1);
}

TEST_CASE("visible_areas: in order, the earlier face is seen, whatever the depth planes say", "[clip]") {
    PixelCase pixel_case;
    pixel_case.polygons = {{{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}, kPixel};
    const std::vector<FaceView> faces = pixel_case.faces();
    VisibleAreas visible_areas;
    const Answer seen = ask(visible_areas, {0, 0}, faces, Nearness::InOrder);
    CHECK(seen.area(0) == 0.5);
    CHECK(seen.area(1) == 0.5);
}

TEST_CASE("visible_areas: where w is equal everywhere the smaller id is seen", "[clip][depth]") {
    const DepthPlane plane{0.125, -3, 7};
    for (const FaceId first : {FaceId{3}, FaceId{8}}) {
        const FaceView faces[] = {{first, kPixel, plane}, {5, kPixel, plane}};
        VisibleAreas visible_areas;
        const Answer seen = ask(visible_areas, {0, 0}, faces, Nearness::ByDepth);
        CHECK(seen.area(0) == (first < 5 ? 1 : 0));
        CHECK(seen.area(1) == (first < 5 ? 0 : 1));
    }
}

TEST_CASE("visible_areas: the pieces of each face add up to its area", "[clip][pieces]") {
    double worst = 0;
    VisibleAreas visible_areas;
    for_all_families(17, 20, [&](const PixelCase& pixel_case, Dice&, std::string_view) {
        const std::vector<FaceView> faces = pixel_case.faces();
        const Answer seen = ask(visible_areas, pixel_case.pixel, faces, pixel_case.nearness());
        std::vector<double> sums(faces.size());
        double free = 0;
        for (const VisiblePiece& piece : visible_areas.pieces()) {
            double twice = 0;
            for (std::size_t i = 2; i < piece.ring.size(); ++i) {
                const Point o = piece.ring[0], p = piece.ring[i - 1], q = piece.ring[i];
                twice += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
            }
            (piece.face == VisiblePiece::kBackground ? free : sums[piece.face]) += twice / 2;
        }
        worst = std::max(worst, std::abs(free - seen.background));
        for (std::uint32_t i = 0; i < faces.size(); ++i)
            worst = std::max(worst, std::abs(sums[i] - seen.area(i)));
    });
    CHECK(worst <= kAreaSumError);
}

// SPDX-License-Identifier: Apache-2.0
#include "../../src/scan/edge_moments.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "keikan/clip/visible_areas.hpp"

using namespace keikan;

namespace {

Moments moments(const Ring& ring, PixelIndex pixel) {
    Moments sum;
    for (std::size_t i = 0; i < ring.size(); ++i)
        sum += edge_moments(ring[i], ring[(i + 1) % ring.size()], pixel);
    return sum;
}

}  // namespace

TEST_CASE("edge_moments: a triangle within the pixel has its area and centroid", "[scan][layer]") {
    const Moments m = moments({{5.25, 7.25}, {5.75, 7.25}, {5.25, 7.5}}, {5, 7});
    CHECK(m.area == 1.0 / 16);
    CHECK(m.x / m.area == Approx(0.25 + 0.5 / 3));
    CHECK(m.y / m.area == Approx(0.25 + 0.25 / 3));
}

TEST_CASE("edge_moments: what reaches beyond the pixel counts only within it", "[scan][layer]") {
    const Moments all = moments({{-3, -3}, {9, -3}, {9, 9}, {-3, 9}}, {2, 2});
    CHECK(all.area == 1);
    CHECK(all.x == 0.5);
    CHECK(all.y == 0.5);
    // Below the diagonal of pixel (2, 2).
    const Moments half = moments({{-3, -3}, {9, 9}, {-3, 9}}, {2, 2});
    CHECK(half.area == 0.5);
    CHECK(half.x / half.area == Approx(1.0 / 3));
    CHECK(half.y / half.area == Approx(2.0 / 3));
    CHECK(moments({{-3, -3}, {9, 9}, {-3, 9}}, {4, 2}).area == 0);
}

TEST_CASE("edge_moments: an edge run backwards contributes exactly the negative (1)", "[scan][layer]") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-3, 4);
    for (int trial = 0; trial < 10000; ++trial) {
        const Point p{place(random), place(random)}, q{place(random), place(random)};
        Moments sum = edge_moments(p, q, {0, 0});
        sum += edge_moments(q, p, {0, 0});
        CHECK((sum.area == 0 && sum.x == 0 && sum.y == 0));
    }
}

TEST_CASE("edge_moments: areas of triangles from a hundredth to a million pixels are those of visible_areas",
          "[scan][layer]") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0, 1);
    VisibleAreas visible_areas;
    double worst = 0;
    for (int trial = 0; trial < 40000; ++trial) {
        const PixelIndex pixel{static_cast<int>(random() % 4000), static_cast<int>(random() % 2000)};
        const double extent = std::pow(10.0, -2 + 8 * unit(random));
        Ring ring;
        for (int i = 0; i < 3; ++i)
            ring.push_back({pixel.x + unit(random) + extent * (unit(random) - 0.5),
                            pixel.y + unit(random) + extent * (unit(random) - 0.5)});
        const FaceView face{0, ring, {0, 0, 1}};
        const PixelCoverage coverage = visible_areas(pixel, std::span(&face, 1), Nearness::InOrder);
        const double area = coverage.parts.empty() ? 0 : coverage.parts[0].area;
        worst = std::max(worst, std::abs(std::abs(moments(ring, pixel).area) - area));
    }
    CHECK(worst <= 2 * kVisibleAreaError);
}

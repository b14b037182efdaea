// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/sample_count.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace keikan;

namespace {

/// A camera 10 m above the water, looking along +y: rays through (x, z) on a screen at distance 1.
std::array<ViewRay, 4> screen_square(double x0, double x1, double z0, double z1) {
    const glm::dvec3 eye{0, 0, 10};
    return {{{eye, {x0, 1, z0}}, {eye, {x1, 1, z0}}, {eye, {x1, 1, z1}}, {eye, {x0, 1, z1}}}};
}

}  // namespace

TEST_CASE("water_footprint: a pixel below the horizon is a trapezoid on the water", "[wave][footprint]") {
    // Screen heights -1/5 and -1/10 lie 50 m and 100 m away; the width +-1/10 is +-5 m and +-10 m there.
    const WaterFootprint footprint = water_footprint(screen_square(-0.1, 0.1, -0.2, -0.1), 1e6);
    REQUIRE(footprint.count == 4);
    CHECK_FALSE(footprint.reaches_horizon);
    CHECK(footprint.extent_m({0, 1}) == Approx(50).epsilon(1e-14));
    CHECK(footprint.extent_m({1, 0}) == Approx(20).epsilon(1e-14));
    // From (-5, 50) to (10, 100), along (0.6, 0.8): 15 * 0.6 + 50 * 0.8.
    CHECK(footprint.extent_m({0.6, 0.8}) == Approx(49).epsilon(1e-14));
    CHECK(footprint.corners[0].x == Approx(-5).epsilon(1e-14));
    CHECK(footprint.corners[2].y == Approx(100).epsilon(1e-14));
}

TEST_CASE("water_footprint: a pixel on the horizon is cut at the farthest distance", "[wave][footprint]") {
    const WaterFootprint footprint = water_footprint(screen_square(-0.1, 0.1, -0.1, 0.1), 5000);
    CHECK(footprint.reaches_horizon);
    REQUIRE(footprint.count == 4);
    CHECK(footprint.extent_m({0, 1}) == Approx(4900).epsilon(1e-12));
    CHECK(footprint.extent_m({1, 0}) == Approx(1000).epsilon(1e-12));
}

TEST_CASE("water_footprint: a tilted horizon may leave three or five corners", "[wave][footprint]") {
    const glm::dvec3 eye{0, 0, 10};
    const auto tilted = [&](double a, double b, double c, double d) {
        return water_footprint({{{eye, {-1, 1, a}}, {eye, {1, 1, b}}, {eye, {1, 1, c}}, {eye, {-1, 1, d}}}},
                               1e5);
    };
    CHECK(tilted(-0.1, 0.1, 0.3, 0.1).count == 3);
    CHECK(tilted(-0.1, -0.1, 0.1, -0.1).count == 5);
    CHECK(tilted(-0.1, -0.1, -0.3, -0.3).count == 4);
}

TEST_CASE("water_footprint: a pixel above the horizon has none", "[wave][footprint]") {
    const WaterFootprint footprint = water_footprint(screen_square(-0.1, 0.1, 0, 0.1), 5000);
    CHECK(footprint.count == 0);
    CHECK(footprint.reaches_horizon);
    CHECK(footprint.extent_m({1, 0}) == 0);
}

TEST_CASE("water_footprint: an orthographic pixel is a parallelogram", "[wave][footprint]") {
    const glm::dvec3 down{0, 0.6, -0.8};
    // 1 m by 1 m across the ray; on the water 1 m by 1.25 m.
    const WaterFootprint footprint = water_footprint(
        {{{{0, 0, 8}, down}, {{1, 0, 8}, down}, {{1, 0.8, 8.6}, down}, {{0, 0.8, 8.6}, down}}}, 1e4);
    REQUIRE(footprint.count == 4);
    CHECK(footprint.extent_m({1, 0}) == Approx(1).epsilon(1e-14));
    CHECK(footprint.extent_m({0, 1}) == Approx(1.25).epsilon(1e-14));
}

TEST_CASE("paper_first_count: equation (1)", "[wave][count]") {
    // 50 m deep and 20 m wide. Along y: A = 0.1, lambda = 5: 10 cycles; along x: A = 0.2, lambda = 4: 5
    // cycles. N = 800 (0.1 * 10 + 0.2 * 5) = 1600.
    const WaterFootprint footprint = water_footprint(screen_square(-0.1, 0.1, -0.2, -0.1), 1e6);
    const std::vector<StokesWave> waves{{0.1, 5, std::numbers::pi / 2, 0}, {0.2, 4, 0, 0}};
    const WaveSurface water(waves);
    CHECK(paper_first_count(water, footprint, {}) == 1600);
    PaperSampleCounts counts;
    counts.k_w = 8;
    CHECK(paper_first_count(water, footprint, counts) == 16);
    counts.most = 10;
    CHECK(paper_first_count(water, footprint, counts) == 10);
    counts.k_w = 0.001;
    CHECK(paper_first_count(water, footprint, counts) == 2);
    CHECK(paper_first_count(WaveSurface(), footprint, {}) == 2);
}

TEST_CASE("paper_second_count: equation (3)", "[wave][count]") {
    CHECK(paper_second_count(10'000, {}) == 12);
    CHECK(paper_second_count(100, {}) == 6);
    CHECK(paper_second_count(1, {}) == 0);
    CHECK(paper_second_count(0.01, {}) == 0);
    CHECK(paper_second_count(0, {}) == 0);
    CHECK(paper_second_count(std::nan(""), {}) == 0);
}

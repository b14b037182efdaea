// SPDX-License-Identifier: Apache-2.0
#include "convex_outline.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "degenerate_pixels.hpp"
#include "keikan/clip/orient2d.hpp"

namespace {

using namespace keikan;
using namespace keikan::clip;
using Rational = boost::multiprecision::cpp_rational;

/// The outline in the pixel as the engine gets it.
std::vector<Point> clipped(PixelIndex pixel, std::vector<Point> outline) {
    if (turning(outline) == Turning::NotStrictlyConvex) replace_by_hull(outline);
    if (outline.size() < 3) return {};
    const ConvexOutline convex(outline, turning(outline) == Turning::Negative);
    std::vector<EdgeView> views;
    std::vector<Point> scratch;
    if (overlap(pixel, convex, views) != Overlap::Part) return {};
    const std::span<const Point> ring = clip_to_pixel(pixel, convex, views, scratch);
    return {ring.begin(), ring.end()};
}

}  // namespace

TEST_CASE("turning: a pentagram turns one way at every corner and is not convex", "[clip][convex]") {
    std::vector<Point> star;
    for (int i = 0; i < 5; ++i) star.push_back({std::cos(i * 4 * M_PI / 5), std::sin(i * 4 * M_PI / 5)});
    CHECK(turning(star) == Turning::NotStrictlyConvex);
    replace_by_hull(star);
    CHECK(star.size() == 5);
    CHECK(turning(star) == Turning::Positive);
}

TEST_CASE("turning: three corners on a line, or one repeated, are not strictly convex", "[clip][convex]") {
    CHECK(turning(std::vector<Point>{{0, 0}, {1, 0}, {2, 0}, {1, 3}}) == Turning::NotStrictlyConvex);
    CHECK(turning(std::vector<Point>{{0, 0}, {0, 0}, {2, 0}, {1, 3}}) == Turning::NotStrictlyConvex);
    CHECK(turning(std::vector<Point>{{0, 0}, {2, 0}, {1, 3}}) == Turning::Positive);
    CHECK(turning(std::vector<Point>{{0, 0}, {1, 3}, {2, 0}}) == Turning::Negative);
}

TEST_CASE("replace_by_hull: points on a line have no hull with area", "[clip][convex]") {
    std::vector<Point> line{{3, 3}, {0, 0}, {1, 1}, {2, 2}, {1, 1}};
    replace_by_hull(line);
    CHECK(line.size() < 3);
}

TEST_CASE("overlap: an outline that only touches the pixel has nothing in it or is clipped to nothing",
          "[clip][convex]") {
    CHECK(clipped({0, 0}, {{1, 1}, {2, 1}, {2, 2}}).empty());
    CHECK(clipped({0, 0}, {{0.5, 1.5}, {1.5, 0.5}, {2, 2}}).empty());  // its edge runs through the corner
    CHECK(clipped({0, 0}, {{0, 0}, {1, 0}, {0.5, -1}}).empty());
}

TEST_CASE("clip_to_pixel: an edge through two opposite corners leaves exactly half", "[clip][convex]") {
    CHECK(clipped({7, 9}, {{-993, -991}, {1007, 1009}, {1007, -991}}) ==
          std::vector<Point>{{0, 0}, {1, 0}, {1, 1}});
}

TEST_CASE("clip_to_pixel: the ring is exactly strictly convex, on the 2^-53 grid, in the pixel",
          "[clip][convex][fuzz]") {
    for (const test::Family& family : test::families()) {
        test::Dice dice(5);
        for (int i = 0; i < 200; ++i) {
            const PixelCase pixel_case = test::random_pixel(family, dice, false);
            for (const Ring& outline : pixel_case.polygons) {
                const std::vector<Point> ring = clipped(pixel_case.pixel, outline);
                if (ring.empty()) continue;
                INFO(family.name);
                REQUIRE(turning(ring) == Turning::Positive);
                for (const Point p : ring)
                    for (const double v : {p.x, p.y})
                        REQUIRE((v >= 0 && v <= 1 && std::ldexp(v, 53) == std::floor(std::ldexp(v, 53))));
            }
        }
    }
}

TEST_CASE("clip_to_pixel: a crossing is within 3/4 of a grid step of the exact one, whatever the extent",
          "[clip][convex]") {
    test::Dice dice(6);
    const PixelIndex pixel{4095, 2159};
    for (int i = 0; i < 3000; ++i) {
        // An edge that enters on the left and leaves on the right, its ends up to 2^90 pixels away.
        const double far = std::ldexp(1, dice.number(1, i % 4 == 0 ? 90 : 20));
        const double slope = dice.between(-0.2, 0.2);
        const Point p{pixel.x - far * dice.between(0.5, 1), pixel.y + dice.between(0.3, 0.7) - far * slope};
        const Point q{pixel.x + 1 + far * dice.between(0.5, 1),
                      pixel.y + dice.between(0.3, 0.7) + far * slope};
        const std::vector<Point> ring = clipped(pixel, {p, q, {(p.x + q.x) / 2, pixel.y + 9 * far + 9}});
        for (const Point c : ring) {
            if ((c.x != 0 && c.x != 1) || c.y == 0 || c.y == 1) continue;
            const Rational x = Rational(pixel.x) + Rational(c.x), dx = Rational(q.x) - Rational(p.x);
            const Rational y =
                Rational(p.y) + (x - Rational(p.x)) * (Rational(q.y) - Rational(p.y)) / dx - pixel.y;
            const Rational error = abs(Rational(y - Rational(c.y)));
            REQUIRE(static_cast<double>(error) <= 0x1.8p-54);
        }
    }
}

TEST_CASE("clip_to_pixel: crossings of edges whose ends differ by any power of two", "[clip][convex]") {
    // Found by a fuzzer: the edge's width was lost beside its height, and the crossing was no number.
    const std::vector<Point> ring = clipped({0, 0}, {{0, 0.5}, {1, -0.125}, {-0x1.05p-758, -0x1.fep+548}});
    const auto near_one = [](const Ring& points, Point at) {
        return std::any_of(points.begin(), points.end(), [at](Point p) {
            return std::abs(p.x - at.x) <= 0x1.8p-54 && std::abs(p.y - at.y) <= 0x1.8p-54;
        });
    };
    CHECK(ring.size() == 3);
    for (const Point corner : {Point{0, 0}, Point{0.8, 0}, Point{0, 0.5}}) CHECK(near_one(ring, corner));

    test::Dice dice(7);
    const auto coordinate = [&dice] {
        const double sign = dice.number(0, 1) == 0 ? -1 : 1;
        return sign * std::ldexp(dice.between(1, 2),
                                 dice.number(0, 2) == 0 ? dice.number(-2, 2) : dice.number(-1074, 1022));
    };
    long crossings = 0;
    for (int i = 0; i < 3'000; ++i) {
        const Ring triangle{
            {coordinate(), coordinate()}, {coordinate(), coordinate()}, {coordinate(), coordinate()}};
        for (const Point c : clipped({0, 0}, triangle)) {
            const bool upright = c.x == 0 || c.x == 1, level = c.y == 0 || c.y == 1;
            if (upright == level) continue;    // a corner of the pixel, or of the triangle
            bool met = near_one(triangle, c);  // a corner may be snapped onto the border
            for (std::size_t e = 0; e < 3 && !met; ++e) {
                Point p = triangle[e], q = triangle[(e + 1) % 3], at = c;
                if (level) std::swap(p.x, p.y), std::swap(q.x, q.y), std::swap(at.x, at.y);
                if (p.x == q.x || (p.x < at.x) == (q.x < at.x)) continue;
                const Rational run = Rational(q.x) - Rational(p.x);
                const Rational y =
                    Rational(p.y) + (Rational(at.x) - Rational(p.x)) * (Rational(q.y) - Rational(p.y)) / run;
                met = abs(Rational(y - Rational(at.y))) <= Rational(0x1.8p-54);
            }
            INFO(c.x << " " << c.y);
            REQUIRE(met);
            ++crossings;
        }
    }
    CHECK(crossings > 100);
}

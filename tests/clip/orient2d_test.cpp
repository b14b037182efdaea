// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/orient2d.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace {

using keikan::orient2d;
using keikan::Point;
using keikan::Sign;
using Rational = boost::multiprecision::cpp_rational;

Sign rational_orient2d(Point a, Point b, Point c) {
    const Rational cx(c.x), cy(c.y);
    const Rational d =
        (Rational(a.x) - cx) * (Rational(b.y) - cy) - (Rational(a.y) - cy) * (Rational(b.x) - cx);
    return static_cast<Sign>(d.sign());
}

}  // namespace

TEST_CASE("orient2d: positive when the path turns from +x towards +y", "[clip][orient2d]") {
    CHECK(orient2d({0, 0}, {1, 0}, {1, 1}) == Sign::Positive);
    CHECK(orient2d({0, 0}, {1, 1}, {1, 0}) == Sign::Negative);
    CHECK(orient2d({0, 0}, {1, 1}, {3, 3}) == Sign::Zero);
}

TEST_CASE("orient2d: a point one ulp off a line is seen on its side", "[clip][orient2d]") {
    const double third = 1.0 / 3;
    CHECK(orient2d({0, 0}, {3, 3}, {third, std::nextafter(third, 1)}) == Sign::Positive);
    CHECK(orient2d({0, 0}, {3, 3}, {third, std::nextafter(third, 0)}) == Sign::Negative);
    CHECK(orient2d({0, 0}, {3, 3}, {third, third}) == Sign::Zero);
    CHECK(orient2d({1e6, 1e6}, {-1e6, -1e6}, {0x1p-900, 0}) == Sign::Positive);
}

TEST_CASE("orient2d: neither very large nor very small coordinates change the sign", "[clip][orient2d]") {
    CHECK(orient2d({0, 0}, {1e308, 0}, {1e308, 1e308}) == Sign::Positive);
    CHECK(orient2d({-1e308, -1e308}, {1e308, 1e308}, {1e308, -1e308}) == Sign::Negative);
    CHECK(orient2d({0, 0}, {0x1p-1074, 0}, {0, 0x1p-1074}) == Sign::Positive);
    CHECK(orient2d({1e-300, 2e-300}, {3e-300, 2e-300}, {3e-300, 1e-300}) == Sign::Negative);
}

TEST_CASE("orient2d: agrees with rational arithmetic on nearly collinear points", "[clip][orient2d]") {
    constexpr unsigned kSeed = 20240917;
    INFO("seed " << kSeed);
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::uniform_int_distribution<int> step(-2, 2), exponent(-40, 40);
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        const double scale = std::ldexp(1.0, exponent(random));
        Point a{unit(random) * scale, unit(random) * scale}, b{unit(random), unit(random)};
        if (i % 3 == 0) {  // on a coarse grid, where exact zeros are frequent
            a = {std::round(8 * a.x / scale), std::round(8 * a.y / scale)};
            b = {std::round(8 * b.x), std::round(8 * b.y)};
        }
        const double t = i % 3 == 0 ? step(random) : unit(random);
        Point c{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
        for (int k = step(random); k != 0; k += k > 0 ? -1 : 1) c.x = std::nextafter(c.x, k > 0 ? 2e9 : -2e9);
        const Sign truth = rational_orient2d(a, b, c);
        zeros += truth == Sign::Zero;
        REQUIRE(orient2d(a, b, c) == truth);
        REQUIRE(orient2d(b, c, a) == truth);   // (1)
        REQUIRE(orient2d(b, a, c) == -truth);  // (1)
        REQUIRE(orient2d({a.x * 0x1p300, a.y * 0x1p300}, {b.x * 0x1p300, b.y * 0x1p300},
                         {c.x * 0x1p300, c.y * 0x1p300}) == truth);  // (2)
    }
    CHECK(zeros > 100);
}

TEST_CASE("orient2d: exact for coordinates of all sizes at once, denormal ones too", "[clip][orient2d]") {
    constexpr double kSizes[] = {0,       0x1p-1074, 0x3p-1074, -0x1p-1074, 1e-310, 1e-300, 0x1p-1022, 1e-160,
                                 0x1p-53, 1,         -1,        3,          1e160,  1e300,  0x1p1023};
    std::mt19937_64 random(3);
    const auto any = [&] { return kSizes[random() % std::size(kSizes)] * (random() % 2 == 0 ? 1 : 0.75); };
    long zeros = 0, tiny = 0;
#ifdef KEIKAN_DEBUG_CHECKS
    constexpr int kTriples = 500;  // rational arithmetic is slow under a sanitizer
#else
    constexpr int kTriples = 2000;
#endif
    for (int i = 0; i < kTriples; ++i) {
        const Point a{any(), any()}, b{any(), any()}, c{any(), any()};
        const Sign truth = rational_orient2d(a, b, c);
        zeros += truth == Sign::Zero;
        tiny += truth != Sign::Zero && std::abs((a.x - c.x) * (b.y - c.y)) < 0x1p-1074;
        REQUIRE(orient2d(a, b, c) == truth);
    }
    CHECK(zeros > kTriples / 200);
    CHECK(tiny > kTriples / 200);
    CHECK(orient2d({0x1p-1074, 0}, {0, 0}, {0, 0x1p-1074}) == Sign::Negative);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic below the certified rung, against GMP.
#include <catch2/catch.hpp>

#include <gmpxx.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "oracle/convex_outline.hpp"
#include "oracle/exact_double.hpp"
#include "oracle/exact_lines.hpp"
#include "oracle/wide_integer.hpp"

using namespace keikan;
using namespace keikan::oracle;

namespace {

template <int N>
mpz_class as_mpz(const WideInteger<N>& value) {
    mpz_class result;
    assign(result.get_mpz_t(), value);
    return result;
}

/// Of any length up to 64 N - 2 bits, of either sign, with runs of zeros and ones, where carries go wrong.
template <int N>
WideInteger<N> any_number(std::mt19937_64& random) {
    WideInteger<N> number;
    for (std::uint64_t& limb : number.limb) {
        const auto kind = random() % 4;
        limb = kind == 0 ? 0 : kind == 1 ? ~std::uint64_t{0} : random();
    }
    const bool negative = random() % 2 == 0;
    std::uint64_t& top = number.limb.back();
    top = negative ? top | (std::uint64_t{3} << 62) : top & ~(std::uint64_t{3} << 62);
    return number;
}

mpq_class exact(double value) {
    return mpq_class(value);
}

int exact_turn(Point p, Point q, Point r) {
    const mpq_class turn = (exact(p.x) - exact(r.x)) * (exact(q.y) - exact(r.y)) -
                           (exact(p.y) - exact(r.y)) * (exact(q.x) - exact(r.x));
    return sgn(turn);
}

}  // namespace

TEST_CASE("wide integers: sums, differences, products and signs are those of GMP", "[oracle]") {
    std::mt19937_64 random(1);
    for (int n = 0; n < 5000; ++n) {
        const auto a = any_number<2>(random), b = any_number<2>(random);
        const auto c = any_number<4>(random);
        const auto d = any_number<6>(random);
        REQUIRE(as_mpz(a + b) == as_mpz(a) + as_mpz(b));
        REQUIRE(as_mpz(a - b) == as_mpz(a) - as_mpz(b));
        REQUIRE(as_mpz(-c) == -as_mpz(c));
        REQUIRE(as_mpz(a * b) == as_mpz(a) * as_mpz(b));
        REQUIRE(as_mpz(a * c) == as_mpz(a) * as_mpz(c));
        REQUIRE(as_mpz(c * b) == as_mpz(c) * as_mpz(b));
        REQUIRE(as_mpz(a * d) == as_mpz(a) * as_mpz(d));
        REQUIRE(c.sign() == sgn(as_mpz(c)));
    }
}

TEST_CASE("wide integers: the leading digits are off by less than one unit", "[oracle]") {
    std::mt19937_64 random(2);
    for (int n = 0; n < 5000; ++n) {
        const auto value = any_number<6>(random);
        const auto [mantissa, exponent] = leading(value);
        if (value.sign() == 0) {
            REQUIRE(mantissa == 0);
            continue;
        }
        mpz_class digits(std::to_string(static_cast<std::uint64_t>(std::abs(mantissa))));
        const mpz_class size = abs(as_mpz(value));
        REQUIRE((mantissa < 0) == (value.sign() < 0));
        if (exponent >= 0)
            REQUIRE((size >> static_cast<mp_bitcnt_t>(exponent)) == digits);
        else
            REQUIRE((size << static_cast<mp_bitcnt_t>(-exponent)) == digits);
    }
}

TEST_CASE("orientation: the sign is exact, whatever the doubles", "[oracle]") {
    std::mt19937_64 random(3);
    const auto coordinate = [&random] {
        switch (random() % 6) {
            case 0:
                return std::ldexp(static_cast<double>(random() % 16), -1074);
            case 1:
                return std::ldexp(static_cast<double>(random() >> 11),
                                  -1060 + static_cast<int>(random() % 2000));
            case 2:
                return static_cast<double>(random() % 4);
            case 3:
                return -0.0;
            default:
                return std::ldexp(static_cast<double>(random() >> 11), -53) * 4 - 2;
        }
    };
    for (int n = 0; n < 20000; ++n) {
        const Point p = {coordinate(), coordinate()}, q = {coordinate(), coordinate()};
        Point r = {coordinate(), coordinate()};
        if (n % 3 == 0) r = {p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2};  // on the line, or next to it
        if (!std::isfinite(r.x) || !std::isfinite(r.y)) continue;
        REQUIRE(orientation(p, q, r) == exact_turn(p, q, r));
    }
}

TEST_CASE("convex_outline: hull, orientation and repeated points do not change the ring", "[oracle]") {
    std::vector<Point> ring;
    const std::vector<Point> triangle = {{0, 0}, {1, 0}, {1, 1}};
    convex_outline(std::vector<Point>{{1, 1}, {1, 0}, {0, 0}, {0, 0}}, ring);
    CHECK(ring == std::vector<Point>{{0, 0}, {1, 0}, {1, 1}});
    convex_outline(std::vector<Point>{{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0.75, 0.5}}, ring);
    CHECK(ring == triangle);
    convex_outline(std::vector<Point>{{0, 0}, {1, 1}, {0, 0}, {1, 1}}, ring);
    CHECK(ring.empty());
    // A pentagram turns left at every corner, and goes round twice: its hull is the pentagon.
    const std::vector<Point> star = {{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}};
    convex_outline(star, ring);
    CHECK(ring.size() == 5);
    CHECK(ring == std::vector<Point>{{-3, 1}, {-2, -3}, {2, -3}, {3, 1}, {0, 3}});
}

TEST_CASE("exact lines: an edge is one line from either side, and three through one corner meet there",
          "[oracle]") {
    ExactLines lines;
    lines.start({4095, 2159});
    const Point p = {4095.1, 2159.7}, q = {4095.9, 2159.3}, r = {4094.3, 2158.1}, s = {4096.7, 2162.1};
    const SidedLine there = lines.line_through(p, q), back = lines.line_through(q, p);
    CHECK(there.line == back.line);
    CHECK(there.sense == -back.sense);
    const SidedLine second = lines.line_through(p, r), third = lines.line_through(s, p);
    const VertexId corner = lines.meeting_point(there.line, second.line);
    CHECK(lines.side(corner, third) == 0);
    CHECK(std::abs(lines.vertex(corner).x - (p.x - 4095)) <= 0x1p-53);
}

TEST_CASE("exact lines: a vertex one unit in the last place beside a line is beside it", "[oracle]") {
    ExactLines lines;
    lines.start({0, 0});
    const double below = std::nextafter(0.5, 0), above = std::nextafter(0.5, 1);
    const LineId upright = lines.line_through({0.5, 0}, {0.5, 1}).line;
    const VertexId left = lines.meeting_point(lines.line_through({below, 0}, {below, 1}).line, 0);
    const VertexId right = lines.meeting_point(lines.line_through({above, 0}, {above, 1}).line, 0);
    const VertexId on = lines.meeting_point(upright, 0);
    CHECK(lines.side(left, upright) == 1);  // travelling towards +y, the smaller x is to the left
    CHECK(lines.side(right, upright) == -1);
    CHECK(lines.side(on, upright) == 0);
    // The same beside a line whose numbers do not fit any fixed length.
    const double least = std::numeric_limits<double>::denorm_min();
    const LineId beside = lines.line_through({least, 0}, {least, 1}).line;
    CHECK(lines.side(lines.meeting_point(3, 0), beside) == 1);
    CHECK(lines.side(lines.meeting_point(beside, 0), 3) == 1);  // inside the pixel's border x >= 0
}

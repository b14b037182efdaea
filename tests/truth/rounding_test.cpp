// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth/rounding.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

using namespace keikan::truth;

namespace {

/// A number in (0, 1), of every size down to 2^-1000.
double draw(std::uint64_t n) {
    std::uint64_t z = (n + 1) * 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z ^= z >> 31;
    const int exponent = n % 3 == 0 ? 0 : n % 3 == 1 ? static_cast<int>(z % 160) : static_cast<int>(z % 1000);
    return std::ldexp(static_cast<double>(z >> 11) * 0x1p-53, -exponent);
}

}  // namespace

TEST_CASE("nearest_float: of a double it is the processor's own rounding", "[truth][rounding]") {
    for (std::uint64_t n = 0; n < 20'000; ++n) {
        const double value = draw(n);
        REQUIRE(nearest_float(mpq_class(value)) == static_cast<float>(value));
    }
    for (const double value :
         {0.0, 1.0, 0.5, 0x1p-149, 0x1p-150, 0x1.8p-149, 0x1p-151, 0x1.fffffep-127, 0x1.ffffffp-1})
        CHECK(nearest_float(mpq_class(value)) == static_cast<float>(value));
}

TEST_CASE("nearest_float: a fraction on either side of the middle goes to the nearer float",
          "[truth][rounding]") {
    const mpq_class middle(0x1p-1 + 0x1p-25);  // between 1/2 and the next float, 1/2 + 2^-24; 1/2 is even
    const mpq_class little =
        mpq_class(1) / mpq_class("1000000000000000000000000000000000000000000000000000000003");
    CHECK(nearest_float(middle) == 0.5f);
    CHECK(nearest_float(middle + little) == 0x1.000002p-1f);
    CHECK(nearest_float(middle - little) == 0.5f);
    CHECK(nearest_float(mpq_class(1) / 3) == 1.0f / 3);
    CHECK(nearest_float(mpq_class(1) - little) == 1.0f);
    CHECK(nearest_float(little) == 0);  // far below the smallest float
}

TEST_CASE("nearest_code: exact for fractions and for doubles, ties upwards", "[truth][rounding]") {
    CHECK(nearest_code(mpq_class(1) / 2) == 32768);  // 32767.5
    CHECK(nearest_code(0.5) == 32768);
    CHECK(nearest_code(std::nextafter(0.5, 0.0)) == 32767);  // 65535 times it rounds to 32767.5 in doubles
    CHECK(nearest_code(mpq_class(1)) == 65535);
    CHECK(nearest_code(1.0) == 65535);
    CHECK(nearest_code(mpq_class(1) / 131070) == 1);
    CHECK(nearest_code(mpq_class(1) / 131071) == 0);
    CHECK(nearest_code(-1e-17) == 0);
    CHECK(nearest_code(1 + 1e-15) == 65535);
    for (std::uint64_t n = 0; n < 20'000; ++n) {
        const double value = draw(n);
        REQUIRE(nearest_code(value) == nearest_code(mpq_class(value)));
    }
}

TEST_CASE("a range that leaves two roundings possible has none", "[truth][rounding]") {
    CHECK(nearest_float(Range{0.25, 0.25 + 1e-12}) == 0.25f);
    CHECK_FALSE(nearest_float(Range{0x1p-1 + 0x1p-25 - 1e-16, 0x1p-1 + 0x1p-25 + 1.2e-16}).has_value());
    CHECK_FALSE(nearest_float(Range{-1e-18, 1e-18}).has_value());  // 0, or something very small
    CHECK(nearest_float(Range{1 - 1e-15, 1 + 1e-15}) == 1.0f);
    CHECK_FALSE(nearest_code(Range{0.5 - 1e-15, 0.5 + 1e-15}).has_value());
    CHECK(near_code_boundary(Range{0.5 + 1e-15, 0.5 + 2e-15}, 2e-15));
    CHECK_FALSE(near_code_boundary(Range{0.25, 0.25}, 1e-6));
}

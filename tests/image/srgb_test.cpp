// SPDX-License-Identifier: Apache-2.0
#include "keikan/image/srgb.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace keikan;

namespace {

/// The inverse transfer function again, from the standard and in long double: the reference.
long double reference_linear(long double encoded) {
    return encoded <= 0.04045L ? encoded / 12.92L : std::pow((encoded + 0.055L) / 1.055L, 2.4L);
}

}  // namespace

TEST_CASE("srgb: the two directions are each other's inverse, and meet the standard's values",
          "[image][srgb]") {
    CHECK(srgb_from_linear(0) == 0);
    CHECK(srgb_from_linear(1) == Approx(1).margin(1e-15));
    CHECK(srgb_from_linear(0.5) == Approx(0.7353569830524495).margin(1e-15));
    CHECK(linear_from_srgb(0.5) == Approx(0.21404114048223255).margin(1e-15));
    for (int i = 0; i <= 1000; ++i) {
        const double x = i / 1000.0;
        // The standard's two branches miss each other by 3e-8 where they meet.
        CHECK(linear_from_srgb(srgb_from_linear(x)) == Approx(x).margin(1e-7));
    }
}

TEST_CASE("SrgbCodes (1): a code begins exactly where the reference says, for every code", "[image][srgb]") {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const int bits : {8, 16}) {
        const SrgbCodes& codes = SrgbCodes::of_bits(bits);
        const int max = (1 << bits) - 1;
        int wrong = 0;
        for (int k = 1; k <= max; ++k) {
            const long double limit = reference_linear((k - 0.5L) / max);
            float first = static_cast<float>(limit);
            if (static_cast<long double>(first) < limit) first = std::nextafter(first, kInfinity);
            // The codes never fall (limits rise and every value lies between its two), so that both sides
            // of each limit stand for all floats.
            if (codes(first) != k || codes(std::nextafter(first, 0.0f)) != k - 1) ++wrong;
            if (bits == 8 && (codes.eight(first) != k || codes.eight(std::nextafter(first, 0.0f)) != k - 1))
                ++wrong;
            if (codes.limits()[static_cast<std::size_t>(k)] != first) ++wrong;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("SrgbCodes: what lies outside of [0, 1] takes the nearer end", "[image][srgb]") {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const int bits : {8, 16}) {
        const SrgbCodes& codes = SrgbCodes::of_bits(bits);
        const int max = (1 << bits) - 1;
        if (bits == 8) {
            for (const float x : {0.0f, -1.0f, -kInfinity, 1e-45f}) CHECK(codes.eight(x) == 0);
            for (const float x : {1.0f, 1.5f, kInfinity}) CHECK(codes.eight(x) == 255);
        }
        for (const float x : {0.0f, -0.0f, -1.0f, -kInfinity, 1e-45f, 1e-20f}) CHECK(codes(x) == 0);
        for (const float x : {1.0f, 1.5f, 3e38f, kInfinity}) CHECK(codes(x) == max);
    }
}

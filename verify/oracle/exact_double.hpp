// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gmpxx.h>

#include <bit>
#include <cstdint>
#include <optional>

#include "keikan/model/point.hpp"
#include "wide_integer.hpp"

namespace keikan::oracle {

/// A finite double as mantissa * 2^exponent with an odd mantissa; zero is {0, 0}.
struct BinaryFraction {
    std::int64_t mantissa = 0;
    int exponent = 0;
};

inline BinaryFraction binary_fraction(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const int biased = static_cast<int>(bits >> 52) & 0x7ff;
    auto mantissa = static_cast<std::int64_t>(bits & ((std::uint64_t{1} << 52) - 1));
    if (biased != 0) mantissa |= std::int64_t{1} << 52;
    if (mantissa == 0) return {};
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    mantissa >>= zeros;
    return {bits >> 63 ? -mantissa : mantissa, (biased == 0 ? 1 : biased) - 1075 + zeros};
}

/// value * 2^bits, if that is a whole number below 2^length in size. Requires: length <= 126.
inline std::optional<Int128> whole_number(double value, int bits, int length) {
    const auto [mantissa, exponent] = binary_fraction(value);
    if (mantissa == 0) return Int128{0};
    const int shift = exponent + bits;
    const int size = 64 - std::countl_zero(static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa));
    if (shift < 0 || shift + size > length) return std::nullopt;
    return static_cast<Int128>(mantissa) * (static_cast<Int128>(1) << shift);
}

/// value * 2^bits. Requires: that it is whole.
inline mpz_class whole_number_of_any_length(double value, int bits) {
    const auto [mantissa, exponent] = binary_fraction(value);
    mpz_class result(static_cast<long>(mantissa));
    if (mantissa != 0) result <<= static_cast<mp_bitcnt_t>(exponent + bits);
    return result;
}

/// 1 if p, q, r turn counter-clockwise (with y upwards), -1 if clockwise, 0 if they lie on one line. Exact
/// for all finite doubles.
int orientation(Point p, Point q, Point r);

}  // namespace keikan::oracle

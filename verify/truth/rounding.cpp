// SPDX-License-Identifier: GPL-3.0-or-later
#include "rounding.hpp"

#include <algorithm>
#include <cmath>

namespace keikan::truth {
namespace {

constexpr int kFloatBits = 24;
constexpr int kLastFloatBit = 149;  ///< 2^-149 is the smallest float above 0
constexpr double kMostCode = 65535;

}  // namespace

float nearest_float(const mpq_class& value) {
    const mpz_class& over = value.get_num();
    const mpz_class& under = value.get_den();
    if (over == 0) return 0;
    // Bits behind the point so that the quotient has 24 or 25 bits; a float keeps 24, and none behind 2^-149.
    const auto length = [](const mpz_class& n) { return static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
    int bits = std::min(kFloatBits + length(under) - length(over), kLastFloatBit);
    mpz_class quotient, rest;
    for (;; --bits) {
        mpz_class shifted_over = over, shifted_under = under;
        (bits >= 0 ? shifted_over : shifted_under) <<= static_cast<mp_bitcnt_t>(std::abs(bits));
        mpz_fdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), shifted_over.get_mpz_t(),
                    shifted_under.get_mpz_t());
        if (length(quotient) > kFloatBits) continue;
        const int half = cmp(2 * rest, shifted_under);
        if (half > 0 || (half == 0 && mpz_odd_p(quotient.get_mpz_t()) != 0)) ++quotient;
        break;
    }
    return static_cast<float>(std::ldexp(quotient.get_d(), -bits));
}

std::uint16_t nearest_code(const mpq_class& value) {
    const mpz_class code = (value.get_num() * 131070 + value.get_den()) / (2 * value.get_den());
    return static_cast<std::uint16_t>(code.get_ui());
}

std::uint16_t nearest_code(double value) {
    const double clamped = std::clamp(value, 0.0, 1.0);
    const double product = clamped * kMostCode;
    const double lost = std::fma(clamped, kMostCode, -product);
    const double whole = std::floor(product);
    // product - whole and its distance from 1/2 are exact: multiples of the product's last bit, below 1.
    const double beyond_half = product - whole - 0.5;
    const bool up = beyond_half != 0 ? beyond_half > 0 : lost >= 0;
    return static_cast<std::uint16_t>(whole + (up ? 1 : 0));
}

std::optional<float> nearest_float(Range range) {
    const auto low = static_cast<float>(std::clamp(range.low, 0.0, 1.0));
    const auto high = static_cast<float>(std::clamp(range.high, 0.0, 1.0));
    if (low != high) return std::nullopt;
    return low;
}

std::optional<std::uint16_t> nearest_code(Range range) {
    const std::uint16_t low = nearest_code(range.low);
    if (low != nearest_code(range.high)) return std::nullopt;
    return low;
}

bool near_code_boundary(Range range, double distance) {
    return !nearest_code(Range{range.low - distance, range.high + distance});
}

}  // namespace keikan::truth

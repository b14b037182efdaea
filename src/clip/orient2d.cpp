// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/orient2d.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "double_double.hpp"
#include "expansion.hpp"

namespace keikan {
namespace {

using clip::two_product;

/// Shewchuk's ccwerrboundA: the two differences, the two products and their difference are rounded.
constexpr double kFilter = (3 + 16 * clip::kHalfUlp) * clip::kHalfUlp;
/// No product that could underflow passes the filter.
constexpr double kSmallestFiltered = 0x1p-960;

Sign sign_of(double value) {
    return value > 0 ? Sign::Positive : value < 0 ? Sign::Negative : Sign::Zero;
}

/// A sum of products of any finite doubles, as one number in fixed point: two's complement, the lowest bit is
/// 2^-kBelowPoint. The smallest product is 2^-2148, the largest is below 2^2048.
class WideSum {
  public:
    void add(double a, double b) {
        if (a == 0 || b == 0) return;
        int exponent_a = 0, exponent_b = 0;
        const auto m = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(a), &exponent_a), 53));
        const auto n = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(b), &exponent_b), 53));
        const bool negative = (a < 0) != (b < 0);
        const int lowest = exponent_a + exponent_b - 106 + kBelowPoint;
        constexpr std::uint64_t kLowHalf = (std::uint64_t{1} << 27) - 1;
        for (const int i : {0, 27})
            for (const int j : {0, 27})
                add_bits((m >> i & kLowHalf) * (n >> j & kLowHalf), lowest + i + j, negative);
    }
    Sign sign() const {
        if (limb_.back() >> 63) return Sign::Negative;
        const bool zero =
            std::all_of(limb_.begin(), limb_.end(), [](std::uint64_t part) { return part == 0; });
        return zero ? Sign::Zero : Sign::Positive;
    }

  private:
    static constexpr int kBelowPoint = 2256;

    void add_bits(std::uint64_t bits, int position, bool negative) {
        const auto at = static_cast<std::size_t>(position / 64);
        const int shift = position % 64;
        const std::uint64_t parts[] = {bits << shift, shift == 0 ? 0 : bits >> (64 - shift)};
        std::uint64_t carry = 0;  // or borrow
        for (std::size_t i = at; i < limb_.size() && (i < at + 2 || carry != 0); ++i) {
            const std::uint64_t part = i < at + 2 ? parts[i - at] : 0, before = limb_[i];
            limb_[i] = negative ? before - part - carry : before + part + carry;
            const bool over = negative ? limb_[i] > before : limb_[i] < before;
            carry = over || (carry != 0 && limb_[i] == before) ? 1 : 0;
        }
    }

    std::array<std::uint64_t, 68> limb_{};  // 2048 + 2256 bits and a few for sums
};

/// The same sum where some coordinates are so much smaller than others that scaling would lose them.
Sign exact_sign_of_any(Point a, Point b, Point c) {
    const Point p[] = {a, b, c};
    WideSum determinant;
    for (int i = 0; i < 3; ++i) {
        const Point from = p[i], to = p[(i + 1) % 3];
        determinant.add(from.x, to.y);
        determinant.add(-from.y, to.x);
    }
    return determinant.sign();
}

/// a b + b c + c a as cross products, summed exactly. The coordinates are first brought near 2^490 by a
/// common power of two: their products then neither overflow nor, short of a factor 2^970, underflow.
Sign exact_sign(Point a, Point b, Point c) {
    const double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y),  //
                                     std::abs(c.x), std::abs(c.y)});
    if (largest == 0) return Sign::Zero;
    for (const double value : {a.x, a.y, b.x, b.y, c.x, c.y})
        if (value != 0 && std::abs(value) < largest * 0x1p-960) return exact_sign_of_any(a, b, c);
    const int shift = 490 - std::ilogb(largest);
    const auto scaled = [shift](Point p) { return Point{std::scalbn(p.x, shift), std::scalbn(p.y, shift)}; };
    const Point p[] = {scaled(a), scaled(b), scaled(c)};
    clip::Expansion<12> determinant;
    for (int i = 0; i < 3; ++i) {
        const Point from = p[i], to = p[(i + 1) % 3];
        determinant.add(two_product(from.x, to.y));
        determinant.add(two_product(-from.y, to.x));
    }
    return sign_of(determinant.largest());
}

}  // namespace

Sign orient2d(Point a, Point b, Point c) {
    const double acx = a.x - c.x, bcy = b.y - c.y;
    const double acy = a.y - c.y, bcx = b.x - c.x;
    const double left = acx * bcy, right = acy * bcx;
    const double determinant = left - right;
    const double error = kFilter * (std::abs(left) + std::abs(right)) + kSmallestFiltered;
    if (std::abs(determinant) > error && error < HUGE_VAL) return sign_of(determinant);
    // A difference of doubles is zero only when they are equal, so these zeros are exact.
    if ((acx == 0 || bcy == 0) && (acy == 0 || bcx == 0)) return Sign::Zero;
    return exact_sign(a, b, c);
}

}  // namespace keikan

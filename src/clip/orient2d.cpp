// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/orient2d.hpp"

#include <algorithm>
#include <cmath>

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

/// a b + b c + c a as cross products, summed exactly. The coordinates are first brought near 2^490 by a
/// common power of two: their products then neither overflow nor, short of a factor 2^970, underflow.
Sign exact_sign(Point a, Point b, Point c) {
    const double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y),  //
                                     std::abs(c.x), std::abs(c.y)});
    if (largest == 0) return Sign::Zero;
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

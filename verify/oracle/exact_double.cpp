// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_double.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace keikan::oracle {
namespace {

int exact_orientation(Point p, Point q, Point r) {
    const std::array<double, 6> values = {p.x, p.y, q.x, q.y, r.x, r.y};
    int least = 0;
    for (const double value : values) least = std::min(least, binary_fraction(value).exponent);

    // Differences below 2^62, products below 2^124: the usual case of coordinates in one picture.
    std::array<Int128, 6> whole{};
    bool fits = true;
    for (std::size_t i = 0; i < 6 && fits; ++i) {
        const auto number = whole_number(values[i], -least, 61);
        fits = number.has_value();
        whole[i] = number.value_or(0);
    }
    if (fits) {
        const Int128 left = (whole[0] - whole[4]) * (whole[3] - whole[5]);
        const Int128 right = (whole[1] - whole[5]) * (whole[2] - whole[4]);
        return left > right ? 1 : left < right ? -1 : 0;
    }

    std::array<mpz_class, 6> number;
    for (std::size_t i = 0; i < 6; ++i) number[i] = whole_number_of_any_length(values[i], -least);
    const mpz_class left = (number[0] - number[4]) * (number[3] - number[5]);
    const mpz_class right = (number[1] - number[5]) * (number[2] - number[4]);
    return left > right ? 1 : left < right ? -1 : 0;
}

}  // namespace

int orientation(Point p, Point q, Point r) {
    // Each difference has a relative error u = 2^-53, each product 3 u + ..., their difference one u more:
    // Shewchuk's bound (3 + 16 u) u of the sum of sizes. Below kNoUnderflow a product may have lost its
    // relative precision.
    constexpr double kRelativeError = 3.3306690738754716e-16;
    constexpr double kNoUnderflow = 1e-280;
    const double left = (p.x - r.x) * (q.y - r.y);
    const double right = (p.y - r.y) * (q.x - r.x);
    const double difference = left - right;
    const double size = std::abs(left) + std::abs(right);
    if (size > kNoUnderflow && std::abs(difference) > kRelativeError * size) return difference > 0 ? 1 : -1;
    return exact_orientation(p, q, r);
}

}  // namespace keikan::oracle

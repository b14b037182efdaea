// SPDX-License-Identifier: Apache-2.0
#include "edge_crossings.hpp"

#include "expansion.hpp"

namespace keikan::clip {
namespace {

/// The same, rounded only at the end.
DoubleDouble exact_sum_of_products(DoubleDouble x, DoubleDouble y, DoubleDouble z, DoubleDouble w) {
    Expansion<16> sum;
    const auto add = [&sum](DoubleDouble a, DoubleDouble b) {
        for (const double s : {a.lo, a.hi})
            for (const double t : {b.lo, b.hi}) sum.add(two_product(s, t));
    };
    add(x, y);
    add(z, w);
    return sum.rounded();
}

DoubleDouble scaled(DoubleDouble value, int exponent) {
    return {std::scalbn(value.hi, exponent), std::scalbn(value.lo, exponent)};
}

}  // namespace

// y + to_border dy / dx with each number brought near 2^400 by a power of two of its own: no product
// overflows, and what underflows moves the meeting by less than 2^-400, since the result is kept in [0, 1]
// later.
double far_crossing(double k, double y_origin, Point p, Point q) {
    constexpr int kMiddle = 400;  // of the exponents: products of two stay below 2^1024
    const auto unit = [](double u, double v) {
        return std::max(std::abs(u), std::abs(v)) > 0x1p1000 ? 0x1p-4 : 1.0;
    };
    const double x_unit = unit(p.x, q.x), y_unit = unit(p.y, q.y);  // so that differences stay finite
    const DoubleDouble dx = two_difference(q.x * x_unit, p.x * x_unit),
                       to_border = two_difference(k * x_unit, p.x * x_unit);
    const DoubleDouble dy = two_difference(q.y * y_unit, p.y * y_unit),
                       y = two_difference(p.y * y_unit, y_origin * y_unit);
    const int of_dx = std::ilogb(dx.hi), of_border = to_border.hi == 0 ? of_dx : std::ilogb(to_border.hi);
    int of_y = kMiddle;
    if (y.hi != 0) of_y = std::max(of_y, std::ilogb(y.hi));
    if (dy.hi != 0) of_y = std::max(of_y, std::ilogb(dy.hi) + of_border - of_dx);
    const int to_middle = kMiddle - of_y;
    const DoubleDouble run = scaled(dx, kMiddle - of_dx);
    const double meeting =
        quotient(exact_sum_of_products(scaled(y, to_middle), run, scaled(to_border, kMiddle - of_border),
                                       scaled(dy, of_border - of_dx + to_middle)),
                 run);
    return std::scalbn(meeting, -to_middle) / y_unit;
}

}  // namespace keikan::clip

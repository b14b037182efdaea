// SPDX-License-Identifier: Apache-2.0
#include "nearer_part.hpp"

#include <algorithm>
#include <cmath>

#include "expansion.hpp"

namespace keikan::clip {
namespace {

/// Adds c + a px + b py, exactly: pixel indices are integers, so that no product underflows.
template <std::size_t Capacity>
void add_local_constant(Expansion<Capacity>& sum, PixelIndex pixel, const DepthPlane& plane, double sign) {
    sum.add(two_product(sign * plane.a, pixel.x));
    sum.add(two_product(sign * plane.b, pixel.y));
    sum.add(sign * plane.c);
}

}  // namespace

LocalPlane local_plane(PixelIndex pixel, const DepthPlane& plane) {
    // In double-double first: what may be lost is below 2^-102 of the terms. The exact sum is needed only if
    // that could change the last bit of c.hi, which is the exact sum rounded in either case.
    const DoubleDouble ax = two_product(plane.a, pixel.x), by = two_product(plane.b, pixel.y);
    const DoubleDouble slopes = two_sum(ax.hi, by.hi), sum = two_sum(slopes.hi, plane.c);
    const DoubleDouble c = quick_two_sum(sum.hi, sum.lo + (slopes.lo + (ax.lo + by.lo)));
    const double lost = 0x1p-102 * (std::abs(ax.hi) + std::abs(by.hi) + std::abs(plane.c));
    if (c.hi + (c.lo + lost) == c.hi && c.hi + (c.lo - lost) == c.hi) [[likely]]
        return {plane.a, plane.b, c, lost, plane};
    Expansion<5> exact;
    add_local_constant(exact, pixel, plane, 1);
    const DoubleDouble rounded = exact.rounded();
    return {plane.a, plane.b, rounded, 0x1p-104 * std::abs(rounded.hi), plane};
}

NearnessDifference NearnessDifference::rough(const LocalPlane& first, const LocalPlane& second) {
    NearnessDifference d;
    d.a_.hi = first.a - second.a;
    d.b_.hi = first.b - second.b;
    d.c_.hi = (first.c.hi - second.c.hi) + (first.c.lo - second.c.lo);
    // Three roundings in each coefficient, four where they are put together, all of the terms' size; and what
    // the two constants had lost when they were rounded to two doubles.
    d.error_ = 8 * kHalfUlp * (std::abs(d.a_.hi) + std::abs(d.b_.hi) + std::abs(d.c_.hi)) + first.c_error +
               second.c_error;
    return d;
}

NearnessDifference NearnessDifference::exact(PixelIndex pixel, const LocalPlane& first,
                                             const LocalPlane& second) {
    NearnessDifference d;
    d.a_ = two_difference(first.a, second.a);
    d.b_ = two_difference(first.b, second.b);
    // In double-doubles first, the differences before the products: what is lost is below 2^-102 of the
    // terms.
    const DoubleDouble c = two_difference(first.image.c, second.image.c);
    const DoubleDouble ax = two_product(d.a_.hi, pixel.x), by = two_product(d.b_.hi, pixel.y);
    const DoubleDouble slopes = two_sum(ax.hi, by.hi), sum = two_sum(slopes.hi, c.hi);
    const double low = (ax.lo + d.a_.lo * pixel.x) + (by.lo + d.b_.lo * pixel.y);
    d.c_ = quick_two_sum(sum.hi, sum.lo + (slopes.lo + (low + c.lo)));
    const double lost = 0x1p-102 * (std::abs(ax.hi) + std::abs(by.hi) + std::abs(c.hi));
    if (!(lost <= 0x1p-80 * (std::abs(d.a_.hi) + std::abs(d.b_.hi) + std::abs(d.c_.hi)))) {
        Expansion<10> exact;
        add_local_constant(exact, pixel, first.image, 1);
        add_local_constant(exact, pixel, second.image, -1);
        d.c_ = exact.rounded();
    }
    d.error_ = 8 * kHalfUlp * (std::abs(d.a_.hi) + std::abs(d.b_.hi) + std::abs(d.c_.hi));
    return d;
}

Bounded NearnessDifference::largest(const Box& box) const {
    return {std::max(a_.hi * box.min_x, a_.hi * box.max_x) + std::max(b_.hi * box.min_y, b_.hi * box.max_y) +
                c_.hi,
            error_};
}

Bounded NearnessDifference::smallest(const Box& box) const {
    return {std::min(a_.hi * box.min_x, a_.hi * box.max_x) + std::min(b_.hi * box.min_y, b_.hi * box.max_y) +
                c_.hi,
            error_};
}

double NearnessDifference::at(Point p) const {
    const DoubleDouble x = two_product(a_.hi, p.x), y = two_product(b_.hi, p.y);
    const DoubleDouble xy = two_sum(x.hi, y.hi), sum = two_sum(xy.hi, c_.hi);
    const double low = (x.lo + a_.lo * p.x) + (y.lo + b_.lo * p.y) + xy.lo + c_.lo;
    return sum.hi + (sum.lo + low);
}

double NearnessDifference::on_line() const {
    return kHalfUlp * (std::abs(a_.hi) + std::abs(b_.hi));
}

}  // namespace keikan::clip

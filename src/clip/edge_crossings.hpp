// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>

#include "convex_outline.hpp"
#include "double_double.hpp"
#include "keikan/model/point.hpp"
#include "pixel_borders.hpp"

namespace keikan::clip {

/// x y + z w, with an error below 2^-102 (|x y| + |z w|).
inline DoubleDouble sum_of_products(DoubleDouble x, DoubleDouble y, DoubleDouble z, DoubleDouble w) {
    const DoubleDouble xy = two_product(x.hi, y.hi), zw = two_product(z.hi, w.hi);
    const DoubleDouble sum = two_sum(xy.hi, zw.hi);
    const double low = (xy.lo + (x.hi * y.lo + x.lo * y.hi)) + (zw.lo + (z.hi * w.lo + z.lo * w.hi));
    return quick_two_sum(sum.hi, sum.lo + low);
}

/// Where the line p q, which crosses the border x = k, meets it, measured along y from `y_origin`; for points
/// so far away or an edge so close to the border's direction that double-doubles would not do.
double far_crossing(double k, double y_origin, Point p, Point q);

/// In the order of x, then y.
inline bool is_before(Point a, Point b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// Where one edge meets the pixel's borders. The same bits for either direction of travel.
class EdgeCrossings {
  public:
    EdgeCrossings(const PixelBorders& pixel, Point p, Point q)
        : pixel_(pixel), p_(is_before(q, p) ? q : p), q_(is_before(q, p) ? p : q) {
        dx_ = two_difference(q_.x, p_.x);
        dy_ = two_difference(q_.y, p_.y);
        const DoubleDouble x = two_difference(p_.x, pixel.left), y = two_difference(p_.y, pixel.low);
        const auto tiny = [](double d) { return d != 0 && std::abs(d) < 0x1p-400; };
        const double extent = std::abs(x.hi) + std::abs(y.hi) + std::abs(dx_.hi) + std::abs(dy_.hi);
        far_ = !(extent < 0x1p40) || tiny(dx_.hi) || tiny(dy_.hi);
        if (!far_) offset_ = sum_of_products(x, dy_, -y, dx_);
    }

    Point at(unsigned border) const {
        if (far_) [[unlikely]]
            return far_at(border);
        // The line is offset - u dy + v dx = 0; on a border all but one term is known. An error of the
        // offset moves the point across the line by at most 2^-101 * extent < 2^-61, however the edge
        // lies (docs/numerics.md, section 2).
        switch (border) {
            case 0:
                return {along(offset_, dy_), 0};
            case 1:
                return {1, along(nearly_sum(dy_, -offset_), dx_)};
            case 2:
                return {along(nearly_sum(offset_, dx_), dy_), 1};
            default:
                return {0, along(-offset_, dx_)};
        }
    }

  private:
    /// x + y with an error below 2^-104 (|x| + |y|).
    static DoubleDouble nearly_sum(DoubleDouble x, DoubleDouble y) {
        const DoubleDouble sum = two_sum(x.hi, y.hi);
        return quick_two_sum(sum.hi, sum.lo + (x.lo + y.lo));
    }
    static double along(DoubleDouble numerator, DoubleDouble denominator) {
        return snap(std::clamp(quotient(numerator, denominator), 0.0, 1.0));
    }
    Point far_at(unsigned border) const {
        const Point p{p_.y, p_.x}, q{q_.y, q_.x};  // for the borders y = k
        const auto within = [](double v) { return snap(std::clamp(v, 0.0, 1.0)); };
        switch (border) {
            case 0:
                return {within(far_crossing(pixel_.low, pixel_.left, p, q)), 0};
            case 1:
                return {1, within(far_crossing(pixel_.right, pixel_.low, p_, q_))};
            case 2:
                return {within(far_crossing(pixel_.high, pixel_.left, p, q)), 1};
            default:
                return {0, within(far_crossing(pixel_.left, pixel_.low, p_, q_))};
        }
    }

    const PixelBorders& pixel_;
    Point p_, q_;
    DoubleDouble dx_, dy_, offset_;
    bool far_ = false;
};

}  // namespace keikan::clip

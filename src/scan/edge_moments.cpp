// SPDX-License-Identifier: Apache-2.0
#include "edge_moments.hpp"

#include <algorithm>
#include <cmath>

#include "../clip/double_double.hpp"

namespace keikan {
namespace {

/// One coordinate of an edge's two ends.
struct Ends {
    double from, to;
};

/// Where the edge with the first coordinates `s` and the second coordinates `t` has s = `at`, a border of the
/// pixel: the second coordinate there, from `origin`, the pixel's own. That is
///   (t.from - origin) + (at - s.from) (t.to - t.from) / (s.to - s.from).
/// The plain formula errs by some roundings of the edge's length, and by those of its ends' distance from the
/// pixel. For a long edge that is too much: there all differences are exact sums of two doubles, and the
/// quotient is corrected by its own exact remainder.
double crossing(Ends s, Ends t, double at, double origin) {
    const double run = s.to - s.from, rise = t.to - t.from;
    if (std::abs(run) + std::abs(rise) <= 1) {
        // From the nearer end, so that the step's rounding errors stay below half of the edge's.
        return std::abs(at - s.from) <= std::abs(s.to - at) ? (t.from - origin) + (at - s.from) * (rise / run)
                                                            : (t.to - origin) - (s.to - at) * (rise / run);
    }
    const clip::DoubleDouble exact_run = clip::two_difference(s.to, s.from);
    const clip::DoubleDouble exact_rise = clip::two_difference(t.to, t.from);
    const clip::DoubleDouble step = clip::two_difference(at, s.from);
    const double quotient = step.hi * rise / run;
    const clip::DoubleDouble product = clip::two_product(step.hi, exact_rise.hi);
    const clip::DoubleDouble back = clip::two_product(quotient, exact_run.hi);
    const double remainder = (product.hi - back.hi) + (product.lo - back.lo) + step.hi * exact_rise.lo +
                             step.lo * exact_rise.hi - quotient * exact_run.lo;
    const clip::DoubleDouble start = clip::two_difference(t.from, origin);
    const clip::DoubleDouble sum = clip::two_sum(start.hi, quotient);
    return sum.hi + (sum.lo + (start.lo + remainder / run));
}

/// A vertical stretch on the right border or beyond it.
Moments right_of_pixel(double top, double bottom) {
    const double height = bottom - top;
    return {height, height / 2, height * (top + bottom) / 2};
}

Moments with_sign(double sign, const Moments& m) {
    return {sign * m.area, sign * m.x, sign * m.y};
}

}  // namespace

Moments edge_moments(Point p, Point q, PixelIndex pixel) {
    double sign = 1;
    if (p.y > q.y) {
        std::swap(p, q);
        sign = -1;
    }
    const double left = pixel.x, top = pixel.y, right = left + 1, bottom = top + 1;
    if (q.y <= top || p.y >= bottom || p.y == q.y || (p.x <= left && q.x <= left)) return {};

    // Along the edge, with y rising: (xa, ya) to (xb, yb), from the pixel's corner, is its part between the
    // rows. An end within the pixel is moved there exactly.
    const Ends x{p.x, q.x}, y{p.y, q.y};
    const double ya = p.y < top ? 0 : p.y - top, yb = q.y > bottom ? 1 : q.y - top;
    if (p.x >= right && q.x >= right) return with_sign(sign, right_of_pixel(ya, yb));
    const double xa = p.y < top ? crossing(y, x, top, left) : p.x - left;
    const double xb = q.y > bottom ? crossing(y, x, bottom, left) : q.x - left;

    // Of that, the stretch within the columns, and the one on the right of them. Rounded crossings are kept
    // in order, so that the stretches divide [ya, yb].
    Moments sum;
    double begin = ya, end = yb, x_begin = xa, x_end = xb;
    if (xa > 1) {
        begin = std::clamp(crossing(x, y, right, top), ya, yb);
        x_begin = 1;
        sum += right_of_pixel(ya, begin);
    } else if (xa < 0) {
        if (xb <= 0) return {};
        begin = std::clamp(crossing(x, y, left, top), ya, yb);
        x_begin = 0;
    }
    if (xb > 1) {
        end = std::clamp(crossing(x, y, right, top), begin, yb);
        x_end = 1;
        sum += right_of_pixel(end, yb);
    } else if (xb < 0) {
        end = std::clamp(crossing(x, y, left, top), begin, yb);
        x_end = 0;
    }
    const double height = end - begin;
    sum.area += height * (x_begin + x_end) / 2;
    sum.x += height * (x_begin * x_begin + x_begin * x_end + x_end * x_end) / 6;
    sum.y += height * (begin * (2 * x_begin + x_end) + end * (x_begin + 2 * x_end)) / 6;
    return with_sign(sign, sum);
}

Moments edge_moments_beside(Point p, Point q, PixelIndex pixel, bool on_the_right) {
    if (!on_the_right) return {};
    const double from = std::clamp(p.y - pixel.y, 0.0, 1.0), to = std::clamp(q.y - pixel.y, 0.0, 1.0);
    return right_of_pixel(from, to);
}

bool box_misses_pixel(Point p, Point q, PixelIndex pixel) {
    return std::max(p.x, q.x) <= pixel.x || std::min(p.x, q.x) >= pixel.x + 1 ||
           std::max(p.y, q.y) <= pixel.y || std::min(p.y, q.y) >= pixel.y + 1;
}

}  // namespace keikan

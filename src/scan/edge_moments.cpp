// SPDX-License-Identifier: Apache-2.0
#include "edge_moments.hpp"

#include <algorithm>
#include <cmath>

#include "../clip/double_double.hpp"

namespace keikan {
namespace {

/// The second coordinate where the edge from (s, t) to (s2, t2) has the first coordinate `at`, 0 or 1:
///   t + (at - s) (t2 - t) / (s2 - s).
/// The plain formula errs by some roundings of |t2 - t|. For a long edge that is too much, and the quotient
/// is corrected by its own exact remainder.
double crossing(double s, double t, double s2, double t2, double at) {
    const double run = s2 - s, rise = t2 - t;
    if (std::abs(run) + std::abs(rise) <= 1) {
        // From the nearer end, so that the step's rounding errors stay below a quarter of the edge's.
        return std::abs(at - s) <= std::abs(s2 - at) ? t + (at - s) * (rise / run)
                                                     : t2 - (s2 - at) * (rise / run);
    }
    const clip::DoubleDouble exact_run = clip::two_difference(s2, s);
    const clip::DoubleDouble exact_rise = clip::two_difference(t2, t);
    const clip::DoubleDouble step = clip::two_difference(at, s);
    const double quotient = step.hi * rise / run;
    const clip::DoubleDouble product = clip::two_product(step.hi, exact_rise.hi);
    const clip::DoubleDouble back = clip::two_product(quotient, exact_run.hi);
    const double remainder = (product.hi - back.hi) + (product.lo - back.lo) + step.hi * exact_rise.lo +
                             step.lo * exact_rise.hi - quotient * exact_run.lo;
    const clip::DoubleDouble sum = clip::two_sum(t, quotient);
    return sum.hi + (sum.lo + remainder / run);
}

}  // namespace

Moments edge_moments(Point p, Point q) {
    double sign = 1;
    if (p.y > q.y) {
        std::swap(p, q);
        sign = -1;
    }
    if (q.y <= 0 || p.y >= 1 || p.y == q.y || (p.x <= 0 && q.x <= 0)) return {};

    // Along the edge, with y rising: (xa, ya) to (xb, yb) is its part between the rows.
    double ya = p.y, yb = q.y;
    const auto beyond = [](double top, double bottom) {  // a vertical stretch on the right border or beyond
        const double height = bottom - top;
        return Moments{height, height / 2, height * (top + bottom) / 2};
    };
    if (p.x >= 1 && q.x >= 1) {
        ya = std::max(ya, 0.0);
        yb = std::min(yb, 1.0);
        const Moments right = beyond(ya, yb);
        return {sign * right.area, sign * right.x, sign * right.y};
    }
    double xa = p.x, xb = q.x;
    if (ya < 0) {
        ya = 0;
        xa = crossing(p.y, p.x, q.y, q.x, 0);
    }
    if (yb > 1) {
        yb = 1;
        xb = crossing(p.y, p.x, q.y, q.x, 1);
    }

    // Of that, the stretch within the columns, and the one on the right of them. Rounded crossings are kept
    // in order, so that the stretches divide [ya, yb].
    Moments sum;
    double begin = ya, end = yb, x_begin = xa, x_end = xb;
    if (xa > 1) {
        begin = std::clamp(crossing(p.x, p.y, q.x, q.y, 1), ya, yb);
        x_begin = 1;
        sum += beyond(ya, begin);
    } else if (xa < 0) {
        if (xb <= 0) return {};
        begin = std::clamp(crossing(p.x, p.y, q.x, q.y, 0), ya, yb);
        x_begin = 0;
    }
    if (xb > 1) {
        end = std::clamp(crossing(p.x, p.y, q.x, q.y, 1), begin, yb);
        x_end = 1;
        sum += beyond(end, yb);
    } else if (xb < 0) {
        end = std::clamp(crossing(p.x, p.y, q.x, q.y, 0), begin, yb);
        x_end = 0;
    }
    const double height = end - begin;
    sum.area += height * (x_begin + x_end) / 2;
    sum.x += height * (x_begin * x_begin + x_begin * x_end + x_end * x_end) / 6;
    sum.y += height * (begin * (2 * x_begin + x_end) + end * (x_begin + 2 * x_end)) / 6;
    return {sign * sum.area, sign * sum.x, sign * sum.y};
}

}  // namespace keikan

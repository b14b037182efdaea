// SPDX-License-Identifier: Apache-2.0
#include "convex_outline.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "double_double.hpp"
#include "expansion.hpp"
#include "keikan/clip/orient2d.hpp"

namespace keikan::clip {
namespace {

bool before(Point a, Point b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// orient2d for points that mostly do not line up: the filter is tried on the spot.
Sign turn(Point a, Point b, Point c) {
    const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
    constexpr double kFilter = 4 * kHalfUlp;
    const double error = kFilter * (std::abs(left) + std::abs(right)) + 0x1p-960;
    const double determinant = left - right;
    if (determinant > error && error < HUGE_VAL) return Sign::Positive;
    if (determinant < -error && error < HUGE_VAL) return Sign::Negative;
    return orient2d(a, b, c);
}

// Sets of four, as in EdgeView.
using Set = unsigned;
constexpr Set kAll = 15;
constexpr Set bit(bool member, unsigned k) {
    return static_cast<Set>(member) << k;
}
/// Bit k of the result: bit k + 1 of `set`, around the pixel.
constexpr Set next(Set set) {
    return (set >> 1 | set << 3) & kAll;
}

/// The pixel's four border lines in image coordinates, as doubles without error.
struct Borders {
    double left, right, low, high;
    explicit Borders(PixelIndex pixel) : left(pixel.x), right(left + 1), low(pixel.y), high(low + 1) {}

    Set beyond(Point p) const {
        return bit(p.y < low, 0) | bit(p.x > right, 1) | bit(p.y > high, 2) | bit(p.x < left, 3);
    }
    Set on_or_beyond(Point p) const {
        return bit(p.y <= low, 0) | bit(p.x >= right, 1) | bit(p.y >= high, 2) | bit(p.x <= left, 3);
    }
    Point corner(unsigned k) const { return {k == 1 || k == 2 ? right : left, k >= 2 ? high : low}; }
};

struct CornerSides {
    Set inside = 0, outside = 0;
};

/// The exact sides of the pixel's corners, seen from the edge p q.
CornerSides corner_sides(const Borders& pixel, Point p, Point q) {
    const double dx = q.x - p.x, dy = q.y - p.y;
    const double low = dx * (pixel.low - p.y), high = dx * (pixel.high - p.y);
    const double left = dy * (pixel.left - p.x), right = dy * (pixel.right - p.x);
    // Each product carries three roundings, their difference a fourth.
    constexpr double kFilter = 5 * kHalfUlp;
    const double error =
        kFilter * (std::max(std::abs(low), std::abs(high)) + std::max(std::abs(left), std::abs(right))) +
        0x1p-960;
    const double side[4] = {low - left, low - right, high - right, high - left};
    CornerSides sides;
    for (unsigned k = 0; k < 4; ++k) {
        sides.inside |= bit(side[k] > error, k);
        sides.outside |= bit(side[k] < -error, k);
    }
    Set open = kAll & ~(sides.inside | sides.outside);
    for (; open != 0; open &= open - 1) {  // too close to call, or not finite
        const unsigned k = static_cast<unsigned>(std::countr_zero(open));
        const Sign sign = orient2d(p, q, pixel.corner(k));
        sides.inside |= bit(sign == Sign::Positive, k);
        sides.outside |= bit(sign == Sign::Negative, k);
    }
    return sides;
}

/// x y + z w, with an error below 2^-102 (|x y| + |z w|).
DoubleDouble sum_of_products(DoubleDouble x, DoubleDouble y, DoubleDouble z, DoubleDouble w) {
    const DoubleDouble xy = two_product(x.hi, y.hi), zw = two_product(z.hi, w.hi);
    const DoubleDouble sum = two_sum(xy.hi, zw.hi);
    const double low = (xy.lo + (x.hi * y.lo + x.lo * y.hi)) + (zw.lo + (z.hi * w.lo + z.lo * w.hi));
    return quick_two_sum(sum.hi, sum.lo + low);
}

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

/// Where the line p q, which crosses the border x = k, meets it, measured along y from `y_origin`; for points
/// so far away or an edge so close to the border's direction that double-doubles would not do.
///
/// y + to_border dy / dx with each number brought near 2^400 by a power of two of its own: no product
/// overflows, and what underflows moves the meeting by less than 2^-400, since the result is kept in [0, 1]
/// later.
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

/// Where one edge meets the pixel's borders. The same bits for either direction of travel.
class EdgeCrossings {
  public:
    EdgeCrossings(const Borders& pixel, Point p, Point q)
        : pixel_(pixel), p_(before(q, p) ? q : p), q_(before(q, p) ? p : q) {
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

    const Borders& pixel_;
    Point p_, q_;
    DoubleDouble dx_, dy_, offset_;
    bool far_ = false;
};

/// A place on the pixel's border, as the way from (0, 0) around it: corner k is at k.
double way_around(Point p) {
    if (p.y == 0) return p.x;
    if (p.x == 1) return 1 + p.y;
    if (p.y == 1) return 3 - p.x;
    return 4 - p.y;
}

constexpr Point kCorner[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// Follows the outline and, from where it leaves the pixel to where it enters again, the pixel's border past
/// those corners that are inside the outline.
class BorderWalk {
  public:
    BorderWalk(const Borders& pixel, Set corners_inside, Point* ring)
        : pixel_(pixel), corners_inside_(corners_inside), begin_(ring), end_(ring) {}

    void follow(Point p, Point q, EdgeView at_p, Set beyond_q) {
        const Set beyond_p = at_p.beyond;
        if (beyond_p == 0) push({snap(p.x - pixel_.left), snap(p.y - pixel_.low)});
        if ((beyond_p & beyond_q) != 0 || (beyond_p | beyond_q) == 0) return;
        // An edge whose ends lie on different sides of a border line meets the border exactly when the
        // border's ends do not both lie strictly on one side of the edge.
        const Set missed = (at_p.inside & next(at_p.inside)) | (at_p.outside & next(at_p.outside));
        Set enters = beyond_p & ~missed, leaves = beyond_q & ~missed;
        if ((enters | leaves) == 0) return;
        const EdgeCrossings crossings(pixel_, p, q);
        for (; enters != 0; enters &= enters - 1)
            enter(crossings.at(static_cast<unsigned>(std::countr_zero(enters))));
        for (; leaves != 0; leaves &= leaves - 1)
            leave(crossings.at(static_cast<unsigned>(std::countr_zero(leaves))));
    }

    /// The number of points.
    std::size_t close() {
        if (first_entry_ >= 0) follow_border(left_at_, first_entry_);
        return static_cast<std::size_t>(end_ - begin_);
    }

  private:
    void push(Point p) { *end_++ = p; }
    void enter(Point p) {
        if (outside_)
            follow_border(left_at_, way_around(p));
        else if (end_ == begin_)
            first_entry_ = way_around(p);  // the border before it is followed last, by close()
        outside_ = false;
        push(p);
    }
    void leave(Point p) {
        push(p);
        left_at_ = way_around(p);
        outside_ = true;
    }
    /// From a place to itself is the whole way around.
    void follow_border(double from, double to) {
        if (corners_inside_ == 0) return;
        if (to <= from) to += 4;
        for (int corner = static_cast<int>(from) + 1; corner < to; ++corner)
            if ((corners_inside_ >> (corner & 3) & 1u) != 0) push(kCorner[corner & 3]);
    }

    const Borders& pixel_;
    Set corners_inside_;
    Point* begin_;
    Point* end_;
    double first_entry_ = -1, left_at_ = 0;
    bool outside_ = false;
};

/// Whether a ring of snapped points is exactly strictly convex and turns from +x towards +y, once.
bool is_strictly_convex(const Point* ring, std::size_t n) {
    if (n < 3) return false;
    Point last = ring[n - 1];
    double ux = last.x - ring[n - 2].x, uy = last.y - ring[n - 2].y;
    bool forward = ux > 0 || (ux == 0 && uy > 0);
    unsigned reversals = 0;  // of the travel along x (then y): two for one turn around, more for several
    for (std::size_t i = 0; i < n; ++i) {
        const double vx = ring[i].x - last.x, vy = ring[i].y - last.y;
        const double left = ux * vy, right = uy * vx;
        // The differences are exact: three roundings, none of which can hide more than this.
        if (left - right <= 2 * kHalfUlp * (std::abs(left) + std::abs(right))) [[unlikely]] {
            const DoubleDouble exact_left = two_product(ux, vy), exact_right = two_product(uy, vx);
            if (exact_left.hi < exact_right.hi ||
                (exact_left.hi == exact_right.hi && exact_left.lo <= exact_right.lo))
                return false;
        }
        const bool now_forward = vx > 0 || (vx == 0 && vy > 0);
        reversals += now_forward != forward;
        forward = now_forward;
        last = ring[i];
        ux = vx, uy = vy;
    }
    return reversals == 2;
}

std::size_t without_repeats(Point* ring, std::size_t n) {
    n = static_cast<std::size_t>(std::unique(ring, ring + n) - ring);
    return n > 1 && ring[0] == ring[n - 1] ? n - 1 : n;
}

}  // namespace

Turning turning(std::span<const Point> ring) {
    const std::size_t n = ring.size();
    if (n < 3) return Turning::NotStrictlyConvex;
    const Sign first = turn(ring[n - 2], ring[n - 1], ring[0]);
    if (first == Sign::Zero) return Turning::NotStrictlyConvex;
    const Turning found = first == Sign::Positive ? Turning::Positive : Turning::Negative;
    if (n == 3) return found;
    unsigned reversals = 0;  // of the travel along x (then y): two for one turn around, more for several
    bool forward = before(ring[n - 1], ring[0]);
    for (std::size_t i = 0; i < n; ++i) {
        const Point p = ring[i], q = ring[i + 1 < n ? i + 1 : 0];
        if (i + 1 < n && turn(ring[i > 0 ? i - 1 : n - 1], p, q) != first) return Turning::NotStrictlyConvex;
        const bool now_forward = before(p, q);
        reversals += now_forward != forward;
        forward = now_forward;
    }
    return reversals == 2 ? found : Turning::NotStrictlyConvex;
}

bool may_overlap(PixelIndex index, std::span<const Point> outline) {
    const Borders pixel(index);
    Set all = kAll;
    for (const Point p : outline) all &= pixel.on_or_beyond(p);
    return all == 0;
}

Overlap overlap(PixelIndex index, const ConvexOutline& outline, std::vector<EdgeView>& views) {
    const Borders pixel(index);
    const std::size_t n = outline.size(), first = views.size();
    views.resize(first + n);
    EdgeView* const view = views.data() + first;
    Set beyond = 0;
    bool reaches_in = false;
    for (std::size_t i = 0; i < n; ++i) {
        const Set place = pixel.beyond(outline[i]);
        view[i] = {static_cast<std::uint8_t>(place), 0, 0};
        beyond |= place;
        reaches_in = reaches_in || place == 0;
    }
    if (beyond == 0) return Overlap::Part;  // all of it is in the pixel, and no corner of the pixel in it
    Set outside = 0;
    const auto look = [&](std::size_t i) {
        const CornerSides sides = corner_sides(pixel, outline[i], outline[i + 1 < n ? i + 1 : 0]);
        view[i].inside = static_cast<std::uint8_t>(sides.inside);
        view[i].outside = static_cast<std::uint8_t>(sides.outside);
        outside |= sides.outside;
        return sides.inside != 0;
    };
    // An edge beyond one border does not part the pixel, unless the outline misses it altogether (if a
    // corner were outside this edge alone, the way from there to a point of both would cross the edge in
    // the pixel). So it is looked at only if the others leave that open.
    const auto shuns = [&](std::size_t i) {
        return (view[i].beyond & view[i + 1 < n ? i + 1 : 0].beyond) != 0;
    };
    for (std::size_t i = 0; i < n; ++i)
        if (!shuns(i) && !look(i)) return Overlap::Nothing;
    if (outside != 0 || reaches_in) return Overlap::Part;
    for (std::size_t i = 0; i < n; ++i)
        if (shuns(i) && !look(i)) return Overlap::Nothing;
    return outside == 0 ? Overlap::WholePixel : Overlap::Part;
}

std::span<const Point> clip_to_pixel(PixelIndex index, const ConvexOutline& outline,
                                     std::span<const EdgeView> views, std::vector<Point>& scratch) {
    const Borders pixel(index);
    const std::size_t n = outline.size();
    Set outside = 0;
    for (const EdgeView& view : views) outside |= view.outside;
    // An edge adds its start, two crossings with borders at either end, and four corners of the pixel.
    if (scratch.size() < 9 * n + 8) scratch.resize(9 * n + 8);
    BorderWalk walk(pixel, kAll & ~outside, scratch.data());
    Point p = outline[0];
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t following = i + 1 < n ? i + 1 : 0;
        const Point q = outline[following];
        walk.follow(p, q, views[i], views[following].beyond);
        p = q;
    }
    std::size_t size = without_repeats(scratch.data(), walk.close());
    if (!is_strictly_convex(scratch.data(), size)) {
        scratch.resize(size);
        replace_by_hull(scratch);
        size = scratch.size();
        if (size < 3) return {};
    }
    const auto begin = scratch.begin(), end = begin + static_cast<std::ptrdiff_t>(size);
    std::rotate(begin, std::min_element(begin, end, before), end);
    return {scratch.data(), size};
}

}  // namespace keikan::clip

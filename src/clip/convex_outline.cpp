// SPDX-License-Identifier: Apache-2.0
#include "convex_outline.hpp"

#include <algorithm>
#include <cmath>

#include "double_double.hpp"
#include "expansion.hpp"
#include "keikan/clip/orient2d.hpp"

namespace keikan::clip {
namespace {

bool before(Point a, Point b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// The pixel's four border lines in image coordinates, as doubles without error.
struct Borders {
    double left, right, low, high;
    explicit Borders(PixelIndex pixel) : left(pixel.x), right(left + 1), low(pixel.y), high(low + 1) {}
};

/// The borders beyond which a point lies; none for a point of the pixel.
enum Beyond : unsigned { kLeft = 1, kRight = 2, kLow = 4, kHigh = 8 };

unsigned beyond(const Borders& pixel, Point p) {
    return (p.x < pixel.left ? kLeft : 0u) | (p.x > pixel.right ? kRight : 0u) |
           (p.y < pixel.low ? kLow : 0u) | (p.y > pixel.high ? kHigh : 0u);
}

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
    unsigned inside = 0, outside = 0;
    for (unsigned k = 0; k < 4; ++k) {
        inside |= static_cast<unsigned>(side[k] > error) << k;
        outside |= static_cast<unsigned>(side[k] < -error) << k;
    }
    if ((inside | outside) != 15u) [[unlikely]] {  // too close to call, or not finite: the exact sign
        const Point corners[4] = {{pixel.left, pixel.low},
                                  {pixel.right, pixel.low},
                                  {pixel.right, pixel.high},
                                  {pixel.left, pixel.high}};
        for (unsigned k = 0; k < 4; ++k) {
            if (((inside | outside) >> k & 1u) != 0) continue;
            const Sign sign = orient2d(p, q, corners[k]);
            inside |= static_cast<unsigned>(sign == Sign::Positive) << k;
            outside |= static_cast<unsigned>(sign == Sign::Negative) << k;
        }
    }
    sides.inside = static_cast<std::uint8_t>(inside);
    sides.outside = static_cast<std::uint8_t>(outside);
    return sides;
}

/// Where the line p q meets the border u = k, measured along v from `v_origin`.
/// A point is given as (u, v), so that the same words serve for borders of either direction.
double crossing_with_border(double k, double v_origin, Point p, Point q) {
    if (before(q, p)) std::swap(p, q);  // the same bits for either direction of travel
    const double extent =
        std::max({std::abs(p.x - k), std::abs(q.x - k), std::abs(p.y - v_origin), std::abs(q.y - v_origin)});
    double unit = 1;
    if (extent > 0x1p480) [[unlikely]] {  // keep the products finite; what underflows is below 2^-500
        unit = 0x1p-540;
        p = {p.x * unit, p.y * unit};
        q = {q.x * unit, q.y * unit};
        k *= unit;
        v_origin *= unit;
    }
    DoubleDouble du = two_difference(q.x, p.x), to_border = two_difference(k, p.x);
    const DoubleDouble dv = two_difference(q.y, p.y), v = two_difference(p.y, v_origin);
    if (std::abs(du.hi) < 0x1p-400) [[unlikely]] {  // keep the products above the underflow; the ratio stays
        du = {du.hi * 0x1p600, du.lo * 0x1p600};
        to_border = {to_border.hi * 0x1p600, to_border.lo * 0x1p600};
    }
    DoubleDouble numerator;
    if (extent < 0x1p40) [[likely]] {
        // Error across the line: at most 2^-101 * extent < 2^-61 (docs/numerics.md, section 2).
        numerator = v * du + to_border * dv;
    } else {
        Expansion<16> exact;
        const auto add = [&exact](DoubleDouble a, DoubleDouble b) {
            for (const double s : {a.lo, a.hi})
                for (const double t : {b.lo, b.hi}) exact.add(two_product(s, t));
        };
        add(v, du);
        add(to_border, dv);
        numerator = exact.rounded();
    }
    const double along = quotient(numerator, du) / unit;
    return snap(std::clamp(along, 0.0, 1.0));
}

/// A place on the pixel's border, as the way from (0, 0) around it: corner k is at k.
double way_around(Point p) {
    if (p.y == 0) return p.x;
    if (p.x == 1) return 1 + p.y;
    if (p.y == 1) return 3 - p.x;
    return 4 - p.y;
}

constexpr Point kCorner[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// The corners at the two ends of a border, as a set.
unsigned ends_of(unsigned border) {
    return border == kLeft ? 0b1001u : border == kRight ? 0b0110u : border == kLow ? 0b0011u : 0b1100u;
}

/// Whether an edge whose ends lie on different sides of `border` meets the pixel there: exactly when the
/// ends of the border do not both lie strictly on one side of the edge.
bool meets(unsigned border, CornerSides sides) {
    const unsigned ends = ends_of(border);
    return (sides.inside & ends) != ends && (sides.outside & ends) != ends;
}

Point crossing(const Borders& pixel, unsigned border, Point p, Point q) {
    switch (border) {
        case kLeft:
            return {0, crossing_with_border(pixel.left, pixel.low, p, q)};
        case kRight:
            return {1, crossing_with_border(pixel.right, pixel.low, p, q)};
        case kLow:
            return {crossing_with_border(pixel.low, pixel.left, {p.y, p.x}, {q.y, q.x}), 0};
        default:
            return {crossing_with_border(pixel.high, pixel.left, {p.y, p.x}, {q.y, q.x}), 1};
    }
}

/// Follows the outline and, from where it leaves the pixel to where it enters again, the pixel's border past
/// those corners that are inside the outline.
class BorderWalk {
  public:
    BorderWalk(const Borders& pixel, unsigned corners_inside, std::vector<Point>& ring)
        : pixel_(pixel), corners_inside_(corners_inside), ring_(ring) {}

    void follow(Point p, Point q, CornerSides sides) {
        const unsigned at_p = beyond(pixel_, p), at_q = beyond(pixel_, q);
        if (at_p == 0) ring_.push_back({snap(p.x - pixel_.left), snap(p.y - pixel_.low)});
        if ((at_p & at_q) != 0) return;
        for (unsigned border = kLeft; border <= kHigh; border <<= 1)
            if ((at_p & border) != 0 && meets(border, sides)) enter(crossing(pixel_, border, p, q));
        for (unsigned border = kLeft; border <= kHigh; border <<= 1)
            if ((at_q & border) != 0 && meets(border, sides)) leave(crossing(pixel_, border, p, q));
    }

    void close() {
        if (first_entry_known_) follow_border(left_at_, first_entry_);
    }

  private:
    void enter(Point p) {
        if (outside_) {
            follow_border(left_at_, way_around(p));
        } else if (ring_.empty()) {  // the border before it is followed last, by close()
            first_entry_ = way_around(p);
            first_entry_known_ = true;
        }
        outside_ = false;
        ring_.push_back(p);
    }
    void leave(Point p) {
        ring_.push_back(p);
        left_at_ = way_around(p);
        outside_ = true;
    }
    /// From a place to itself is the whole way around.
    void follow_border(double from, double to) {
        if (to <= from) to += 4;
        for (int corner = static_cast<int>(from) + 1; corner < to; ++corner)
            if ((corners_inside_ >> (corner & 3) & 1u) != 0) ring_.push_back(kCorner[corner & 3]);
    }

    const Borders& pixel_;
    unsigned corners_inside_;
    std::vector<Point>& ring_;
    double first_entry_ = 0, left_at_ = 0;
    bool first_entry_known_ = false, outside_ = false;
};

void start_at_smallest(std::vector<Point>& ring) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), before), ring.end());
}

}  // namespace

Turning turning(std::span<const Point> ring) {
    const std::size_t n = ring.size();
    if (n < 3) return Turning::NotStrictlyConvex;
    const Sign first = orient2d(ring[n - 2], ring[n - 1], ring[0]);
    if (first == Sign::Zero) return Turning::NotStrictlyConvex;
    int reversals = 0;  // of the travel along x (then y): two for one turn around, more for several
    bool forward = before(ring[n - 1], ring[0]);
    for (std::size_t i = 0; i < n; ++i) {
        const Point p = ring[i], q = ring[i + 1 < n ? i + 1 : 0];
        if (i + 1 < n && orient2d(ring[i > 0 ? i - 1 : n - 1], p, q) != first)
            return Turning::NotStrictlyConvex;
        const bool now_forward = before(p, q);
        reversals += now_forward != forward;
        forward = now_forward;
    }
    if (reversals != 2) return Turning::NotStrictlyConvex;
    return first == Sign::Positive ? Turning::Positive : Turning::Negative;
}

void replace_by_hull(std::vector<Point>& points) {
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const std::size_t n = points.size();
    if (n < 3) return;
    // Andrew's monotone chain; the second half of the vector is where the hull grows.
    points.resize(3 * n + 1);
    Point* const hull = points.data() + n;
    std::size_t size = 0;
    const auto extend = [&](Point p, std::size_t keep) {
        while (size > keep && orient2d(hull[size - 2], hull[size - 1], p) != Sign::Positive) --size;
        hull[size++] = p;
    };
    for (std::size_t i = 0; i < n; ++i) extend(points[i], 1);
    const std::size_t upper = size;
    for (std::size_t i = n - 1; i-- > 0;) extend(points[i], upper);
    std::copy(hull, hull + (size - 1), points.begin());
    points.resize(size - 1);
}

bool may_overlap(PixelIndex index, std::span<const Point> outline) {
    const Borders pixel(index);
    unsigned short_of = kLeft | kRight | kLow | kHigh;  // borders that every point is on or beyond
    for (const Point p : outline) {
        short_of &= (p.x <= pixel.left ? kLeft : 0u) | (p.x >= pixel.right ? kRight : 0u) |
                    (p.y <= pixel.low ? kLow : 0u) | (p.y >= pixel.high ? kHigh : 0u);
        if (short_of == 0) return true;
    }
    return false;
}

Overlap overlap(PixelIndex index, const ConvexOutline& outline, std::vector<CornerSides>& sides) {
    const Borders pixel(index);
    const std::size_t n = outline.size();
    unsigned outside = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const CornerSides edge = corner_sides(pixel, outline[i], outline[i + 1 < n ? i + 1 : 0]);
        if (edge.inside == 0) return Overlap::Nothing;
        outside |= edge.outside;
        sides.push_back(edge);
    }
    return outside == 0 ? Overlap::WholePixel : Overlap::Part;
}

void clip_to_pixel(PixelIndex index, const ConvexOutline& outline, std::span<const CornerSides> sides,
                   std::vector<Point>& ring) {
    const Borders pixel(index);
    const std::size_t n = outline.size();
    unsigned outside = 0;
    for (const CornerSides edge : sides) outside |= edge.outside;
    ring.clear();
    BorderWalk walk(pixel, 15u & ~outside, ring);
    for (std::size_t i = 0; i < n; ++i) walk.follow(outline[i], outline[i + 1 < n ? i + 1 : 0], sides[i]);
    walk.close();
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (turning(ring) != Turning::Positive) {
        replace_by_hull(ring);
        if (ring.size() < 3) ring.clear();
    }
    if (!ring.empty()) start_at_smallest(ring);
}

}  // namespace keikan::clip

// SPDX-License-Identifier: Apache-2.0
#include "convex_outline.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "edge_crossings.hpp"
#include "keikan/clip/orient2d.hpp"
#include "pixel_borders.hpp"

namespace keikan::clip {
namespace {

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

struct CornerSides {
    FourSet inside = 0, outside = 0;
};

/// The exact sides of the pixel's corners, seen from the edge p q.
CornerSides corner_sides(const PixelBorders& pixel, Point p, Point q) {
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
        sides.inside |= bit_if(side[k] > error, k);
        sides.outside |= bit_if(side[k] < -error, k);
    }
    FourSet open = kAllFour & ~(sides.inside | sides.outside);
    for (; open != 0; open &= open - 1) {  // too close to call, or not finite
        const unsigned k = static_cast<unsigned>(std::countr_zero(open));
        const Sign sign = orient2d(p, q, pixel.corner(k));
        sides.inside |= bit_if(sign == Sign::Positive, k);
        sides.outside |= bit_if(sign == Sign::Negative, k);
    }
    return sides;
}

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
    BorderWalk(const PixelBorders& pixel, FourSet corners_inside, Point* ring)
        : pixel_(pixel), corners_inside_(corners_inside), begin_(ring), end_(ring) {}

    void follow(Point p, Point q, EdgeView at_p, FourSet beyond_q) {
        const FourSet beyond_p = at_p.beyond;
        if (beyond_p == 0) push({snap(p.x - pixel_.left), snap(p.y - pixel_.low)});
        if ((beyond_p & beyond_q) != 0 || (beyond_p | beyond_q) == 0) return;
        // An edge whose ends lie on different sides of a border line meets the border exactly when the
        // border's ends do not both lie strictly on one side of the edge.
        const FourSet missed =
            (at_p.inside & next_around(at_p.inside)) | (at_p.outside & next_around(at_p.outside));
        FourSet enters = beyond_p & ~missed, leaves = beyond_q & ~missed;
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

    const PixelBorders& pixel_;
    FourSet corners_inside_;
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
    bool forward = is_before(ring[n - 1], ring[0]);
    for (std::size_t i = 0; i < n; ++i) {
        const Point p = ring[i], q = ring[i + 1 < n ? i + 1 : 0];
        if (i + 1 < n && turn(ring[i > 0 ? i - 1 : n - 1], p, q) != first) return Turning::NotStrictlyConvex;
        const bool now_forward = is_before(p, q);
        reversals += now_forward != forward;
        forward = now_forward;
    }
    return reversals == 2 ? found : Turning::NotStrictlyConvex;
}

bool may_overlap(PixelIndex index, std::span<const Point> outline) {
    const PixelBorders pixel(index);
    FourSet all = kAllFour;
    for (const Point p : outline) all &= pixel.on_or_beyond(p);
    return all == 0;
}

Overlap overlap(PixelIndex index, const ConvexOutline& outline, std::vector<EdgeView>& views) {
    const PixelBorders pixel(index);
    const std::size_t n = outline.size(), first = views.size();
    views.resize(first + n);
    EdgeView* const view = views.data() + first;
    FourSet beyond = 0;
    bool reaches_in = false;
    for (std::size_t i = 0; i < n; ++i) {
        const FourSet place = pixel.beyond(outline[i]);
        view[i] = {static_cast<std::uint8_t>(place), 0, 0};
        beyond |= place;
        reaches_in = reaches_in || place == 0;
    }
    if (beyond == 0) return Overlap::Part;  // all of it is in the pixel, and no corner of the pixel in it
    FourSet outside = 0;
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
    const PixelBorders pixel(index);
    const std::size_t n = outline.size();
    FourSet outside = 0;
    for (const EdgeView& view : views) outside |= view.outside;
    // An edge adds its start, two crossings with borders at either end, and four corners of the pixel.
    if (scratch.size() < 9 * n + 8) scratch.resize(9 * n + 8);
    BorderWalk walk(pixel, kAllFour & ~outside, scratch.data());
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
    std::rotate(begin, std::min_element(begin, end, is_before), end);
    return {scratch.data(), size};
}

}  // namespace keikan::clip

// SPDX-License-Identifier: GPL-3.0-or-later
// Exact areas by cutting convex polygons, written as lists of points, along lines.
//
// All coordinates of a question are brought to one common denominator 2^s, so that points given are pairs of
// integers, lines have integer coefficients, and a point where two lines meet is X/W, Y/W with integers X, Y, W
// of bounded size: a cut is always made with the line itself, never with points that were cut before.
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>
#include <utility>

#include "exact_areas.hpp"

namespace keikan::oracle {
namespace {

/// The least n >= 0 for which value * 2^n is whole.
int bits_after_the_point(double value) {
    if (value == 0) return 0;
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);  // in [1/2, 1), at most 53 bits
    auto whole = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
    int last_bit = exponent - 53;
    while (whole % 2 == 0) whole /= 2, ++last_bit;
    return std::max(0, -last_bit);
}

/// value * 2^bits. Requires: that it is whole.
mpz_class scaled(double value, int bits) {
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    mpz_class whole(std::ldexp(mantissa, 53));
    const int shift = exponent - 53 + bits;
    if (shift >= 0) return whole << static_cast<mp_bitcnt_t>(shift);
    return whole >> static_cast<mp_bitcnt_t>(-shift);  // drops zeros only
}

/// A x + B y + C = 0; the positive side is to the left of the direction of travel.
struct Line {
    mpz_class a, b, c;
};

/// (x/w, y/w), w > 0.
struct HomogeneousPoint {
    mpz_class x, y, w;
};

/// A corner of a convex polygon and the line along which its border goes on.
struct Corner {
    const HomogeneousPoint* point;
    const Line* line;
};

/// Counter-clockwise (with y upwards), strictly convex; empty where there is no area.
using ConvexPolygon = std::vector<Corner>;

struct Halves {
    ConvexPolygon left;
    ConvexPolygon right;
};

/// One question, with all its points and lines.
class Splitting {
  public:
    Splitting(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness);
    ExactAreas areas();

  private:
    const Line* line_through(const HomogeneousPoint& p, const HomogeneousPoint& q);
    const HomogeneousPoint* meeting_point(const Line& first, const Line& second);
    int side(const Line& line, const HomogeneousPoint& point);
    Halves split(const ConvexPolygon& polygon, const Line* line);
    ConvexPolygon polygon_through(const std::vector<const HomogeneousPoint*>& ring);
    std::vector<const HomogeneousPoint*> hull(std::span<const Point> outline);
    ConvexPolygon in_pixel(const FaceView& face);
    ConvexPolygon where_nearer(std::size_t other, std::size_t face);
    void subtract(std::vector<ConvexPolygon>& pieces, const ConvexPolygon& hiding);
    mpq_class area(std::span<const ConvexPolygon> pieces);

    PixelIndex pixel_;
    std::span<const FaceView> faces_;
    Nearness nearness_;
    int bits_ = 0;  ///< the common denominator of coordinates is 2^bits_; the origin is the pixel's corner
    std::deque<HomogeneousPoint> points_;
    std::deque<Line> lines_;
    ConvexPolygon square_;
    std::vector<ConvexPolygon> polygons_;
    mpz_class sum_, other_sum_;  ///< kept, so that a side test allocates nothing
};

/// False if the outline's bounding box has no area in common with the pixel.
bool may_touch(std::span<const Point> outline, PixelIndex pixel) {
    if (outline.empty()) return false;
    const auto [left, right] = std::ranges::minmax(outline, {}, &Point::x);
    const auto [top, bottom] = std::ranges::minmax(outline, {}, &Point::y);
    return left.x < pixel.x + 1 && right.x > pixel.x && top.y < pixel.y + 1 && bottom.y > pixel.y;
}

Splitting::Splitting(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness)
    : pixel_(pixel), faces_(faces), nearness_(nearness) {
    for (const FaceView& face : faces) {
        if (!may_touch(face.outline, pixel)) continue;
        for (const Point& p : face.outline)
            bits_ = std::max({bits_, bits_after_the_point(p.x), bits_after_the_point(p.y)});
    }
    std::vector<const HomogeneousPoint*> corners;
    const mpz_class one = mpz_class(1) << static_cast<mp_bitcnt_t>(bits_);
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
        corners.push_back(&points_.emplace_back(HomogeneousPoint{x * one, y * one, 1}));
    square_ = polygon_through(corners);
    for (const FaceView& face : faces) polygons_.push_back(in_pixel(face));
}

/// Common factors 2^n are taken out: they would only make every later number longer.
void shorten(Line& line) {
    if (line.a == 0 && line.b == 0) return;
    const mp_bitcnt_t zeros =
        std::min({mpz_scan1(line.a.get_mpz_t(), 0), mpz_scan1(line.b.get_mpz_t(), 0),
                  mpz_scan1(line.c.get_mpz_t(), 0)});  // mpz_scan1 of 0 is the largest number
    line.a >>= zeros;
    line.b >>= zeros;
    line.c >>= zeros;
}

/// Requires: p and q given points, that is, w = 1.
const Line* Splitting::line_through(const HomogeneousPoint& p, const HomogeneousPoint& q) {
    Line line{p.y - q.y, q.x - p.x, p.x * q.y - p.y * q.x};
    shorten(line);
    return &lines_.emplace_back(std::move(line));
}

const HomogeneousPoint* Splitting::meeting_point(const Line& first, const Line& second) {
    HomogeneousPoint& point = points_.emplace_back();
    const auto minor = [](mpz_class& result, const mpz_class& p, const mpz_class& q, const mpz_class& r,
                          const mpz_class& s) {
        mpz_mul(result.get_mpz_t(), p.get_mpz_t(), s.get_mpz_t());
        mpz_submul(result.get_mpz_t(), q.get_mpz_t(), r.get_mpz_t());
    };
    minor(point.x, first.b, first.c, second.b, second.c);
    minor(point.y, first.c, first.a, second.c, second.a);
    minor(point.w, first.a, first.b, second.a, second.b);
    if (point.w < 0) {
        mpz_neg(point.x.get_mpz_t(), point.x.get_mpz_t());
        mpz_neg(point.y.get_mpz_t(), point.y.get_mpz_t());
        mpz_neg(point.w.get_mpz_t(), point.w.get_mpz_t());
    }
    return &point;
}

/// 1 to the left, 0 on the line, -1 to the right.
int Splitting::side(const Line& line, const HomogeneousPoint& point) {
    mpz_mul(sum_.get_mpz_t(), line.a.get_mpz_t(), point.x.get_mpz_t());
    mpz_addmul(sum_.get_mpz_t(), line.b.get_mpz_t(), point.y.get_mpz_t());
    mpz_addmul(sum_.get_mpz_t(), line.c.get_mpz_t(), point.w.get_mpz_t());
    return sgn(sum_);
}

/// The border of either half runs along `line` where the cut is; a half without area is empty.
Halves Splitting::split(const ConvexPolygon& polygon, const Line* line) {
    Halves halves;
    bool has_left = false, has_right = false;
    if (polygon.empty()) return halves;
    int here = side(*line, *polygon.front().point);
    const int first = here;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner& corner = polygon[i];
        const int next = i + 1 < polygon.size() ? side(*line, *polygon[i + 1].point) : first;
        has_left = has_left || here > 0;
        has_right = has_right || here < 0;
        // On the line, the half that the border is leaving goes on along the line instead.
        if (here > 0 || (here == 0 && next > 0)) halves.left.push_back(corner);
        if (here < 0 || (here == 0 && next < 0)) halves.right.push_back(corner);
        if (here == 0 && next <= 0) halves.left.push_back({corner.point, line});
        if (here == 0 && next >= 0) halves.right.push_back({corner.point, line});
        if (here * next < 0) {
            const HomogeneousPoint* cut = meeting_point(*corner.line, *line);
            halves.left.push_back({cut, next > 0 ? corner.line : line});
            halves.right.push_back({cut, next > 0 ? line : corner.line});
        }
        here = next;
    }
    if (!has_left) return {{}, polygon};
    if (!has_right) return {polygon, {}};
    return halves;
}

ConvexPolygon Splitting::polygon_through(const std::vector<const HomogeneousPoint*>& ring) {
    ConvexPolygon polygon;
    for (std::size_t i = 0; i < ring.size(); ++i)
        polygon.push_back({ring[i], line_through(*ring[i], *ring[(i + 1) % ring.size()])});
    return polygon;
}

/// The convex hull, strictly convex, by Andrew's monotone chains; empty if it has no area.
std::vector<const HomogeneousPoint*> Splitting::hull(std::span<const Point> outline) {
    std::vector<Point> sorted(outline.begin(), outline.end());
    std::ranges::sort(sorted, [](const Point& p, const Point& q) {
        return p.x != q.x ? p.x < q.x : p.y < q.y;
    });
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    std::vector<const HomogeneousPoint*> exact;
    const mpz_class one = mpz_class(1) << static_cast<mp_bitcnt_t>(bits_);
    for (const Point& p : sorted)
        exact.push_back(&points_.emplace_back(
            HomogeneousPoint{scaled(p.x, bits_) - pixel_.x * one, scaled(p.y, bits_) - pixel_.y * one, 1}));
    if (exact.size() < 3) return {};

    const auto turns_left = [](const HomogeneousPoint& p, const HomogeneousPoint& q, const HomogeneousPoint& r) {
        return (q.x - p.x) * (r.y - p.y) > (q.y - p.y) * (r.x - p.x);
    };
    std::vector<const HomogeneousPoint*> ring;
    const auto add_chain = [&](auto from, auto to) {
        const std::size_t start = ring.size();
        for (; from != to; ++from) {
            while (ring.size() >= start + 2 && !turns_left(*ring[ring.size() - 2], *ring.back(), **from))
                ring.pop_back();
            ring.push_back(*from);
        }
        ring.pop_back();  // the next chain starts with it
    };
    add_chain(exact.begin(), exact.end());
    add_chain(exact.rbegin(), exact.rend());
    return ring.size() >= 3 ? ring : std::vector<const HomogeneousPoint*>{};
}

ConvexPolygon Splitting::in_pixel(const FaceView& face) {
    if (!may_touch(face.outline, pixel_)) return {};
    ConvexPolygon inside = square_;
    const ConvexPolygon outline = polygon_through(hull(face.outline));
    if (outline.empty()) return {};
    for (const Corner& corner : outline) inside = split(inside, corner.line).left;
    return inside;
}

/// The part of face `other` in the pixel where it is nearer than face `face`.
ConvexPolygon Splitting::where_nearer(std::size_t other, std::size_t face) {
    const ConvexPolygon& polygon = polygons_[other];
    if (nearness_ == Nearness::InOrder) return other < face ? polygon : ConvexPolygon{};
    const DepthPlane& u = faces_[other].depth;
    const DepthPlane& v = faces_[face].depth;
    int bits = 0;
    for (const double value : {u.a, u.b, u.c, v.a, v.b, v.c}) bits = std::max(bits, bits_after_the_point(value));
    // With x = X / 2^s, the difference of the planes is taken 2^(bits + s) times.
    Line difference{scaled(u.a, bits) - scaled(v.a, bits), scaled(u.b, bits) - scaled(v.b, bits),
                    scaled(u.c, bits) - scaled(v.c, bits)};
    difference.c += difference.a * pixel_.x + difference.b * pixel_.y;
    difference.c <<= static_cast<mp_bitcnt_t>(bits_);
    shorten(difference);
    if (difference.a == 0 && difference.b == 0) {
        const bool smaller = std::pair(faces_[other].id, other) < std::pair(faces_[face].id, face);
        const bool nearer = difference.c != 0 ? difference.c > 0 : smaller;
        return nearer ? polygon : ConvexPolygon{};
    }
    return split(polygon, &lines_.emplace_back(std::move(difference))).left;
}

/// Takes `hiding` away from every piece: what lies right of one of its lines stays.
void Splitting::subtract(std::vector<ConvexPolygon>& pieces, const ConvexPolygon& hiding) {
    if (hiding.empty()) return;
    std::vector<ConvexPolygon> left_over;
    for (ConvexPolygon& piece : pieces) {
        ConvexPolygon inside = piece;
        const std::size_t before = left_over.size();
        for (const Corner& corner : hiding) {
            Halves halves = split(inside, corner.line);
            inside = std::move(halves.left);
            if (!halves.right.empty()) left_over.push_back(std::move(halves.right));
            if (inside.empty()) break;
        }
        if (!inside.empty()) continue;  // hidden
        left_over.resize(before);  // nothing of it is hidden: it stays whole
        left_over.push_back(std::move(piece));
    }
    pieces = std::move(left_over);
}

/// A fraction that need not be in lowest terms.
struct Fraction {
    mpz_class over, under;
};

/// The sum, by halves, so that the numbers multiplied are of like length.
Fraction sum(std::span<const Fraction> terms) {
    if (terms.empty()) return {0, 1};
    if (terms.size() == 1) return terms[0];
    const Fraction first = sum(terms.first(terms.size() / 2));
    const Fraction second = sum(terms.last(terms.size() - terms.size() / 2));
    return {first.over * second.under + second.over * first.under, first.under * second.under};
}

/// The area of all pieces together, in square pixels.
///
/// Twice the area is the sum over all sides p q of the cross product p x q. Along A x + B y + C = 0 the side
/// is q - p = t (B, -A), and p x q = C t: a difference of two values that belong to an end and its line. An end
/// between two neighbouring pieces occurs with either sign and drops out before any fraction is added.
mpq_class Splitting::area(std::span<const ConvexPolygon> pieces) {
    struct End {
        const HomogeneousPoint* point;
        const Line* line;
        long count;
        bool operator<(const End& other) const {
            return std::pair(point, line) < std::pair(other.point, other.line);
        }
    };
    std::vector<End> ends;
    for (const ConvexPolygon& piece : pieces)
        for (std::size_t i = 0; i < piece.size(); ++i) {
            ends.push_back({piece[i].point, piece[i].line, -1});
            ends.push_back({piece[(i + 1) % piece.size()].point, piece[i].line, 1});
        }
    std::ranges::sort(ends, std::less<>());

    std::vector<Fraction> terms;
    for (std::size_t i = 0; i < ends.size();) {
        const auto& [point, line, unused] = ends[i];
        long count = 0;
        for (; i < ends.size() && ends[i].point == point && ends[i].line == line; ++i) count += ends[i].count;
        if (count == 0 || line->c == 0) continue;
        if (line->b != 0)
            terms.push_back({count * line->c * point->x, line->b * point->w});
        else
            terms.push_back({-count * line->c * point->y, line->a * point->w});
    }
    const Fraction twice = sum(terms);
    mpq_class area(twice.over, twice.under << static_cast<mp_bitcnt_t>(2 * bits_ + 1));
    area.canonicalize();
    return area;
}

ExactAreas Splitting::areas() {
    ExactAreas result;
    std::vector<ConvexPolygon> background = {square_};
    mpq_class total = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        std::vector<ConvexPolygon> visible = {polygons_[i]};
        if (polygons_[i].empty()) visible.clear();
        for (std::size_t j = 0; j < faces_.size() && !visible.empty(); ++j)
            if (j != i && !polygons_[j].empty()) subtract(visible, where_nearer(j, i));
        subtract(background, polygons_[i]);
        const mpq_class seen = area(visible);
        total += seen;
        result.areas.emplace_back(seen.get_mpq_t());
    }
    const mpq_class free = area(background);
    if (total + free != 1) throw std::logic_error("rational splitting: the areas do not add up to 1");
    result.background = CGAL::Gmpq(free.get_mpq_t());
    return result;
}

}  // namespace

ExactAreas areas_by_rational_splitting(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness) {
    return Splitting(pixel, faces, nearness).areas();
}

}  // namespace keikan::oracle

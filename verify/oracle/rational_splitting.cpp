// SPDX-License-Identifier: GPL-3.0-or-later
// Exact areas by cutting convex polygons, written as lists of points, along lines.
//
// A point is X/W, Y/W with integers X, Y, W; a line has integer coefficients. A cut is always made with the
// line itself, never with a line through points that were cut before: so the integers have a bounded length,
// however often a polygon is cut.
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
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

/// a x + b y + c = 0, pixel-local; the positive side is to the left of the direction of travel.
struct Line {
    mpz_class a, b, c;
    double near_a = 0, near_b = 0, near_c = 0;  ///< with a common factor that makes the largest at most 1
};

/// A point of the pixel lies on that side of a line on which the rounded value says that it lies, if the
/// value is larger than this: x and y are off by 2^-50 and at most 1, a, b, c by 2^-52 of their size, which
/// is at most 1, and five roundings add 2^-53 of a sum of at most 3.
constexpr double kUncertainValue = 0x1p-47;

/// (x/w, y/w), w > 0, pixel-local.
struct HomogeneousPoint {
    mpz_class x, y, w;
    double near_x = 0, near_y = 0;  ///< of a point of the pixel: within 2^-50, for bounding boxes
};

/// A corner of a convex polygon and the line along which its border goes on.
struct Corner {
    const HomogeneousPoint* point;
    const Line* line;
};

/// Counter-clockwise (with y upwards), strictly convex; empty where there is no area.
using ConvexPolygon = std::vector<Corner>;

/// Rounded outwards: what lies apart from it is apart.
struct Box {
    double x0 = 2, y0 = 2, x1 = -2, y1 = -2;

    bool apart_from(const Box& other) const {
        return x1 < other.x0 || other.x1 < x0 || y1 < other.y0 || other.y1 < y0;
    }
};

Box box_of(const ConvexPolygon& polygon) {
    Box box;
    for (const auto& [point, line] : polygon) {
        box.x0 = std::min(box.x0, point->near_x - 0x1p-48);
        box.y0 = std::min(box.y0, point->near_y - 0x1p-48);
        box.x1 = std::max(box.x1, point->near_x + 0x1p-48);
        box.y1 = std::max(box.y1, point->near_y + 0x1p-48);
    }
    return box;
}

struct Halves {
    ConvexPolygon left;
    ConvexPolygon right;
};

/// One question, with all its points and lines.
class Splitting {
  public:
    Splitting(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness);
    Splitting(PixelIndex pixel, std::span<const RationalFace> faces);
    ExactAreas areas();

  private:
    const Line* add_line(Line line);
    const Line* line_through(const HomogeneousPoint& p, const HomogeneousPoint& q);
    const HomogeneousPoint* meeting_point(const Line& first, const Line& second);
    int side(const Line& line, const HomogeneousPoint& point);
    Halves split(const ConvexPolygon& polygon, const Line* line);
    ConvexPolygon polygon_through(const std::vector<const HomogeneousPoint*>& ring);
    void add_square();
    std::vector<const HomogeneousPoint*> hull(std::span<const Point> outline);
    std::vector<const HomogeneousPoint*> hull(const std::vector<RationalPoint>& outline);
    ConvexPolygon in_pixel(const std::vector<const HomogeneousPoint*>& hull);
    Line difference(const DepthPlane& u, const DepthPlane& v) const;
    Line difference(const RationalFace& u, const RationalFace& v) const;
    ConvexPolygon where_nearer(std::size_t other, std::size_t face);
    void subtract(std::vector<ConvexPolygon>& pieces, const ConvexPolygon& hiding);
    mpq_class area(std::span<const ConvexPolygon> pieces);
    std::vector<std::size_t> likely_hiding() const;

    PixelIndex pixel_;
    std::span<const FaceView> faces_;
    std::span<const RationalFace> rational_faces_;  ///< instead of `faces_`
    Nearness nearness_;
    std::vector<FaceId> ids_;
    std::deque<HomogeneousPoint> points_;
    std::deque<Line> lines_;
    ConvexPolygon square_;
    std::vector<ConvexPolygon> polygons_;  ///< of the faces, in the pixel
    std::vector<Box> boxes_;               ///< of these
    mpz_class sum_, other_sum_;            ///< kept, so that a side test allocates nothing
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
    add_square();
    for (const FaceView& face : faces) {
        ids_.push_back(face.id);
        polygons_.push_back(may_touch(face.outline, pixel_) ? in_pixel(hull(face.outline)) : ConvexPolygon{});
        boxes_.push_back(box_of(polygons_.back()));
    }
}

Splitting::Splitting(PixelIndex pixel, std::span<const RationalFace> faces)
    : pixel_(pixel), rational_faces_(faces), nearness_(Nearness::ByDepth) {
    add_square();
    for (const RationalFace& face : faces) {
        ids_.push_back(face.id);
        polygons_.push_back(in_pixel(hull(face.outline)));
        boxes_.push_back(box_of(polygons_.back()));
    }
}

void Splitting::add_square() {
    std::vector<const HomogeneousPoint*> corners;
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
        corners.push_back(&points_.emplace_back(HomogeneousPoint{x, y, 1, double(x), double(y)}));
    square_ = polygon_through(corners);
}

const Line* Splitting::add_line(Line line) {
    // Common factors 2^n would only make every later number longer. (mpz_scan1 of 0 is the largest number.)
    const mp_bitcnt_t zeros = std::min({mpz_scan1(line.a.get_mpz_t(), 0), mpz_scan1(line.b.get_mpz_t(), 0),
                                        mpz_scan1(line.c.get_mpz_t(), 0)});
    line.a >>= zeros;
    line.b >>= zeros;
    line.c >>= zeros;
    const auto length =
        std::max({mpz_sizeinbase(line.a.get_mpz_t(), 2), mpz_sizeinbase(line.b.get_mpz_t(), 2),
                  mpz_sizeinbase(line.c.get_mpz_t(), 2)});
    const auto near = [length](const mpz_class& value) {
        long exponent = 0;
        const double mantissa = mpz_get_d_2exp(&exponent, value.get_mpz_t());
        return std::ldexp(mantissa, static_cast<int>(exponent - static_cast<long>(length)));
    };
    line.near_a = near(line.a);
    line.near_b = near(line.b);
    line.near_c = near(line.c);
    return &lines_.emplace_back(std::move(line));
}

const Line* Splitting::line_through(const HomogeneousPoint& p, const HomogeneousPoint& q) {
    return add_line({p.y * q.w - q.y * p.w, q.x * p.w - p.x * q.w, p.x * q.y - p.y * q.x});
}

/// Within 2^-50 of over / under, if that is at most 1 in size.
double quotient(const mpz_class& over, const mpz_class& under) {
    long over_exponent = 0, under_exponent = 0;
    const double first = mpz_get_d_2exp(&over_exponent, over.get_mpz_t());
    const double second = mpz_get_d_2exp(&under_exponent, under.get_mpz_t());
    return std::ldexp(first / second, static_cast<int>(over_exponent - under_exponent));
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
    point.near_x = quotient(point.x, point.w);
    point.near_y = quotient(point.y, point.w);
    return &point;
}

/// 1 to the left, 0 on the line, -1 to the right. Requires: a point of the pixel.
int Splitting::side(const Line& line, const HomogeneousPoint& point) {
    const double value = line.near_a * point.near_x + line.near_b * point.near_y + line.near_c;
    if (std::abs(value) > kUncertainValue) return value > 0 ? 1 : -1;
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

/// The convex hull, strictly convex, of points sorted by x and then by y, by Andrew's monotone chains; empty
/// if it has no area.
std::vector<const HomogeneousPoint*> hull_of(const std::vector<const HomogeneousPoint*>& sorted) {
    if (sorted.size() < 3) return {};
    const auto turns_left = [](const HomogeneousPoint& p, const HomogeneousPoint& q,
                               const HomogeneousPoint& r) {
        return p.x * (q.y * r.w - r.y * q.w) + p.y * (r.x * q.w - q.x * r.w) + p.w * (q.x * r.y - r.x * q.y) >
               0;
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
    add_chain(sorted.begin(), sorted.end());
    add_chain(sorted.rbegin(), sorted.rend());
    return ring.size() >= 3 ? ring : std::vector<const HomogeneousPoint*>{};
}

std::vector<const HomogeneousPoint*> Splitting::hull(std::span<const Point> outline) {
    std::vector<Point> sorted(outline.begin(), outline.end());
    std::ranges::sort(sorted,
                      [](const Point& p, const Point& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    std::vector<const HomogeneousPoint*> exact;
    for (const Point& p : sorted) {
        const int bits = std::max(bits_after_the_point(p.x), bits_after_the_point(p.y));
        const mpz_class one = mpz_class(1) << static_cast<mp_bitcnt_t>(bits);
        exact.push_back(&points_.emplace_back(
            HomogeneousPoint{scaled(p.x, bits) - pixel_.x * one, scaled(p.y, bits) - pixel_.y * one, one}));
    }
    return hull_of(exact);
}

std::vector<const HomogeneousPoint*> Splitting::hull(const std::vector<RationalPoint>& outline) {
    std::vector<const HomogeneousPoint*> sorted;
    for (const RationalPoint& p : outline)
        sorted.push_back(
            &points_.emplace_back(HomogeneousPoint{p.x - pixel_.x * p.w, p.y - pixel_.y * p.w, p.w}));
    const auto order = [](const HomogeneousPoint* p, const HomogeneousPoint* q) {
        const int by_x = cmp(p->x * q->w, q->x * p->w);
        return by_x != 0 ? by_x : cmp(p->y * q->w, q->y * p->w);
    };
    std::ranges::sort(sorted, [&](auto* p, auto* q) { return order(p, q) < 0; });
    sorted.erase(
        std::unique(sorted.begin(), sorted.end(), [&](auto* p, auto* q) { return order(p, q) == 0; }),
        sorted.end());
    return hull_of(sorted);
}

ConvexPolygon Splitting::in_pixel(const std::vector<const HomogeneousPoint*>& hull) {
    ConvexPolygon inside = square_;
    const ConvexPolygon outline = polygon_through(hull);
    if (outline.empty()) return {};
    for (const Corner& corner : outline) inside = split(inside, corner.line).left;
    return inside;
}

/// Where u = v, pixel-local; u is larger on the positive side.
Line Splitting::difference(const DepthPlane& u, const DepthPlane& v) const {
    int bits = 0;
    for (const double value : {u.a, u.b, u.c, v.a, v.b, v.c})
        bits = std::max(bits, bits_after_the_point(value));
    Line line{scaled(u.a, bits) - scaled(v.a, bits), scaled(u.b, bits) - scaled(v.b, bits),
              scaled(u.c, bits) - scaled(v.c, bits)};
    line.c += line.a * pixel_.x + line.b * pixel_.y;
    return line;
}

Line Splitting::difference(const RationalFace& u, const RationalFace& v) const {
    const mpq_class a = u.a - v.a, b = u.b - v.b;
    const mpq_class c = u.c - v.c + a * pixel_.x + b * pixel_.y;
    mpz_class common;
    mpz_lcm(common.get_mpz_t(), a.get_den_mpz_t(), b.get_den_mpz_t());
    mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), c.get_den_mpz_t());
    const auto whole = [&](const mpq_class& value) -> mpz_class {
        return value.get_num() * (common / value.get_den());
    };
    return {whole(a), whole(b), whole(c)};
}

/// The part of face `other` in the pixel where it is nearer than face `face`.
ConvexPolygon Splitting::where_nearer(std::size_t other, std::size_t face) {
    const ConvexPolygon& polygon = polygons_[other];
    if (nearness_ == Nearness::InOrder) return other < face ? polygon : ConvexPolygon{};
    Line over = rational_faces_.empty() ? difference(faces_[other].depth, faces_[face].depth)
                                        : difference(rational_faces_[other], rational_faces_[face]);
    if (over.a == 0 && over.b == 0) {
        const bool smaller = std::pair(ids_[other], other) < std::pair(ids_[face], face);
        const bool nearer = over.c != 0 ? over.c > 0 : smaller;
        return nearer ? polygon : ConvexPolygon{};
    }
    return split(polygon, add_line(std::move(over))).left;
}

/// Takes `hiding` away from every piece: what lies right of one of its lines stays.
void Splitting::subtract(std::vector<ConvexPolygon>& pieces, const ConvexPolygon& hiding) {
    if (hiding.empty()) return;
    const Box box = box_of(hiding);
    std::vector<ConvexPolygon> left_over;
    for (ConvexPolygon& piece : pieces) {
        if (box.apart_from(box_of(piece))) {
            left_over.push_back(std::move(piece));
            continue;
        }
        ConvexPolygon inside = piece;
        const std::size_t before = left_over.size();
        for (const Corner& corner : hiding) {
            Halves halves = split(inside, corner.line);
            inside = std::move(halves.left);
            if (!halves.right.empty()) left_over.push_back(std::move(halves.right));
            if (inside.empty()) break;
        }
        if (!inside.empty()) continue;  // hidden
        left_over.resize(before);       // nothing of it is hidden: it stays whole
        left_over.push_back(std::move(piece));
    }
    pieces = std::move(left_over);
}

/// The sum, by halves, so that the numbers added are of like length.
mpq_class sum(std::span<const mpq_class> terms) {
    if (terms.empty()) return 0;
    if (terms.size() == 1) return terms[0];
    return sum(terms.first(terms.size() / 2)) + sum(terms.last(terms.size() - terms.size() / 2));
}

/// The area of all pieces together, in square pixels.
///
/// Twice the area is the sum over all sides p q of the cross product p x q. Along a x + b y + c = 0 the side
/// is q - p = t (b, -a), and p x q = c t: a difference of two values that belong to an end and its line. An
/// end between two neighbouring pieces occurs with either sign and drops out. The ends left on a line are
/// paired in any way, for the sum is the same; each pair gives one fraction.
mpq_class Splitting::area(std::span<const ConvexPolygon> pieces) {
    struct End {
        const Line* line;
        const HomogeneousPoint* point;
        int count;
    };
    std::vector<End> ends;
    for (const ConvexPolygon& piece : pieces)
        for (std::size_t i = 0; i < piece.size(); ++i) {
            if (piece[i].line->c == 0) continue;
            ends.push_back({piece[i].line, piece[i].point, -1});
            ends.push_back({piece[i].line, piece[(i + 1) % piece.size()].point, 1});
        }
    std::ranges::sort(ends, std::less<>(), [](const End& end) { return std::pair(end.line, end.point); });

    std::vector<mpq_class> terms;
    std::vector<const HomogeneousPoint*> starts, finishes;
    for (std::size_t i = 0; i < ends.size();) {
        const auto [line, point, unused] = ends[i];
        int count = 0;
        for (; i < ends.size() && ends[i].line == line && ends[i].point == point; ++i) count += ends[i].count;
        for (; count < 0; ++count) starts.push_back(point);
        for (; count > 0; --count) finishes.push_back(point);
        if (i < ends.size() && ends[i].line == line) continue;
        for (std::size_t pair = 0; pair < starts.size(); ++pair) {
            const HomogeneousPoint &p = *starts[pair], &q = *finishes[pair];
            terms.emplace_back(p.x * q.y - q.x * p.y, p.w * q.w).canonicalize();
        }
        starts.clear();
        finishes.clear();
    }
    return sum(terms) / 2;
}

/// Positions in the list, the face that probably hides most first. Only speed depends on it.
std::vector<std::size_t> Splitting::likely_hiding() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < polygons_.size(); ++i)
        if (!polygons_[i].empty()) order.push_back(i);
    if (nearness_ == Nearness::InOrder) return order;
    std::vector<double> in_middle;
    for (const auto& [id, outline, depth] : faces_)
        in_middle.push_back(depth.a * (pixel_.x + 0.5) + depth.b * (pixel_.y + 0.5) + depth.c);
    for (const RationalFace& face : rational_faces_)
        in_middle.push_back(mpq_class(face.a * pixel_.x + face.b * pixel_.y + face.c).get_d());
    std::ranges::stable_sort(order, std::greater<>(),
                             [&](std::size_t i) { return std::isnan(in_middle[i]) ? 0 : in_middle[i]; });
    return order;
}

ExactAreas Splitting::areas() {
    ExactAreas result;
    const std::vector<std::size_t> order = likely_hiding();
    std::vector<ConvexPolygon> background = {square_};
    mpq_class total = 0;
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
        std::vector<ConvexPolygon> visible = {polygons_[i]};
        if (polygons_[i].empty()) visible.clear();
        for (const std::size_t j : order) {
            if (visible.empty()) break;
            if (j != i && !boxes_[j].apart_from(boxes_[i])) subtract(visible, where_nearer(j, i));
        }
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

ExactAreas areas_by_rational_splitting(PixelIndex pixel, std::span<const RationalFace> faces) {
    return Splitting(pixel, faces).areas();
}

}  // namespace keikan::oracle

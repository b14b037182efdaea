// SPDX-License-Identifier: GPL-3.0-or-later
// Exact areas by cutting convex polygons, written as lists of corners, along lines.
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "enclosed_area.hpp"
#include "exact_areas.hpp"
#include "rational_lines.hpp"

namespace keikan::oracle {
namespace {

/// A corner of a convex polygon and the line along which its border goes on.
struct Corner {
    const RationalCorner* point;
    DirectedLine line;
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

/// Where a polygon lies, seen from a line.
enum class Place { Left, Right, Across };

/// The points of an outline, sorted by x and then by y, each once.
using SortedCorners = std::vector<const RationalCorner*>;

/// One question after the other; the memory is kept.
class Splitting {
  public:
    ExactAreas areas(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness);
    ExactAreas areas(PixelIndex pixel, std::span<const RationalFace* const> faces);

  private:
    void start(PixelIndex pixel, std::size_t faces, int unit_bits);
    void add_face(FaceId id, const SortedCorners& outline);
    ExactAreas areas();
    Place split(const ConvexPolygon& polygon, DirectedLine line);
    SortedCorners sorted(std::span<const Point> outline);
    SortedCorners sorted(const std::vector<RationalPoint>& outline);
    SortedCorners hull_of(const SortedCorners& sorted);
    ConvexPolygon polygon_through(const SortedCorners& ring);
    ConvexPolygon in_pixel(const SortedCorners& hull);
    void set_difference(const DepthPlane& u, const DepthPlane& v);
    void set_difference(const RationalFace& u, const RationalFace& v);
    const ConvexPolygon& where_nearer(std::size_t other, std::size_t face);
    void subtract(const ConvexPolygon& hiding, const Box& box);
    mpq_class area_of_pieces();
    std::vector<std::size_t> likely_hiding() const;

    struct Piece {
        ConvexPolygon polygon;
        Box box;
    };
    /// The difference of two faces' depth planes, the first having the smaller position.
    struct DepthLine {
        const RationalLine* line = nullptr;  ///< where they are equal; none: the sign is the same everywhere
        int sign = 0;
        bool known = false;
    };

    PixelIndex pixel_;
    std::span<const FaceView> faces_;
    std::span<const RationalFace* const> rational_faces_;  ///< instead of `faces_`
    Nearness nearness_ = Nearness::InOrder;
    std::vector<FaceId> ids_;
    RationalLines lines_;
    ConvexPolygon square_;
    std::vector<ConvexPolygon> polygons_;  ///< of the faces, in the pixel
    std::vector<Box> boxes_;               ///< of these
    std::vector<DepthLine> depth_lines_;   ///< of pairs
    std::vector<Piece> pieces_, left_over_;
    EnclosedArea enclosed_area_;

    // Kept, so that their memory is.
    ConvexPolygon left_, right_, inside_, nearer_;
    std::vector<int> sides_;
    mpz_class a_, b_, c_;
    struct End {
        const RationalLine* line;
        const RationalCorner* point;
        int count;
    };
    std::vector<End> ends_;
    std::vector<OutlineSide> outline_;
    std::vector<const RationalCorner*> starts_, finishes_;
};

const ConvexPolygon kNothing;

/// False if the outline's bounding box has no area in common with the pixel.
bool may_touch(std::span<const Point> outline, PixelIndex pixel) {
    if (outline.empty()) return false;
    const auto [left, right] = std::ranges::minmax(outline, {}, &Point::x);
    const auto [top, bottom] = std::ranges::minmax(outline, {}, &Point::y);
    return left.x < pixel.x + 1 && right.x > pixel.x && top.y < pixel.y + 1 && bottom.y > pixel.y;
}

ExactAreas Splitting::areas(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness) {
    faces_ = faces;
    rational_faces_ = {};
    nearness_ = nearness;
    int unit_bits = 0;
    for (const FaceView& face : faces)
        if (may_touch(face.outline, pixel))
            for (const Point& p : face.outline)
                unit_bits = std::max({unit_bits, bits_after_the_point(p.x), bits_after_the_point(p.y)});
    start(pixel, faces.size(), unit_bits);
    for (const FaceView& face : faces)
        add_face(face.id, may_touch(face.outline, pixel) ? sorted(face.outline) : SortedCorners{});
    return areas();
}

ExactAreas Splitting::areas(PixelIndex pixel, std::span<const RationalFace* const> faces) {
    faces_ = {};
    rational_faces_ = faces;
    nearness_ = Nearness::ByDepth;
    start(pixel, faces.size(), 0);
    for (const RationalFace* face : faces) add_face(face->id, sorted(face->outline));
    return areas();
}

void Splitting::start(PixelIndex pixel, std::size_t faces, int unit_bits) {
    pixel_ = pixel;
    lines_.start(pixel, unit_bits);
    ids_.clear();
    polygons_.clear();
    boxes_.clear();
    depth_lines_.assign(nearness_ == Nearness::ByDepth ? faces * faces : 0, {});
    square_ = polygon_through({lines_.pixel_corner(0, 0), lines_.pixel_corner(1, 0),
                               lines_.pixel_corner(1, 1), lines_.pixel_corner(0, 1)});
}

void Splitting::add_face(FaceId id, const SortedCorners& outline) {
    ids_.push_back(id);
    polygons_.push_back(in_pixel(hull_of(outline)));
    boxes_.push_back(box_of(polygons_.back()));
}

/// Across: the parts are in `left_` and `right_`, and the border of either runs along `line` where the cut
/// is. Requires: the polygon has an area.
Place Splitting::split(const ConvexPolygon& polygon, DirectedLine line) {
    sides_.clear();
    bool has_left = false, has_right = false;
    for (const Corner& corner : polygon) {
        sides_.push_back(lines_.side(*corner.point, line));
        has_left = has_left || sides_.back() > 0;
        has_right = has_right || sides_.back() < 0;
    }
    if (!has_right) return Place::Left;
    if (!has_left) return Place::Right;
    const DirectedLine back = {line.line, -line.sense};
    left_.clear();
    right_.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner& corner = polygon[i];
        const int here = sides_[i], next = sides_[i + 1 < polygon.size() ? i + 1 : 0];
        // On the line, the half that the border is leaving goes on along the line instead.
        if (here > 0 || (here == 0 && next > 0)) left_.push_back(corner);
        if (here < 0 || (here == 0 && next < 0)) right_.push_back(corner);
        if (here == 0 && next <= 0) left_.push_back({corner.point, line});
        if (here == 0 && next >= 0) right_.push_back({corner.point, back});
        if (here * next < 0) {
            const RationalCorner* cut = lines_.meeting_point(corner.line.line, line.line);
            left_.push_back({cut, next > 0 ? corner.line : line});
            right_.push_back({cut, next > 0 ? back : corner.line});
        }
    }
    return Place::Across;
}

ConvexPolygon Splitting::polygon_through(const SortedCorners& ring) {
    ConvexPolygon polygon;
    for (std::size_t i = 0; i < ring.size(); ++i)
        polygon.push_back({ring[i], lines_.line_through(ring[i], ring[(i + 1) % ring.size()])});
    for (std::size_t i = 0; i < polygon.size(); ++i)
        lines_.lines_meet_at(polygon[i > 0 ? i - 1 : polygon.size() - 1].line.line, polygon[i].line.line,
                             polygon[i].point);
    return polygon;
}

SortedCorners Splitting::sorted(std::span<const Point> outline) {
    std::vector<Point> points(outline.begin(), outline.end());
    std::ranges::sort(points,
                      [](const Point& p, const Point& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    SortedCorners corners;
    for (const Point& p : points) corners.push_back(lines_.corner(p));
    return corners;
}

SortedCorners Splitting::sorted(const std::vector<RationalPoint>& outline) {
    SortedCorners corners;
    for (const RationalPoint& p : outline) corners.push_back(lines_.corner(p));
    const auto order = [](const RationalCorner* p, const RationalCorner* q) {
        const int by_x = cmp(p->x * q->w, q->x * p->w);
        return by_x != 0 ? by_x : cmp(p->y * q->w, q->y * p->w);
    };
    std::ranges::sort(corners, [&](auto* p, auto* q) { return order(p, q) < 0; });
    corners.erase(
        std::unique(corners.begin(), corners.end(), [&](auto* p, auto* q) { return order(p, q) == 0; }),
        corners.end());
    return corners;
}

/// The convex hull, strictly convex, by Andrew's monotone chains; empty if it has no area.
SortedCorners Splitting::hull_of(const SortedCorners& sorted) {
    if (sorted.size() < 3) return {};
    SortedCorners ring;
    const auto add_chain = [&](auto from, auto to) {
        const std::size_t start = ring.size();
        for (; from != to; ++from) {
            while (ring.size() >= start + 2 &&
                   !lines_.turns_left(*ring[ring.size() - 2], *ring.back(), **from))
                ring.pop_back();
            ring.push_back(*from);
        }
        ring.pop_back();  // the next chain starts with it
    };
    add_chain(sorted.begin(), sorted.end());
    add_chain(sorted.rbegin(), sorted.rend());
    return ring.size() >= 3 ? ring : SortedCorners{};
}

ConvexPolygon Splitting::in_pixel(const SortedCorners& hull) {
    if (hull.empty()) return {};
    ConvexPolygon inside = square_;
    for (const Corner& corner : polygon_through(hull)) {
        const Place place = split(inside, corner.line);
        if (place == Place::Right) return {};
        if (place == Place::Across) inside.swap(left_);
    }
    return inside;
}

/// a_ x + b_ y + c_ = 0, pixel-local, where u = v; u is larger on the positive side.
void Splitting::set_difference(const DepthPlane& u, const DepthPlane& v) {
    int bits = 0;
    for (const double value : {u.a, u.b, u.c, v.a, v.b, v.c})
        bits = std::max(bits, bits_after_the_point(value));
    a_ = scaled(u.a, bits) - scaled(v.a, bits);
    b_ = scaled(u.b, bits) - scaled(v.b, bits);
    c_ = scaled(u.c, bits) - scaled(v.c, bits);
    c_ += a_ * pixel_.x + b_ * pixel_.y;
}

void Splitting::set_difference(const RationalFace& u, const RationalFace& v) {
    a_ = u.a * v.unit - v.a * u.unit;
    b_ = u.b * v.unit - v.b * u.unit;
    c_ = u.c * v.unit - v.c * u.unit;
    c_ += a_ * pixel_.x + b_ * pixel_.y;
}

/// The part of face `other` in the pixel where it is nearer than face `face`. It lasts until the next call.
const ConvexPolygon& Splitting::where_nearer(std::size_t other, std::size_t face) {
    const ConvexPolygon& polygon = polygons_[other];
    if (nearness_ == Nearness::InOrder) return other < face ? polygon : kNothing;
    const auto [first, second] = std::minmax(other, face);
    DepthLine& depth = depth_lines_[first * polygons_.size() + second];
    if (!depth.known) {
        depth.known = true;
        if (rational_faces_.empty())
            set_difference(faces_[first].depth, faces_[second].depth);
        else
            set_difference(*rational_faces_[first], *rational_faces_[second]);
        if (a_ != 0 || b_ != 0)
            depth.line = lines_.line_of(a_, b_, c_);
        else
            depth.sign = c_ != 0 ? sgn(c_) : ids_[first] <= ids_[second] ? 1 : -1;
    }
    const int sense = other == first ? 1 : -1;
    if (depth.line == nullptr) return depth.sign == sense ? polygon : kNothing;
    switch (split(polygon, {depth.line, sense})) {
        case Place::Left:
            return polygon;
        case Place::Right:
            return kNothing;
        case Place::Across:
            break;
    }
    nearer_.swap(left_);
    return nearer_;
}

/// Takes `hiding` away from every piece: what lies right of one of its lines stays.
void Splitting::subtract(const ConvexPolygon& hiding, const Box& box) {
    if (hiding.empty()) return;
    left_over_.clear();
    for (Piece& piece : pieces_) {
        if (box.apart_from(piece.box)) {
            left_over_.push_back(std::move(piece));
            continue;
        }
        inside_ = piece.polygon;
        const std::size_t before = left_over_.size();
        bool hidden = true;
        for (const Corner& corner : hiding) {
            const Place place = split(inside_, corner.line);
            hidden = place != Place::Right;
            if (!hidden) break;
            if (place == Place::Left) continue;
            left_over_.push_back({right_, box_of(right_)});
            inside_.swap(left_);
        }
        if (hidden) continue;
        left_over_.resize(before);  // nothing of it is hidden: it stays whole
        left_over_.push_back(std::move(piece));
    }
    pieces_.swap(left_over_);
}

/// The area of all pieces together, in square pixels.
///
/// Twice the area is the sum over all sides p q of the cross product p x q. Along a x + b y + c = 0 the side
/// is q - p = t (b, -a), and p x q = c t: a difference of two values that belong to an end and its line. An
/// end between two neighbouring pieces occurs with either sign and drops out. The ends left on a line are
/// paired in any way, for the sum is the same.
mpq_class Splitting::area_of_pieces() {
    ends_.clear();
    for (const auto& [polygon, box] : pieces_)
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            if (polygon[i].line.line->c == 0) continue;
            ends_.push_back({polygon[i].line.line, polygon[i].point, -1});
            ends_.push_back({polygon[i].line.line, polygon[(i + 1) % polygon.size()].point, 1});
        }
    std::ranges::sort(ends_, {}, [](const End& end) { return std::pair(end.line->index, end.point->index); });

    outline_.clear();
    for (std::size_t i = 0; i < ends_.size();) {
        const auto [line, point, unused] = ends_[i];
        int count = 0;
        for (; i < ends_.size() && ends_[i].line == line && ends_[i].point == point; ++i)
            count += ends_[i].count;
        for (; count < 0; ++count) starts_.push_back(point);
        for (; count > 0; --count) finishes_.push_back(point);
        if (i < ends_.size() && ends_[i].line == line) continue;
        for (std::size_t pair = 0; pair < starts_.size(); ++pair)
            outline_.push_back({starts_[pair], finishes_[pair]});
        starts_.clear();
        finishes_.clear();
    }
    return enclosed_area_(outline_, lines_.unit_bits());
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
    for (const RationalFace* face : rational_faces_)
        in_middle.push_back(mpq_class(face->a * pixel_.x + face->b * pixel_.y + face->c, face->unit).get_d());
    std::ranges::stable_sort(order, std::greater<>(),
                             [&](std::size_t i) { return std::isnan(in_middle[i]) ? 0 : in_middle[i]; });
    return order;
}

ExactAreas Splitting::areas() {
    const std::vector<std::size_t> order = likely_hiding();
    std::vector<mpq_class> areas;
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
        pieces_.clear();
        if (!polygons_[i].empty()) pieces_.push_back({polygons_[i], boxes_[i]});
        for (const std::size_t j : order) {
            if (pieces_.empty()) break;
            if (j != i && !boxes_[j].apart_from(boxes_[i])) subtract(where_nearer(j, i), boxes_[j]);
        }
        areas.push_back(area_of_pieces());
    }
    pieces_.clear();
    pieces_.push_back({square_, box_of(square_)});
    for (const std::size_t i : order) subtract(polygons_[i], boxes_[i]);
    areas.push_back(area_of_pieces());
    if (!add_up_to_one(areas)) throw std::logic_error("rational splitting: the areas do not add up to 1");

    ExactAreas result{std::move(areas), 0};
    result.background = std::move(result.areas.back());
    result.areas.pop_back();
    return result;
}

Splitting& splitting_of_this_thread() {
    thread_local Splitting splitting;
    return splitting;
}

}  // namespace

ExactAreas areas_by_rational_splitting(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness) {
    return splitting_of_this_thread().areas(pixel, faces, nearness);
}

ExactAreas areas_by_rational_splitting(PixelIndex pixel, std::span<const RationalFace* const> faces) {
    return splitting_of_this_thread().areas(pixel, faces);
}

}  // namespace keikan::oracle

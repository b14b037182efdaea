// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/published_clipper.hpp"

#include <algorithm>
#include <cmath>

#include "keikan/clip/ring_difference.hpp"

namespace keikan {

namespace {

enum class Region { Right, OnLine, Left };

/// With respect to the direction of travel from p to q; plain double. Clockwise on the screen with y down, so
/// the interior lies to the right and the right-hand side is where this product is positive.
double right_of(Point p, Point q, Point r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

Region region(Point p, Point q, Point r) {
    const double value = right_of(p, q, r);
    return value > 0 ? Region::Right : value < 0 ? Region::Left : Region::OnLine;
}

/// "On the edge", its ends excluded: those are cases of their own.
bool on_edge(Point p, Point q, Point r) {
    if (r == p || r == q || region(p, q, r) != Region::OnLine) return false;
    const double along = (r.x - p.x) * (q.x - p.x) + (r.y - p.y) * (q.y - p.y);
    const double length = (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
    return along > 0 && along < length;
}

const Point& next(const Ring& ring, std::size_t i) {
    return ring[(i + 1) % ring.size()];
}
const Point& previous(const Ring& ring, std::size_t i) {
    return ring[(i + ring.size() - 1) % ring.size()];
}

double area_of(const Ring& ring) {
    return ring.size() < 3 ? 0 : twice_signed_area(ring) / 2;
}

bool inside_or_on(const Ring& convex, Point p) {
    for (std::size_t j = 0; j < convex.size(); ++j)
        if (region(convex[j], next(convex, j), p) == Region::Left) return false;
    return true;
}

/// For a ring that may be concave: even-odd count of a ray to the right; its border counts as inside.
bool inside_or_on_any(const Ring& ring, Point p) {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i];
        const Point b = next(ring, i);
        if (a == p || on_edge(a, b, p)) return true;
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

/// Case (1): edges cross at a point that is a vertex of neither.
bool edges_cross(Point a, Point b, Point c, Point d) {
    return right_of(a, b, c) * right_of(a, b, d) < 0 && right_of(c, d, a) * right_of(c, d, b) < 0;
}

Point crossing_point(Point a, Point b, Point c, Point d) {
    const double s = right_of(c, d, a);
    const double t = right_of(c, d, b);
    const double share = s / (s - t);
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// Case (4) as printed: b lies strictly to the right of the two edges at a_i, that is, strictly inside A's
/// corner.
bool inside_corner(const Ring& a, std::size_t i, Point b) {
    const bool right_of_first = region(previous(a, i), a[i], b) == Region::Right;
    const bool right_of_second = region(a[i], next(a, i), b) == Region::Right;
    const bool convex = region(previous(a, i), a[i], next(a, i)) != Region::Left;
    return convex ? right_of_first && right_of_second : right_of_first || right_of_second;  // Fig. 4(d), (e)
}

/// Departure D1, for comparison: exactly one of A's directions points strictly outside B's wedge.
bool leaves_wedge(const Ring& b, std::size_t j, Point a) {
    return region(previous(b, j), b[j], a) == Region::Left || region(b[j], next(b, j), a) == Region::Left;
}

/// A stop on the way along one of the rings: a vertex, or an intersection.
struct Stop {
    bool intersection = false;
    std::size_t index = 0;  ///< of the vertex in its ring, or of the intersection
    Point point;
};

/// The vertices of a ring and the intersections on it, in order of travel. `on_vertex(x)` is the vertex that
/// intersection x takes the place of, `on_edge(x)` the edge that it lies inside; one of them is negative.
template <typename OnVertex, typename OnEdge>
std::vector<Stop> stops_along(const Ring& ring, std::span<const Contact> found, OnVertex on_vertex,
                              OnEdge on_edge) {
    std::vector<Stop> stops;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        bool taken = false;
        for (std::size_t x = 0; x < found.size(); ++x)
            if (on_vertex(found[x]) == static_cast<long>(i)) {
                stops.push_back({true, x, found[x].point});
                taken = true;
            }
        if (!taken) stops.push_back({false, i, ring[i]});
        const std::size_t first = stops.size();
        for (std::size_t x = 0; x < found.size(); ++x)
            if (on_edge(found[x]) == static_cast<long>(i)) stops.push_back({true, x, found[x].point});
        const Point origin = ring[i];
        const auto distance = [&](const Stop& s) {
            return std::hypot(s.point.x - origin.x, s.point.y - origin.y);
        };
        std::stable_sort(stops.begin() + static_cast<std::ptrdiff_t>(first), stops.end(),
                         [&](const Stop& p, const Stop& q) { return distance(p) < distance(q); });
    }
    return stops;
}

bool at_subject_vertex(const Contact& c) {
    return c.kind == ContactClass::SubjectVertex || c.kind == ContactClass::SharedVertex;
}
bool at_clip_vertex(const Contact& c) {
    return c.kind == ContactClass::ClipVertex || c.kind == ContactClass::SharedVertex;
}

}  // namespace

std::vector<Contact> PublishedClipper::intersections(const Ring& a, const Ring& b) const {
    std::vector<Contact> found;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const auto add = [&](ContactClass kind, std::size_t j, Point p) {
            found.push_back(
                {kind, Turn::Touch, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), p});
        };
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Point b_next = next(b, j);
            if (on_edge(b[j], b_next, a[i])) {  // case (2)
                const bool before_left = region(b[j], b_next, previous(a, i)) == Region::Left;
                const bool after_left = region(b[j], b_next, next(a, i)) == Region::Left;
                if (before_left != after_left) add(ContactClass::SubjectVertex, j, a[i]);
            }
            if (a[i] == b[j]) {  // case (4)
                const bool one_of_two =
                    reading_.shared_vertex == PublishedReading::SharedVertex::AsPrinted
                        ? inside_corner(a, i, previous(b, j)) != inside_corner(a, i, b_next)
                        : leaves_wedge(b, j, previous(a, i)) != leaves_wedge(b, j, next(a, i));
                if (one_of_two) add(ContactClass::SharedVertex, j, a[i]);
            }
        }
        const std::size_t first = found.size();
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Point a_next = next(a, i);
            if (edges_cross(a[i], a_next, b[j], next(b, j)))  // case (1)
                add(ContactClass::EdgeEdge, j, crossing_point(a[i], a_next, b[j], next(b, j)));
            if (on_edge(a[i], a_next, b[j]) &&  // case (3)
                region(a[i], a_next, previous(b, j)) != region(a[i], a_next, next(b, j)))
                add(ContactClass::ClipVertex, j, b[j]);
        }
        std::stable_sort(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
                         [&](const Contact& p, const Contact& q) {
                             return std::hypot(p.point.x - a[i].x, p.point.y - a[i].y) <
                                    std::hypot(q.point.x - a[i].x, q.point.y - a[i].y);
                         });
    }
    return found;
}

std::vector<Ring> PublishedClipper::search_vertices(const Ring& a, const Ring& b,
                                                    std::span<const Contact> found) {
    const std::vector<Stop> along_a = stops_along(
        a, found, [](const Contact& c) { return at_subject_vertex(c) ? static_cast<long>(c.subject) : -1L; },
        [](const Contact& c) { return at_subject_vertex(c) ? -1L : static_cast<long>(c.subject); });
    const std::vector<Stop> along_b = stops_along(
        b, found, [](const Contact& c) { return at_clip_vertex(c) ? static_cast<long>(c.clip) : -1L; },
        [](const Contact& c) { return at_clip_vertex(c) ? -1L : static_cast<long>(c.clip); });
    std::vector<std::size_t> on_a(found.size());
    std::vector<std::size_t> on_b(found.size());
    for (std::size_t s = 0; s < along_a.size(); ++s)
        if (along_a[s].intersection) on_a[along_a[s].index] = s;
    for (std::size_t s = 0; s < along_b.size(); ++s)
        if (along_b[s].intersection) on_b[along_b[s].index] = s;

    const std::size_t guard = 2 * (along_a.size() + along_b.size());
    std::vector<char> visited(along_a.size(), 0);
    std::vector<Ring> loops;
    for (std::size_t start = 0; start < along_a.size(); ++start) {  // (1), and (3) as its loop
        if (visited[start] != 0 || along_a[start].intersection) continue;
        if (reading_.start == PublishedReading::Start::OutsideVertex && inside_or_on(b, along_a[start].point))
            continue;
        Ring loop;
        std::size_t cp = start;
        std::size_t steps = 0;
        bool on_subject = true;  // states 1 and 4 go along A; states 2 and 3 along B against its direction
        do {                     // (2)
            const Stop& here = on_subject ? along_a[cp] : along_b[cp];
            loop.push_back(here.point);
            if (on_subject) {
                visited[cp] = 1;
                cp = (cp + 1) % along_a.size();
                if (along_a[cp].intersection) {  // odd-numbered: state 2
                    cp = on_b[along_a[cp].index];
                    on_subject = false;
                }
            } else {
                cp = (cp + along_b.size() - 1) % along_b.size();
                if (along_b[cp].intersection) {  // even-numbered: state 4
                    cp = on_a[along_b[cp].index];
                    on_subject = true;
                }
            }
            if (++steps > guard) {
                ++troubles_.did_not_close;
                break;
            }
        } while (!(on_subject && cp == start));
        loops.push_back(std::move(loop));
    }
    return loops;
}

/// The body of Fig. 3 for piece k; true if the loop over k ends here (its `break`).
bool PublishedClipper::clip_piece(std::vector<Piece>& pieces, std::size_t k, const Ring& b,
                                  std::vector<Piece>& appended) {
    Piece& piece = pieces[k];
    const std::vector<Contact> found = intersections(piece.ring, b);
    if (found.size() % 2 != 0) ++troubles_.odd_intersections;
    if (!found.empty()) {
        std::vector<Ring> loops = search_vertices(piece.ring, b, found);
        for (std::size_t l = 1; l < loops.size() && pieces.size() + appended.size() < kMostPieces; ++l)
            appended.push_back({std::move(loops[l]), piece.sign, 0});
        piece.ring = loops.empty() ? Ring{} : std::move(loops[0]);
        return false;
    }
    const auto in_b = [&](Point p) { return inside_or_on(b, p); };
    const auto in_piece = [&](Point p) { return inside_or_on_any(piece.ring, p); };
    if (std::all_of(piece.ring.begin(), piece.ring.end(), in_b)) {
        piece = {};
        return false;
    }
    if (std::all_of(b.begin(), b.end(), in_piece)) {
        if (reading_.hole == PublishedReading::Hole::Signed)
            appended.push_back({b, -piece.sign, 0});
        else
            piece.to_subtract += area_of(b);
        return reading_.hole == PublishedReading::Hole::Deferred;
    }
    return false;
}

void PublishedClipper::show_step(const Piece& piece, const Ring& b, std::size_t i, std::size_t j) const {
    const std::vector<Contact> found = intersections(piece.ring, b);
    observer_(
        {piece.ring, b, found, piece.sign, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)});
}

std::vector<double> PublishedClipper::visible_areas(std::span<const Ring> polygons) {
    pieces_.assign(polygons.size(), {});
    for (std::size_t i = 0; i < polygons.size(); ++i) pieces_[i].push_back({polygons[i], 1, 0});
    for (std::size_t j = 0; j < polygons.size(); ++j) {
        if (polygons[j].size() < 3) continue;
        for (std::size_t i = j + 1; i < polygons.size(); ++i) {
            std::vector<Piece> appended;
            for (std::size_t k = 0; k < pieces_[i].size(); ++k) {
                if (pieces_[i][k].ring.empty()) continue;
                if (observer_) show_step(pieces_[i][k], polygons[j], i, j);
                if (clip_piece(pieces_[i], k, polygons[j], appended)) break;
            }
            for (Piece& piece : appended) pieces_[i].push_back(std::move(piece));
        }
    }
    std::vector<double> areas(polygons.size(), 0);
    for (std::size_t i = 0; i < polygons.size(); ++i)
        for (const Piece& piece : pieces_[i])
            areas[i] += piece.sign * (area_of(piece.ring) - piece.to_subtract);
    return areas;
}

}  // namespace keikan

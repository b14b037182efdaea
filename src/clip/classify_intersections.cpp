// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/classify_intersections.hpp"

#include <utility>

#include "convex_outline.hpp"
#include "keikan/clip/orient2d.hpp"

namespace keikan {

namespace {

/// The exact side of p as seen from a to b, as a number: +1 towards the clipper's interior, 0 on the line.
std::int8_t side_of(Point a, Point b, Point p) {
    return static_cast<std::int8_t>(orient2d(a, b, p));
}

/// Of a point known to lie on the line through u and v: is it strictly between them?
bool strictly_between(Point u, Point p, Point v) {
    if (u.x != v.x) return (u.x < p.x && p.x < v.x) || (v.x < p.x && p.x < u.x);
    return (u.y < p.y && p.y < v.y) || (v.y < p.y && p.y < u.y);
}

/// Twice the area of a, b, p, measured from a: small where p is close to the line, whatever the origin.
double side_value(Point a, Point b, Point p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

Turn turn_of(bool comes_from_outside, bool goes_outside) {
    if (comes_from_outside == goes_outside) return Turn::Touch;
    return comes_from_outside ? Turn::Enter : Turn::Leave;
}

}  // namespace

std::span<const Contact> IntersectionClassifier::operator()(std::span<const Point> subject,
                                                            std::span<const Point> clip) {
    subject_ = subject;
    clip_ = clip;
    contacts_.clear();
    measure_sides();
    for (std::size_t i = 0; i < subject_.size(); ++i) {
        contact_at_vertex(i);
        contacts_inside_edge(i);
    }
    count_winding();
    return contacts_;
}

void IntersectionClassifier::measure_sides() {
    const std::size_t n = subject_.size();
    const std::size_t m = clip_.size();
    sides_.resize(n * m);
    locations_.resize(n);
    reaches_outside_ = false;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < m; ++j)
            sides_[i * m + j] = side_of(clip_[j], clip_[clip_after(j)], subject_[i]);
        locations_[i] = locate(i);
        reaches_outside_ |= locations_[i].place == Place::Outside;
    }
}

IntersectionClassifier::Location IntersectionClassifier::locate(std::size_t vertex) const {
    // A point of the closed clipper lies on at most two of its edges' lines, and on two only at their vertex.
    Location found;
    for (std::size_t j = 0; j < clip_.size(); ++j) {
        const std::int8_t s = side(vertex, j);
        if (s < 0) return {Place::Outside, 0};
        if (s > 0) continue;
        if (found.place == Place::Inside) {
            found = {Place::OnEdge, static_cast<std::uint32_t>(j)};
        } else {
            const bool wraps = found.clip == 0 && j + 1 == clip_.size();  // edges m-1 and 0 meet at vertex 0
            found = {Place::OnVertex, wraps ? 0U : static_cast<std::uint32_t>(j)};
        }
    }
    return found;
}

/// Whether the subject's vertex lies strictly outside the wedge at a vertex of the clipper. For a vertex next
/// to a contact there, this is whether that direction of the subject points strictly outside.
bool IntersectionClassifier::outside_wedge(std::size_t vertex, std::size_t clip_vertex) const {
    return side(vertex, clip_before(clip_vertex)) < 0 || side(vertex, clip_vertex) < 0;
}

void IntersectionClassifier::contact_at_vertex(std::size_t vertex) {
    const Location& here = locations_[vertex];
    const std::size_t from = before(vertex);
    const std::size_t to = after(vertex);
    const auto i = static_cast<std::uint32_t>(vertex);
    if (here.place == Place::OnEdge) {
        const Turn turn = turn_of(side(from, here.clip) < 0, side(to, here.clip) < 0);
        contacts_.push_back({ContactClass::SubjectVertex, turn, i, here.clip, subject_[vertex]});
    } else if (here.place == Place::OnVertex) {
        const Turn turn = turn_of(outside_wedge(from, here.clip), outside_wedge(to, here.clip));
        contacts_.push_back({ContactClass::SharedVertex, turn, i, here.clip, subject_[vertex]});
    }
}

void IntersectionClassifier::contacts_inside_edge(std::size_t vertex) {
    const std::size_t to = after(vertex);
    const bool from_outside = locations_[vertex].place == Place::Outside;
    const bool to_outside = locations_[to].place == Place::Outside;
    if (!from_outside && !to_outside) return;  // both ends in the closed clipper, so all of it
    for (std::size_t j = 0; j < clip_.size(); ++j) {
        const int s = side(vertex, j);
        const int t = side(to, j);
        if (s == 0 && t == 0) return contacts_along_edge(vertex, j);
        if (s <= 0 && t <= 0) return;  // strictly outside of one edge, its ends perhaps excepted
    }
    contacts_across(vertex);
}

/// The subject's edge runs along the line of clipper edge `edge`: contacts at the ends of that edge which lie
/// inside the subject's edge. Neighbouring clipper edges tell where along the line an end lies.
void IntersectionClassifier::contacts_along_edge(std::size_t vertex, std::size_t edge) {
    const std::size_t to = after(vertex);
    const auto add = [&](std::size_t clip_vertex, std::size_t neighbour_edge) {
        if (side(vertex, neighbour_edge) * side(to, neighbour_edge) >= 0) return;
        const Turn turn = turn_of(outside_wedge(vertex, clip_vertex), outside_wedge(to, clip_vertex));
        contacts_.push_back({ContactClass::ClipVertex, turn, static_cast<std::uint32_t>(vertex),
                             static_cast<std::uint32_t>(clip_vertex), clip_[clip_vertex]});
    };
    const std::size_t first = contacts_.size();
    add(edge, clip_before(edge));
    add(clip_after(edge), clip_after(edge));
    if (contacts_.size() == first + 2 && contacts_[first].turn == Turn::Leave)
        std::swap(contacts_[first], contacts_[first + 1]);
}

/// The subject's edge may cross the clipper's interior or touch one of its vertices.
void IntersectionClassifier::contacts_across(std::size_t vertex) {
    const std::size_t to = after(vertex);
    const Point u = subject_[vertex];
    const Point v = subject_[to];
    const std::size_t first = contacts_.size();
    const auto i = static_cast<std::uint32_t>(vertex);
    const std::int8_t side_of_first = side_of(u, v, clip_[0]);
    std::int8_t r = side_of_first;
    for (std::size_t j = 0; j < clip_.size(); ++j) {
        const std::size_t next = clip_after(j);
        const std::int8_t r_next = next == 0 ? side_of_first : side_of(u, v, clip_[next]);
        const auto k = static_cast<std::uint32_t>(j);
        if (r == 0 && strictly_between(u, clip_[j], v)) {
            const Turn turn = turn_of(outside_wedge(vertex, j), outside_wedge(to, j));
            contacts_.push_back({ContactClass::ClipVertex, turn, i, k, clip_[j]});
        } else if (r * r_next < 0 && side(vertex, j) * side(to, j) < 0) {
            const Turn turn = side(vertex, j) < 0 ? Turn::Enter : Turn::Leave;
            contacts_.push_back({ContactClass::EdgeEdge, turn, i, k, crossing(vertex, j)});
        }
        r = r_next;
    }
    if (contacts_.size() == first + 2 && contacts_[first].turn == Turn::Leave)
        std::swap(contacts_[first], contacts_[first + 1]);
}

/// Where the subject's edge crosses the clipper's edge, measured from the nearer end of the former.
Point IntersectionClassifier::crossing(std::size_t vertex, std::size_t edge) const {
    Point u = subject_[vertex];
    Point v = subject_[after(vertex)];
    double s = side_value(clip_[edge], clip_[clip_after(edge)], u);
    double t = side_value(clip_[edge], clip_[clip_after(edge)], v);
    s = s < 0 ? -s : s;
    t = t < 0 ? -t : t;
    if (t < s) {
        std::swap(u, v);
        std::swap(s, t);
    }
    const double share = s == 0 && t == 0 ? 0.5 : s / (s + t);  // both vanish only by underflow
    const Point p{u.x + share * (v.x - u.x), u.y + share * (v.y - u.y)};
    if (lattice_ == Lattice::Doubles) return p;
    return {clip::snap(p.x), clip::snap(p.y)};
}

/// Counts signed crossings of `subject` with the ray that runs along clipper edge 0, shifted outwards by less
/// than any distance that matters, from just before the edge's end to infinity. A vertex on the edge's line
/// counts as inside; an edge through the clipper's vertex counts as beyond the start.
void IntersectionClassifier::count_winding() {
    winding_ = 0;
    if (!reaches_outside_) return;
    const Point end = clip_[1];
    for (std::size_t i = 0; i < subject_.size(); ++i) {
        const bool from = side(i, 0) < 0;
        const bool to = side(after(i), 0) < 0;
        if (from == to) continue;
        const int position = static_cast<int>(side_of(subject_[i], subject_[after(i)], end));
        if (from && position >= 0) ++winding_;
        if (to && position <= 0) --winding_;
    }
}

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/classify_intersections.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "convex_outline.hpp"
#include "lattice_line.hpp"

namespace keikan {

namespace {

constexpr std::size_t kSetSize = 64;

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

/// The sets of a ring's vertices: all of them, and those whose successor is in a set.
struct Around {
    std::size_t n;
    std::uint64_t all() const { return ~std::uint64_t{0} >> (kSetSize - n); }
    std::uint64_t followed_by(std::uint64_t set) const { return (set >> 1 | set << (n - 1)) & all(); }
};

std::size_t first_of(std::uint64_t set) {
    return static_cast<std::size_t>(std::countr_zero(set));
}

}  // namespace

std::span<const Contact> IntersectionClassifier::operator()(std::span<const Point> subject,
                                                            std::span<const Point> clip) {
    subject_ = subject;
    clip_ = clip;
    if (lattice_ == Lattice::Pixel)
        measure_sides<clip::LatticeLine>(true);
    else
        measure_sides<clip::AnyLine>(true);
    return contacts();
}

IntersectionClassifier::Position IntersectionClassifier::position(std::span<const Point> subject,
                                                                  std::span<const Point> clip) {
    subject_ = subject;
    clip_ = clip;
    return lattice_ == Lattice::Pixel ? measure_sides<clip::LatticeLine>(false)
                                      : measure_sides<clip::AnyLine>(false);
}

/// Unless `all` is asked for, an edge that has the subject on its outer side is the last to be looked at.
template <class Line>
IntersectionClassifier::Position IntersectionClassifier::measure_sides(bool all) {
    const std::size_t n = subject_.size(), m = clip_.size();
    words_ = (n + kSetSize - 1) / kSetSize;
    if (outside_.size() < m * words_) outside_.resize(m * words_), on_.resize(m * words_);
    if (words_ > 1) [[unlikely]]
        return measure_many_sides<Line>();
    const Set every = Around{n}.all();
    Set any_outside = 0;
    for (std::size_t j = 0; j < m; ++j) {
        const clip::SideSets sides = Line(clip_[j], clip_[clip_after(j)]).sides(subject_.data(), n);
        if ((sides.outside | sides.on) == every && sides.outside != 0 && !all) return Position::Apart;
        outside_[j] = sides.outside;
        on_[j] = sides.on;
        any_outside |= sides.outside;
    }
    return any_outside == 0 ? Position::Within : Position::Open;
}

/// The same for rings of more than 64 vertices; it does not look for an edge that keeps them apart.
template <class Line>
IntersectionClassifier::Position IntersectionClassifier::measure_many_sides() {
    Set any_outside = 0;
    for (std::size_t j = 0; j < clip_.size(); ++j) {
        const Line line(clip_[j], clip_[clip_after(j)]);
        for (std::size_t word = 0; word < words_; ++word) {
            const std::size_t first = word * kSetSize, count = std::min(kSetSize, subject_.size() - first);
            const clip::SideSets sides = line.sides(subject_.data() + first, count);
            outside_[j * words_ + word] = sides.outside;
            on_[j * words_ + word] = sides.on;
            any_outside |= sides.outside;
        }
    }
    return any_outside == 0 ? Position::Within : Position::Open;
}

std::span<const Contact> IntersectionClassifier::contacts() {
    contacts_.clear();
    if (words_ == 1)
        find_contacts_by_sets();
    else
        find_contacts_one_by_one();
    return contacts_;
}

/// All edges of the subject at once, for each edge of the clipper.
void IntersectionClassifier::find_contacts_by_sets() {
    const Around around{subject_.size()};
    Set outside = 0;  // vertices strictly outside the clipper
    Set on = 0;       // on some edge's line
    Set missing = 0;  // edges with both ends outside the same edge of the clipper, or on its line
    Set along = 0;    // edges that run along an edge's line
    Set crossing = 0, crossing_more = 0;  // edges across the line of an edge, of more than one edge
    for (std::size_t j = 0; j < clip_.size(); ++j) {
        const Set not_inside = outside_[j] | on_[j];
        const Set across = outside_[j] ^ around.followed_by(outside_[j]);
        outside |= outside_[j];
        on |= on_[j];
        missing |= not_inside & around.followed_by(not_inside);
        along |= on_[j] & around.followed_by(on_[j]);
        crossing_more |= crossing & across;
        crossing |= across;
    }
    on &= ~outside;
    along &= outside | around.followed_by(outside);
    crossing &= ~missing;  // so one end is outside, the other is inside of every edge that the first is not
    for (Set some = on | along | crossing; some != 0; some &= some - 1) {
        const std::size_t i = first_of(some);
        const Set here = some & (~some + 1);
        if ((on & here) != 0) contact_at_vertex(i, locate(i));
        if ((along & here) != 0) {
            const Set both = here | Set{1} << after(i);
            std::size_t j = 0;
            while ((on_[j] & both) != both) ++j;
            contacts_along_edge(i, j);
        } else if ((crossing & here) == 0) {
            continue;
        } else if ((crossing_more & here) != 0) {
            contacts_across(i);
        } else {
            // The line of one edge is crossed; of all others both ends are inside, or one inside and one on
            // it. So the crossing is strictly inside of all others: it lies inside that edge.
            std::size_t j = 0;
            while (((outside_[j] ^ around.followed_by(outside_[j])) & here) == 0) ++j;
            contact_crossing(i, j);
        }
    }
}

/// The same for rings of more than 64 vertices.
void IntersectionClassifier::find_contacts_one_by_one() {
    for (std::size_t i = 0; i < subject_.size(); ++i) {
        contact_at_vertex(i, locate(i));
        contacts_inside_edge(i);
    }
}

IntersectionClassifier::Location IntersectionClassifier::locate(std::size_t vertex) const {
    // A point of the closed clipper lies on at most two of its edges' lines, and on two only at their vertex.
    Location found;
    for (std::size_t j = 0; j < clip_.size(); ++j) {
        const int s = side(vertex, j);
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

void IntersectionClassifier::contact_at_vertex(std::size_t vertex, Location here) {
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
    bool any_outside = false;
    for (std::size_t j = 0; j < clip_.size(); ++j) {
        const int s = side(vertex, j);
        const int t = side(to, j);
        if (s == 0 && t == 0) return contacts_along_edge(vertex, j);
        if (s <= 0 && t <= 0) return;  // strictly outside of one edge, its ends perhaps excepted
        any_outside |= s < 0 || t < 0;
    }
    if (any_outside) contacts_across(vertex);  // else both ends are in the closed clipper, so all of it is
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

void IntersectionClassifier::contacts_across(std::size_t vertex) {
    if (lattice_ == Lattice::Pixel)
        contacts_across<clip::LatticeLine>(vertex);
    else
        contacts_across<clip::AnyLine>(vertex);
}

/// The subject's edge may cross the clipper's interior or touch one of its vertices.
template <class Line>
void IntersectionClassifier::contacts_across(std::size_t vertex) {
    const std::size_t to = after(vertex);
    const Point u = subject_[vertex], v = subject_[to];
    const Line line(u, v);
    const std::size_t first = contacts_.size();
    const int side_of_first = line.side(clip_[0]);
    int r = side_of_first;
    for (std::size_t j = 0; j < clip_.size(); ++j) {
        const std::size_t next = clip_after(j);
        const int r_next = next == 0 ? side_of_first : line.side(clip_[next]);
        if (r == 0 && strictly_between(u, clip_[j], v)) {
            const Turn turn = turn_of(outside_wedge(vertex, j), outside_wedge(to, j));
            contacts_.push_back({ContactClass::ClipVertex, turn, static_cast<std::uint32_t>(vertex),
                                 static_cast<std::uint32_t>(j), clip_[j]});
        } else if (r * r_next < 0 && side(vertex, j) * side(to, j) < 0) {
            contact_crossing(vertex, j);
        }
        r = r_next;
    }
    if (contacts_.size() == first + 2 && contacts_[first].turn == Turn::Leave)
        std::swap(contacts_[first], contacts_[first + 1]);
}

void IntersectionClassifier::contact_crossing(std::size_t vertex, std::size_t edge) {
    const Turn turn = side(vertex, edge) < 0 ? Turn::Enter : Turn::Leave;
    contacts_.push_back({ContactClass::EdgeEdge, turn, static_cast<std::uint32_t>(vertex),
                         static_cast<std::uint32_t>(edge), crossing(vertex, edge)});
}

/// Where the subject's edge crosses the clipper's edge, measured from the nearer end of the former.
Point IntersectionClassifier::crossing(std::size_t vertex, std::size_t edge) const {
    const Point end[2] = {subject_[vertex], subject_[after(vertex)]};
    const Point a = clip_[edge], b = clip_[clip_after(edge)];
    const double distance[2] = {std::abs(side_value(a, b, end[0])), std::abs(side_value(a, b, end[1]))};
    const std::size_t nearer = distance[1] < distance[0] ? 1 : 0;
    const Point u = end[nearer], v = end[1 - nearer];
    const double sum = distance[0] + distance[1];
    const double share = sum == 0 ? 0.5 : distance[nearer] / sum;  // both vanish only by underflow
    const Point p{u.x + share * (v.x - u.x), u.y + share * (v.y - u.y)};
    if (lattice_ == Lattice::Doubles) return p;
    return {clip::snap(p.x), clip::snap(p.y)};
}

int IntersectionClassifier::winding_outside_first_edge() const {
    return lattice_ == Lattice::Pixel ? count_winding<clip::LatticeLine>() : count_winding<clip::AnyLine>();
}

/// Counts signed crossings of `subject` with the ray that runs along clipper edge 0, shifted outwards by less
/// than any distance that matters, from just before the edge's end to infinity. A vertex on the edge's line
/// counts as inside; an edge through the clipper's vertex counts as beyond the start.
template <class Line>
int IntersectionClassifier::count_winding() const {
    int winding = 0;
    const Point end = clip_[1];
    const std::size_t n = subject_.size();
    for (std::size_t first = 0; first < n; first += kSetSize) {
        const std::size_t count = std::min(kSetSize, n - first);
        const Set outside = outside_[first / kSetSize];
        const Set next_outside = outside >> 1 | static_cast<Set>(side(after(first + count - 1), 0) < 0)
                                                    << (count - 1);
        for (Set passes = outside ^ next_outside; passes != 0; passes &= passes - 1) {
            const std::size_t i = first + first_of(passes);
            const bool from = side(i, 0) < 0;
            const int position = Line(subject_[i], subject_[after(i)]).side(end);
            if (from && position >= 0) ++winding;
            if (!from && position <= 0) --winding;
        }
    }
    return winding;
}

}  // namespace keikan

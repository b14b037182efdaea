// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/exact_intersections.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <optional>

namespace keikan::oracle {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = Kernel::Point_2;
using Segment = Kernel::Segment_2;

/// A point of the subject's boundary at which its parts are divided.
struct Found {
    Contact contact;
    ExactPoint point;
};

std::vector<ExactPoint> exact_points(std::span<const Point> ring) {
    std::vector<ExactPoint> points;
    points.reserve(ring.size());
    for (const Point p : ring) points.emplace_back(p.x, p.y);
    return points;
}

bool boxes_meet(Point a, Point b, Point c, Point d) {
    return std::min(a.x, b.x) <= std::max(c.x, d.x) && std::min(c.x, d.x) <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= std::max(c.y, d.y) && std::min(c.y, d.y) <= std::max(a.y, b.y);
}

/// The one point in which two segments meet; nothing where they miss each other or share a stretch.
std::optional<ExactPoint> meeting_point(const Segment& s, const Segment& t) {
    const auto meeting = CGAL::intersection(s, t);
    if (!meeting) return std::nullopt;
    if (const ExactPoint* point = boost::get<ExactPoint>(&*meeting)) return *point;
    return std::nullopt;
}

/// Everything on the boundary of one clipper, as seen by one subject.
class Meeting {
  public:
    Meeting(std::span<const Point> subject, std::span<const Point> clip)
        : a_(subject), b_(clip), exact_a_(exact_points(subject)), exact_b_(exact_points(clip)) {}

    std::vector<Contact> contacts() {
        std::vector<Found> found;
        for (std::size_t i = 0; i < a_.size(); ++i) {
            find_at_vertex(i, found);
            find_inside_edge(i, found);
        }
        set_turns(found);
        std::vector<Contact> answer;
        for (const Found& f : found) answer.push_back(f.contact);
        return answer;
    }

  private:
    std::size_t after(std::size_t i) const { return (i + 1) % a_.size(); }
    std::size_t clip_after(std::size_t j) const { return (j + 1) % b_.size(); }

    static Found make(ContactClass kind, std::size_t i, std::size_t j, const ExactPoint& p) {
        return {{kind, Turn::Touch, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), {}}, p};
    }

    void find_at_vertex(std::size_t i, std::vector<Found>& found) const {
        for (std::size_t j = 0; j < b_.size(); ++j)
            if (a_[i] == b_[j]) {
                found.push_back(make(ContactClass::SharedVertex, i, j, exact_a_[i]));
                return;
            }
        for (std::size_t j = 0; j < b_.size(); ++j) {
            const std::size_t k = clip_after(j);
            if (!boxes_meet(a_[i], a_[i], b_[j], b_[k])) continue;
            if (Segment(exact_b_[j], exact_b_[k]).has_on(exact_a_[i])) {
                found.push_back(make(ContactClass::SubjectVertex, i, j, exact_a_[i]));
                return;
            }
        }
    }

    void find_inside_edge(std::size_t i, std::vector<Found>& found) const {
        const std::size_t to = after(i);
        const std::size_t first = found.size();
        const Segment edge(exact_a_[i], exact_a_[to]);
        for (std::size_t j = 0; j < b_.size(); ++j) {
            const std::size_t k = clip_after(j);
            if (boxes_meet(a_[i], a_[to], b_[j], b_[j]) && b_[j] != a_[i] && b_[j] != a_[to] &&
                edge.has_on(exact_b_[j]))
                found.push_back(make(ContactClass::ClipVertex, i, j, exact_b_[j]));
            if (!boxes_meet(a_[i], a_[to], b_[j], b_[k])) continue;
            const std::optional<ExactPoint> p = meeting_point(edge, Segment(exact_b_[j], exact_b_[k]));
            if (!p || *p == exact_a_[i] || *p == exact_a_[to] || *p == exact_b_[j] || *p == exact_b_[k])
                continue;
            found.push_back(make(ContactClass::EdgeEdge, i, j, *p));
        }
        const CGAL::Comparison_result forwards = CGAL::compare_xy(exact_a_[i], exact_a_[to]);
        std::sort(
            found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
            [&](const Found& p, const Found& q) { return CGAL::compare_xy(p.point, q.point) == forwards; });
    }

    /// Whether the part of the boundary between two neighbouring points of one edge lies outside.
    bool part_is_outside(const ExactPoint& p, const ExactPoint& q) const {
        return CGAL::bounded_side_2(exact_b_.begin(), exact_b_.end(), CGAL::midpoint(p, q), Kernel()) ==
               CGAL::ON_UNBOUNDED_SIDE;
    }

    /// The parts before and after each contact reach to its neighbours on the same edge, or to the edge's
    /// ends.
    void set_turns(std::vector<Found>& found) const {
        const auto at_vertex = [](const Found& f) {
            return f.contact.kind == ContactClass::SubjectVertex ||
                   f.contact.kind == ContactClass::SharedVertex;
        };
        for (std::size_t f = 0; f < found.size(); ++f) {
            Found& here = found[f];
            const std::size_t i = here.contact.subject;
            const std::size_t edge_before = at_vertex(here) ? (i + a_.size() - 1) % a_.size() : i;
            ExactPoint from = exact_a_[edge_before];
            ExactPoint to = exact_a_[after(i)];
            for (std::size_t g = 0; g < found.size(); ++g) {
                if (at_vertex(found[g]) || g == f) continue;
                // Contacts inside an edge stand in order: the last before, the first behind.
                const bool on_edge_before =
                    found[g].contact.subject == edge_before && (at_vertex(here) || g < f);
                const bool on_edge_after = found[g].contact.subject == i && (at_vertex(here) || g > f);
                if (on_edge_before && (!at_vertex(here) || edge_before != i)) from = found[g].point;
                if (on_edge_after && to == exact_a_[after(i)]) to = found[g].point;
            }
            const bool comes_from_outside = part_is_outside(from, here.point);
            const bool goes_outside = part_is_outside(here.point, to);
            if (comes_from_outside != goes_outside)
                here.contact.turn = comes_from_outside ? Turn::Enter : Turn::Leave;
            here.contact.point = {CGAL::to_double(here.point.x()), CGAL::to_double(here.point.y())};
        }
    }

    std::span<const Point> a_;
    std::span<const Point> b_;
    std::vector<ExactPoint> exact_a_;
    std::vector<ExactPoint> exact_b_;
};

}  // namespace

std::vector<Contact> exact_intersections(std::span<const Point> subject, std::span<const Point> clip) {
    return Meeting(subject, clip).contacts();
}

}  // namespace keikan::oracle

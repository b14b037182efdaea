// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/lattice_intersections.hpp"

#include <algorithm>
#include <climits>
#include <cmath>

#include "exact_double.hpp"

namespace keikan::oracle {
namespace {

/// Coordinates below 2^60: differences below 2^61, products of two below 2^122, their sums below 2^123.
constexpr int kLongest = 60;

/// Of a sum of two products of doubles that carry relative errors of 2^-50 each: what is larger than this
/// share of the sizes summed has the right sign.
constexpr double kCertain = 0x1p-47;

int sign_of(Int128 value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// The sign of su + middle * (sv - su), where `middle` is half the sum of two fractions.
int sign_at_middle(Int128 su, Int128 sv, Int128 n1, Int128 d1, Int128 n2, Int128 d2) {
    using Wide = WideInteger<2>;
    const auto whole = Wide(d1) * Wide(d2) * Wide(2 * su);
    const auto way = (Wide(n1) * Wide(d2) + Wide(n2) * Wide(d1)) * Wide(sv - su);
    return (whole + way).sign();
}

}  // namespace

bool LatticeIntersections::read(std::span<const Point> subject, std::span<const Point> clip) {
    int unit = INT_MAX;
    for (const auto& ring : {subject, clip})
        for (const Point p : ring)
            for (const double value : {p.x, p.y})
                if (value != 0) unit = std::min(unit, binary_fraction(value).exponent);
    const auto read_ring = [unit](std::span<const Point> ring, std::vector<LatticePoint>& out) {
        out.clear();
        for (const Point p : ring) {
            const auto x = whole_number(p.x, -unit, kLongest), y = whole_number(p.y, -unit, kLongest);
            if (!x || !y) return false;
            out.push_back({static_cast<std::int64_t>(*x), static_cast<std::int64_t>(*y)});
        }
        return true;
    };
    if (unit == INT_MAX) return false;
    return read_ring(subject, a_) && read_ring(clip, b_);
}

Int128 LatticeIntersections::cross(LatticePoint from, LatticePoint to, LatticePoint p) {
    return static_cast<Int128>(to.x - from.x) * (p.y - from.y) -
           static_cast<Int128>(to.y - from.y) * (p.x - from.x);
}

LatticeIntersections::Place LatticeIntersections::place(Int128 numerator, Int128 denominator) {
    if (denominator < 0) numerator = -numerator, denominator = -denominator;
    return {numerator, denominator, static_cast<double>(numerator) / static_cast<double>(denominator)};
}

bool LatticeIntersections::before(const Place& p, const Place& q) {
    const double ahead = q.rough - p.rough;
    if (std::abs(ahead) > kCertain * (p.rough + q.rough)) return ahead > 0;
    using Wide = WideInteger<2>;
    return (Wide(p.numerator) * Wide(q.denominator) - Wide(q.numerator) * Wide(p.denominator)).negative();
}

/// What lies strictly inside the edge that starts at subject vertex i: vertices of the clipper, and crossings
/// strictly inside both edges.
void LatticeIntersections::find_inside_edge(std::size_t i) {
    on_edge_.clear();
    const std::size_t to = (i + 1) % a_.size(), m = b_.size();
    const LatticePoint u = a_[i], v = a_[to];
    const Int128 dx = v.x - u.x, dy = v.y - u.y;
    Int128 here = cross(u, v, b_[0]);
    const Int128 at_first = here;
    for (std::size_t j = 0; j < m; ++j) {
        const Int128 next = j + 1 < m ? cross(u, v, b_[j + 1]) : at_first;
        const auto clip = static_cast<std::uint32_t>(j);
        const Int128 su = side(i, j), sv = side(to, j);
        if (here == 0) {
            const Int128 length = dx * dx + dy * dy;
            const Int128 along = dx * (b_[j].x - u.x) + dy * (b_[j].y - u.y);
            if (along > 0 && along < length)
                on_edge_.push_back({place(along, length), ContactClass::ClipVertex, clip});
        }
        if (sign_of(here) * sign_of(next) < 0 && sign_of(su) * sign_of(sv) < 0)
            on_edge_.push_back({place(su, su - sv), ContactClass::EdgeEdge, clip});
        here = next;
    }
    std::sort(on_edge_.begin(), on_edge_.end(),
              [](const Found& p, const Found& q) { return before(p.place, q.place); });
}

/// Whether the middle of a part of subject edge i lies outside the closed clipper.
bool LatticeIntersections::part_is_outside(std::size_t i, const Place& from, const Place& to) const {
    const std::size_t end = (i + 1) % a_.size();
    const double middle = 0.5 * (from.rough + to.rough);
    for (std::size_t j = 0; j < b_.size(); ++j) {
        const Int128 su = side(i, j), sv = side(end, j);
        if (su >= 0 && sv >= 0) continue;
        if (su <= 0 && sv <= 0) return true;  // the middle is neither end
        const double rough_su = static_cast<double>(su), rough_sv = static_cast<double>(sv);
        const double value = rough_su + middle * (rough_sv - rough_su);
        if (std::abs(value) > kCertain * (std::abs(rough_su) + std::abs(rough_sv))) {
            if (value < 0) return true;
        } else if (sign_at_middle(su, sv, from.numerator, from.denominator, to.numerator, to.denominator) <
                   0) {
            return true;
        }
    }
    return false;
}

std::optional<Contact> LatticeIntersections::contact_at_vertex(std::size_t i) const {
    const auto found = [&](ContactClass kind, std::size_t j) {
        return Contact{kind, Turn::Touch, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
                       subject_[i]};
    };
    for (std::size_t j = 0; j < b_.size(); ++j)
        if (a_[i] == b_[j]) return found(ContactClass::SharedVertex, j);
    for (std::size_t j = 0; j < b_.size(); ++j) {
        if (side(i, j) != 0) continue;
        const LatticePoint p = a_[i], from = b_[j], to = b_[(j + 1) % b_.size()];
        // On the line; on the edge if the ends lie on opposite sides of it.
        const Int128 ahead = static_cast<Int128>(to.x - p.x) * (from.x - p.x) +
                             static_cast<Int128>(to.y - p.y) * (from.y - p.y);
        if (ahead < 0) return found(ContactClass::SubjectVertex, j);
    }
    return std::nullopt;
}

Point LatticeIntersections::point_on_edge(std::size_t i, const Place& place) const {
    const Point u = subject_[i], v = subject_[(i + 1) % subject_.size()];
    return {u.x + place.rough * (v.x - u.x), u.y + place.rough * (v.y - u.y)};
}

std::optional<std::span<const Contact>> LatticeIntersections::operator()(std::span<const Point> subject,
                                                                         std::span<const Point> clip) {
    subject_ = subject, clip_ = clip;
    if (!read(subject, clip)) return std::nullopt;
    const std::size_t n = a_.size(), m = b_.size();
    sides_.resize(n * m);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < m; ++j) sides_[i * m + j] = cross(b_[j], b_[(j + 1) % m], a_[i]);

    constexpr Place kStart{0, 1, 0}, kEnd{1, 1, 1};
    const auto turn_between = [](bool comes_from_outside, bool goes_outside) {
        if (comes_from_outside == goes_outside) return Turn::Touch;
        return comes_from_outside ? Turn::Enter : Turn::Leave;
    };
    contacts_.clear();
    find_inside_edge(n - 1);
    bool outside = part_is_outside(n - 1, on_edge_.empty() ? kStart : on_edge_.back().place, kEnd);
    for (std::size_t i = 0; i < n; ++i) {
        find_inside_edge(i);
        const auto end_of_part = [&](std::size_t f) {
            return f < on_edge_.size() ? on_edge_[f].place : kEnd;
        };
        const bool starts_outside = part_is_outside(i, kStart, end_of_part(0));
        if (std::optional<Contact> contact = contact_at_vertex(i)) {
            contact->turn = turn_between(outside, starts_outside);
            contacts_.push_back(*contact);
        }
        outside = starts_outside;
        for (std::size_t f = 0; f < on_edge_.size(); ++f) {
            const Found& here = on_edge_[f];
            const bool goes_outside = part_is_outside(i, here.place, end_of_part(f + 1));
            const Point p =
                here.kind == ContactClass::ClipVertex ? clip_[here.clip] : point_on_edge(i, here.place);
            contacts_.push_back({here.kind, turn_between(outside, goes_outside),
                                 static_cast<std::uint32_t>(i), here.clip, p});
            outside = goes_outside;
        }
    }
    return contacts_;
}

}  // namespace keikan::oracle

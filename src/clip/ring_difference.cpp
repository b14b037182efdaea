// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/ring_difference.hpp"

#include <algorithm>
#include <cmath>

namespace keikan {

void SignedRings::clear() {
    pieces_.clear();
    open_ = end_ = 0;
}

void SignedRings::add(std::span<const Point> ring, int sign) {
    for (const Point p : ring) add_point(p);
    close_ring(sign);
}

void SignedRings::append(std::span<const Point> ring, int sign) {
    if (points_.size() - end_ < ring.size()) make_room(ring.size());
    std::copy(ring.begin(), ring.end(), points_.begin() + end_);
    open_ = end_ += static_cast<std::uint32_t>(ring.size());
    pieces_.push_back({sign, end_ - static_cast<std::uint32_t>(ring.size()), end_});
}

void SignedRings::close_ring(int sign) {
    while (end_ > open_ + 1 && points_[end_ - 1] == points_[open_]) --end_;
    if (end_ - open_ < 3) {
        end_ = open_;
        return;
    }
    pieces_.push_back({sign, open_, end_});
    open_ = end_;
}

void SignedRings::make_room(std::size_t more) {
    points_.resize(2 * (end_ + more));
}

double twice_signed_area(std::span<const Point> ring) {
    double sum = 0;
    const Point o = ring[0];
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        sum += (ring[i].x - o.x) * (ring[i + 1].y - o.y) - (ring[i].y - o.y) * (ring[i + 1].x - o.x);
    return sum;
}

void RingDifference::operator()(std::span<const Point> subject, int sign, std::span<const Point> clip,
                                SignedRings& rest) {
    position(subject, clip);
    append_rest(sign, rest);
}

IntersectionClassifier::Position RingDifference::position(std::span<const Point> subject,
                                                          std::span<const Point> clip) {
    subject_ = subject;
    clip_ = clip;
    return position_ = classify_.position(subject, clip);
}

void RingDifference::append_rest(int sign, SignedRings& rest) {
    if (position_ == Position::Within) return;
    if (position_ == Position::Apart) return rest.append(subject_, sign);

    contacts_ = classify_.contacts();
    find_turns();
    int whole_copies = classify_.winding_outside_first_edge();  // of the clipper, against its direction
    if (turns_.empty())
        rest.append(subject_, sign);
    else if (turns_.size() == 2)
        whole_copies = join_two(whole_copies);
    else
        whole_copies = join_all(whole_copies);
    follow_rings(sign, rest);
    for (int i = 0; i < std::abs(whole_copies); ++i) rest.append(clip_, whole_copies > 0 ? -sign : sign);
}

std::span<const Contact> RingDifference::contacts() {
    if (position_ != Position::Open) contacts_ = classify_(subject_, clip_);
    return contacts_;
}

void RingDifference::find_turns() {
    turns_.clear();
    const auto m = static_cast<std::uint32_t>(clip_.size());
    for (std::uint32_t c = 0; c < contacts_.size(); ++c) {
        const Contact& contact = contacts_[c];
        if (contact.turn == Turn::Touch) continue;
        TurnOnClip& turn = turns_.emplace_back();
        turn.contact = c;
        turn.rank = (contact.clip == 0 ? m : contact.clip) - 1;
        turn.leave = contact.turn == Turn::Leave;
    }
}

/// Distance from the start of the clipper's edge; a vertex is before everything on the edge.
double RingDifference::along_edge(const TurnOnClip& turn) const {
    const Contact& contact = contacts_[turn.contact];
    if (contact.kind == ContactClass::ClipVertex || contact.kind == ContactClass::SharedVertex) return -1;
    const Point a = clip_[contact.clip];
    const Point b = clip_[contact.clip + 1 == clip_.size() ? 0 : contact.clip + 1];
    const bool along_x = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    return along_x ? std::abs(contact.point.x - a.x) : std::abs(contact.point.y - a.y);
}

/// join_all for one Leave and one Enter: there is nothing to match.
int RingDifference::join_two(int walks) {
    const bool leave_first = turns_[0].leave;
    TurnOnClip& leave = turns_[leave_first ? 0 : 1];
    TurnOnClip& enter = turns_[leave_first ? 1 : 0];
    bool from_leave = leave.rank < enter.rank;  // does the clipper's outline meet the Leave first?
    if (leave.rank == enter.rank) {
        const double along_leave = along_edge(leave), along_enter = along_edge(enter);
        from_leave = along_leave < along_enter || (along_leave == along_enter && leave_first);
        if (walks == (from_leave ? 1 : 0)) from_leave = !from_leave;  // rounding has confused their order
    }
    const auto m = static_cast<std::uint32_t>(clip_.size());
    enter.exit = leave_first ? 0 : 1;
    enter.walk = enter.rank + (from_leave ? 0 : m) - leave.rank;
    const int whole_copies = walks - (from_leave ? 0 : 1);
    if (whole_copies != 0) ++folds_;
    return whole_copies;
}

/// Joins each Enter with a Leave, given the walks next to the end of edge 0. Returns the whole copies of the
/// clipper.
int RingDifference::join_all(int walks) {
    sort_stations();
    const int whole_copies = order_by_walks(walks);
    match_walks();
    return whole_copies;
}

void RingDifference::sort_stations() {
    stations_.clear();
    for (std::uint32_t t = 0; t < turns_.size(); ++t)
        stations_.push_back({t, turns_[t].rank, along_edge(turns_[t]), turns_[t].leave});
    // A handful of stations: insertion keeps those at one place in the subject's order.
    for (std::size_t i = 1; i < stations_.size(); ++i) {
        const Station moving = stations_[i];
        std::size_t at = i;
        for (; at > 0; --at) {
            const Station& left = stations_[at - 1];
            if (left.rank < moving.rank || (left.rank == moving.rank && left.along <= moving.along)) break;
            stations_[at] = left;
        }
        stations_[at] = moving;
    }
}

/// Puts stations of one edge whose order rounding has confused into the order in which every stretch is
/// walked 0 or 1 times (points of one line: the sum of the walks is the same), and turns the list so that the
/// stretch before its first station has the fewest walks. Returns that number, the whole copies of the
/// clipper.
int RingDifference::order_by_walks(int walks) {
    int fewest = walks;
    int most = walks;
    std::size_t start = 0;
    for (std::size_t s = 0; s < stations_.size(); ++s) {
        const auto leads_out = [&](const Station& station) { return walks == (station.leave ? 1 : 0); };
        if (leads_out(stations_[s])) {
            std::size_t other = s + 1;
            while (other < stations_.size() && stations_[other].rank == stations_[s].rank &&
                   stations_[other].leave == stations_[s].leave)
                ++other;
            if (other < stations_.size() && stations_[other].rank == stations_[s].rank)
                std::rotate(stations_.begin() + static_cast<std::ptrdiff_t>(s),
                            stations_.begin() + static_cast<std::ptrdiff_t>(other),
                            stations_.begin() + static_cast<std::ptrdiff_t>(other) + 1);
        }
        walks += stations_[s].leave ? 1 : -1;
        most = std::max(most, walks);
        if (walks < fewest) {
            fewest = walks;
            start = s + 1;
        }
    }
    if (fewest != 0 || most > 1) ++folds_;
    const auto m = static_cast<std::uint32_t>(clip_.size());
    for (std::size_t s = 0; s < start; ++s) stations_[s].rank += m;
    std::rotate(stations_.begin(), stations_.begin() + static_cast<std::ptrdiff_t>(start), stations_.end());
    return fewest;
}

/// Like brackets: every stretch between an Enter and its Leave is walked back once.
void RingDifference::match_walks() {
    open_leaves_.clear();
    for (const Station& station : stations_) {
        if (station.leave) {
            open_leaves_.push_back(station);
            continue;
        }
        turns_[station.turn].exit = open_leaves_.back().turn;
        turns_[station.turn].walk = station.rank - open_leaves_.back().rank;
        open_leaves_.pop_back();
    }
}

void RingDifference::follow_rings(int sign, SignedRings& rest) {
    for (std::size_t t = 0; t < turns_.size(); ++t) {
        if (!turns_[t].leave || turns_[t].followed) continue;
        for (std::size_t leave = t; !turns_[leave].followed;) {
            turns_[leave].followed = true;
            const std::size_t enter = leave + 1 == turns_.size() ? 0 : leave + 1;
            follow_outside(leave, rest);
            walk_back(turns_[enter], rest);
            leave = turns_[enter].exit;
        }
        rest.close_ring(sign);
    }
}

/// The subject from a Leave to the Enter that follows it, both included.
void RingDifference::follow_outside(std::size_t leave_turn, SignedRings& rest) {
    const std::size_t n = subject_.size();
    const bool wraps = leave_turn + 1 == turns_.size();
    const Contact& leave = contacts_[turns_[leave_turn].contact];
    const Contact& enter = contacts_[turns_[wraps ? 0 : leave_turn + 1].contact];
    const bool enters_at_vertex =
        enter.kind == ContactClass::SubjectVertex || enter.kind == ContactClass::SharedVertex;
    const std::size_t last = enter.subject + (wraps ? n : 0) - (enters_at_vertex ? 1 : 0);
    rest.add_point(leave.point);
    for (std::size_t v = leave.subject + 1; v <= last; ++v) rest.add_point(subject_[v >= n ? v - n : v]);
    rest.add_point(enter.point);
}

/// The clipper's vertices from an Enter back to the Leave that it is joined with, ends excluded.
void RingDifference::walk_back(const TurnOnClip& enter, SignedRings& rest) {
    std::size_t vertex = contacts_[enter.contact].clip;
    for (std::uint32_t i = 0; i < enter.walk; ++i) {
        rest.add_point(clip_[vertex]);
        vertex = (vertex == 0 ? clip_.size() : vertex) - 1;
    }
}

}  // namespace keikan

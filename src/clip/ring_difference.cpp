// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/ring_difference.hpp"

#include <algorithm>
#include <cmath>

namespace keikan {

void SignedRings::clear() {
    points_.clear();
    pieces_.clear();
    open_ = 0;
}

void SignedRings::add(std::span<const Point> ring, int sign) {
    for (const Point p : ring) add_point(p);
    close_ring(sign);
}

void SignedRings::add_point(Point p) {
    if (points_.size() > open_ && points_.back() == p) return;
    points_.push_back(p);
}

void SignedRings::close_ring(int sign) {
    while (points_.size() > open_ + 1 && points_.back() == points_[open_]) points_.pop_back();
    const auto end = static_cast<std::uint32_t>(points_.size());
    if (end - open_ < 3) {
        points_.resize(open_);
        return;
    }
    pieces_.push_back({sign, open_, end});
    open_ = end;
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
    subject_ = subject;
    clip_ = clip;
    contacts_ = classify_(subject, clip);
    turns_.clear();
    for (std::uint32_t c = 0; c < contacts_.size(); ++c)
        if (contacts_[c].turn != Turn::Touch) turns_.push_back(c);

    int whole_copies = 0;  // of the clipper, walked against its direction
    if (turns_.empty()) {
        if (!classify_.reaches_outside()) return;
        rest.add(subject, sign);
        whole_copies = classify_.winding_outside_first_edge();
    } else {
        sort_stations();
        whole_copies = order_by_walks();
        match_walks();
        follow_rings(sign, rest);
    }
    for (int i = 0; i < std::abs(whole_copies); ++i) rest.add(clip, whole_copies > 0 ? -sign : sign);
}

void RingDifference::sort_stations() {
    const auto m = static_cast<std::uint32_t>(clip_.size());
    stations_.clear();
    for (const std::uint32_t c : turns_) {
        const Contact& contact = contacts_[c];
        const bool at_vertex =
            contact.kind == ContactClass::ClipVertex || contact.kind == ContactClass::SharedVertex;
        const Point a = clip_[contact.clip];
        const Point b = clip_[contact.clip + 1 == m ? 0 : contact.clip + 1];
        const bool along_x = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
        const double along = along_x ? std::abs(contact.point.x - a.x) : std::abs(contact.point.y - a.y);
        stations_.push_back(
            {c, (contact.clip + m - 1) % m, at_vertex ? -1.0 : along, contact.turn == Turn::Leave});
    }
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
int RingDifference::order_by_walks() {
    int walks = classify_.winding_outside_first_edge();
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

/// Each Enter is joined with a Leave, like brackets: every stretch between them is walked back once.
void RingDifference::match_walks() {
    turn_of_contact_.resize(contacts_.size());
    for (std::uint32_t t = 0; t < turns_.size(); ++t) turn_of_contact_[turns_[t]] = t;
    exit_of_turn_.resize(turns_.size());
    walk_length_.resize(turns_.size());
    open_leaves_.clear();
    for (std::uint32_t s = 0; s < stations_.size(); ++s) {
        if (stations_[s].leave) {
            open_leaves_.push_back(s);
            continue;
        }
        const Station& exit = stations_[open_leaves_.back()];
        open_leaves_.pop_back();
        const std::uint32_t enter = turn_of_contact_[stations_[s].contact];
        exit_of_turn_[enter] = turn_of_contact_[exit.contact];
        walk_length_[enter] = stations_[s].rank - exit.rank;
    }
}

void RingDifference::follow_rings(int sign, SignedRings& rest) {
    followed_.assign(turns_.size(), 0);
    for (std::size_t t = 0; t < turns_.size(); ++t) {
        if (followed_[t] != 0 || contacts_[turns_[t]].turn == Turn::Enter) continue;
        for (std::size_t leave = t; followed_[leave] == 0;) {
            followed_[leave] = 1;
            const std::size_t enter = leave + 1 == turns_.size() ? 0 : leave + 1;
            follow_outside(leave, rest);
            walk_back(enter, rest);
            leave = exit_of_turn_[enter];
        }
        rest.close_ring(sign);
    }
}

/// The subject from a Leave to the Enter that follows it, both included.
void RingDifference::follow_outside(std::size_t leave_turn, SignedRings& rest) {
    const std::size_t n = subject_.size();
    const bool wraps = leave_turn + 1 == turns_.size();
    const Contact& leave = contacts_[turns_[leave_turn]];
    const Contact& enter = contacts_[turns_[wraps ? 0 : leave_turn + 1]];
    const bool enters_at_vertex =
        enter.kind == ContactClass::SubjectVertex || enter.kind == ContactClass::SharedVertex;
    const std::size_t last = enter.subject + (wraps ? n : 0) - (enters_at_vertex ? 1 : 0);
    rest.add_point(leave.point);
    for (std::size_t v = leave.subject + 1; v <= last; ++v) rest.add_point(subject_[v >= n ? v - n : v]);
    rest.add_point(enter.point);
}

/// The clipper's vertices from an Enter back to the Leave that it is joined with, ends excluded.
void RingDifference::walk_back(std::size_t enter_turn, SignedRings& rest) {
    std::size_t vertex = contacts_[turns_[enter_turn]].clip;
    for (std::uint32_t i = 0; i < walk_length_[enter_turn]; ++i) {
        rest.add_point(clip_[vertex]);
        vertex = (vertex == 0 ? clip_.size() : vertex) - 1;
    }
}

}  // namespace keikan

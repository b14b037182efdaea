// SPDX-License-Identifier: Apache-2.0
#include "partition.hpp"

#include <algorithm>
#include <cmath>

namespace keikan::clip {
namespace {

bool on_one_border(Point p, Point q) {
    return (p.x == q.x && (p.x == 0 || p.x == 1)) || (p.y == q.y && (p.y == 0 || p.y == 1));
}

Box intersection(const Box& a, const Box& b) {
    return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x),
            std::min(a.max_y, b.max_y)};
}

constexpr double kBoxSteps = 32000;
std::int16_t step_below(double v) {
    return static_cast<std::int16_t>(kBoxSteps * v);
}
std::int16_t step_above(double v) {
    return static_cast<std::int16_t>(static_cast<int>(kBoxSteps * v) + 1);
}

}  // namespace

void Partition::begin(PixelIndex pixel, const Entrants& entrants) {
    pixel_ = pixel;
    entrants_ = &entrants;
    size_ = used_ = free_cells_ = 0;
    const std::size_t n = entrants.faces.size();
    if (relation_.size() < n) relation_.resize(n), difference_.resize(n);
    cells_of_.assign(n, 0);
    reserve_points(4);
    reserve_cells(1);
    for (const Point corner : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}) points_[used_++] = corner;
    append_cell({0, 4}, kFree);
}

void Partition::insert(std::uint32_t who, Nearness nearness) {
    who_ = who;
    nearness_ = nearness;
    const Entrant& face = entrants_->faces[who];
    cuts_of(face);
    find_cells_near(face.box);
    std::fill_n(relation_.begin(), who, Relation::Unknown);
    for (std::size_t k = 0; k < near_count_; ++k) {
        const std::uint32_t cell = near_[k];
        const std::uint32_t label = label_[cell];
        if (label == kFree) {
            carve(cell);
            continue;
        }
        if (nearness == Nearness::InOrder) continue;
        const Entrant& owner = entrants_->faces[label];
        if (owner.w_min - owner.w_error > face.w_max + face.w_error) {
            settle(cell);
            continue;
        }
        if (rough_relation_to(label) != Relation::Behind) carve(cell);
    }
}

bool Partition::hides_all_below(double w, Nearness nearness) const {
    if (free_cells_ != 0) return false;
    if (nearness == Nearness::InOrder) return true;
    for (std::size_t i = 0; i < cells_of_.size(); ++i) {
        const Entrant& owner = entrants_->faces[i];
        if (cells_of_[i] != 0 && owner.w_min - owner.w_error <= w) return false;
    }
    return true;
}

void Partition::cuts_of(const Entrant& face) {
    const std::span<const Point> ring = entrants_->ring(face);
    cuts_.clear();
    Point p = ring.back();
    for (const Point q : ring) {
        if (!on_one_border(p, q)) cuts_.emplace_back(p, q);
        p = q;
    }
    if (reaching_.size() < cuts_.size()) reaching_.resize(cuts_.size());
}

void Partition::find_cells_near(const Box& box) {
    const std::int16_t min_x = step_below(box.min_x), max_x = step_above(box.max_x);
    const std::int16_t min_y = step_below(box.min_y), max_y = step_above(box.max_y);
    if (hit_.size() < label_.size()) hit_.resize(label_.size()), near_.resize(label_.size());
    std::int16_t* const hit = hit_.data();
    const std::int16_t *const lx = min_x_.data(), *const ly = min_y_.data();
    const std::int16_t *const hx = max_x_.data(), *const hy = max_y_.data();
    const std::size_t n = size_;
    for (std::size_t i = 0; i < n; ++i)  // written so that compilers turn it into vector comparisons
        hit[i] =
            static_cast<std::int16_t>((lx[i] < max_x) & (hx[i] > min_x) & (ly[i] < max_y) & (hy[i] > min_y));
    std::size_t count = 0;  // and here so that nothing depends on what the comparisons said
    for (std::size_t i = 0; i < n; ++i) {
        near_[count] = static_cast<std::uint32_t>(i);
        count += static_cast<std::size_t>(hit[i]);
    }
    near_count_ = count;
}

Partition::Relation Partition::rough_relation_to(std::uint32_t label) {
    Relation& relation = relation_[label];
    if (relation != Relation::Unknown) return relation;
    const Entrant& face = entrants_->faces[who_];
    const Entrant& other = entrants_->faces[label];
    const Box both = intersection(face.box, other.box);
    const NearnessDifference rough = NearnessDifference::rough(face.plane, other.plane);
    relation = rough.largest(both).certainly_negative()    ? Relation::Behind
               : rough.smallest(both).certainly_positive() ? Relation::InFront
                                                           : Relation::Open;
    return relation;
}

Partition::Relation Partition::relation_to(std::uint32_t label) {
    if (label == kFree) return Relation::InFront;
    Relation& relation = relation_[label];
    if (relation != Relation::Open) return relation;
    const Entrant& face = entrants_->faces[who_];
    const Entrant& other = entrants_->faces[label];
    const Box both = intersection(face.box, other.box);
    NearnessDifference& exact = difference_[label];
    exact = NearnessDifference::exact(pixel_, face.plane, other.plane);
    if (exact.is_zero())
        relation = face.id < other.id ? Relation::InFront : Relation::Behind;
    else
        relation = exact.largest(both).certainly_negative()    ? Relation::Behind
                   : exact.smallest(both).certainly_positive() ? Relation::InFront
                                                               : Relation::Mixed;
    return relation;
}

Partition::Relation Partition::relation_in(const Point* ring, std::size_t n, std::uint32_t label) const {
    const NearnessDifference& difference = difference_[label];
    double largest = -HUGE_VAL, smallest = HUGE_VAL;
    for (std::size_t i = 0; i < padded(n); ++i) {
        const double value = difference.roughly_at(ring[i]);
        largest = std::max(largest, value);
        smallest = std::min(smallest, value);
    }
    if (largest < -difference.error()) return Relation::Behind;
    return smallest > difference.error() ? Relation::InFront : Relation::Mixed;
}

template <class Cut>
bool Partition::keep_inside(Current& current, const Cut& cut) {
    const std::size_t n = current.size;
    if (side_.size() < n) side_.resize(2 * n);
    const Sides sides = sides_of(cut, current.ring, n, side_.data());
    if (sides.inside == 0) return false;
    if (sides.outside == 0) return true;
    // carve has made room; more is needed only for a ring that rounding has bent in many places.
    std::vector<Point>& inside = buffer_[current.free_buffer];
    if (inside.size() < room_of_part(n)) inside.resize(2 * room_of_part(n));
    reserve_points(room_of_part(n));
    const SplitSizes size =
        split(cut, sides, current.ring, side_.data(), n, inside.data(), points_.data() + used_);
    pending_.push_back({static_cast<std::uint32_t>(used_), static_cast<std::uint32_t>(size.outside)});
    pad(points_.data() + used_, size.outside);
    used_ += padded(size.outside);
    pad(inside.data(), size.inside);
    current = {inside.data(), size.inside, 1 - current.free_buffer};
    return true;
}

/// Which edges cut the cell? False if the face passes it by, which is the most frequent answer.
bool Partition::find_reaching_cuts(std::uint32_t cell) {
    const Range whole = ring_[cell];
    const Point* const ring = points_.data() + whole.begin;
    // To the end in any case: the cuts are few, and which of them ends the search cannot be foretold.
    bool overlaps = true;
    std::size_t count = 0;
    for (std::uint32_t k = 0; k < cuts_.size(); ++k) {
        const Reach reach = reach_of(cuts_[k], ring, whole.size);
        overlaps &= reach.inside;
        reaching_[count] = k;
        count += reach.outside;
    }
    reaching_count_ = count;
    return overlaps;
}

/// Gives the part of the cell that the face covers, and where it is nearer, to the face.
void Partition::carve(std::uint32_t cell) {
    if (!find_reaching_cuts(cell)) return;
    const std::uint32_t label = label_[cell];
    const Range whole = ring_[cell];
    Relation relation = relation_to(label);
    if (relation == Relation::Mixed) relation = relation_in(points_.data() + whole.begin, whole.size, label);
    if (relation == Relation::Behind) return;
    reserve_points(
        room_of_part(whole.size));  // now, since the first cut reads from the pool that it writes to
    Current current{points_.data() + whole.begin, whole.size};
    const std::size_t used_before = used_;
    pending_.clear();
    for (std::size_t i = 0; i < reaching_count_; ++i) {
        if (!keep_inside(current, cuts_[reaching_[i]])) {
            used_ = used_before;
            return;
        }
    }
    if (relation == Relation::Mixed) {
        if (!keep_inside(current, DepthCut(difference_[label]))) {
            used_ = used_before;  // it is behind wherever it overlaps the cell
            return;
        }
    }
    if (label == kFree)
        --free_cells_;
    else
        --cells_of_[label];
    ++cells_of_[who_];
    if (pending_.empty()) {
        label_[cell] = who_;
    } else {
        reserve_points(padded(current.size));
        std::copy_n(current.ring, padded(current.size), points_.data() + used_);
        set_cell(cell, {static_cast<std::uint32_t>(used_), static_cast<std::uint32_t>(current.size)}, who_);
        used_ += padded(current.size);
        reserve_cells(pending_.size());
        for (const Range piece : pending_) append_cell(piece, label);
    }
    if (nearness_ == Nearness::InOrder) settle(cell);
}

void Partition::set_cell(std::size_t cell, Range ring, std::uint32_t label) {
    const Point* const point = points_.data() + ring.begin;
    double min_x = point[0].x, max_x = min_x, min_y = point[0].y, max_y = min_y;
    for (std::size_t i = 1; i < ring.size; ++i) {
        min_x = std::min(min_x, point[i].x), max_x = std::max(max_x, point[i].x);
        min_y = std::min(min_y, point[i].y), max_y = std::max(max_y, point[i].y);
    }
    ring_[cell] = ring;
    label_[cell] = label;
    min_x_[cell] = step_below(min_x), max_x_[cell] = step_above(max_x);
    min_y_[cell] = step_below(min_y), max_y_[cell] = step_above(max_y);
}

void Partition::append_cell(Range ring, std::uint32_t label) {
    set_cell(size_++, ring, label);
    if (label == kFree)
        ++free_cells_;
    else
        ++cells_of_[label];
}

void Partition::settle(std::size_t cell) {
    min_x_[cell] = INT16_MAX;  // a box that meets no other
}

void Partition::reserve_points(std::size_t more) {
    if (used_ + more > points_.size()) points_.resize(2 * (used_ + more));
}

void Partition::reserve_cells(std::size_t more) {
    if (size_ + more <= label_.size()) return;
    const std::size_t room = 2 * (size_ + more);
    ring_.resize(room), label_.resize(room);
    min_x_.resize(room), min_y_.resize(room), max_x_.resize(room), max_y_.resize(room);
}

}  // namespace keikan::clip

// SPDX-License-Identifier: Apache-2.0
#include "partition.hpp"

#include <algorithm>

namespace keikan::clip {
namespace {

bool on_one_border(Point p, Point q) {
    return (p.x == q.x && (p.x == 0 || p.x == 1)) || (p.y == q.y && (p.y == 0 || p.y == 1));
}

Box intersection(const Box& a, const Box& b) {
    return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x),
            std::min(a.max_y, b.max_y)};
}

}  // namespace

void Partition::begin(PixelIndex pixel, const Entrants& entrants) {
    pixel_ = pixel;
    entrants_ = &entrants;
    ring_.clear(), label_.clear();
    min_x_.clear(), min_y_.clear(), max_x_.clear(), max_y_.clear();
    used_ = 0;
    free_cells_ = 0;
    relation_.resize(entrants.faces.size());
    difference_.resize(entrants.faces.size());
    reserve_points(4);
    for (const Point corner : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}) points_[used_++] = corner;
    append_cell({0, 4}, kFree);
}

void Partition::insert(std::uint32_t who, Nearness nearness) {
    who_ = who;
    const Entrant& face = entrants_->faces[who];
    cuts_of(face);
    find_cells_near(face.box);
    std::fill(relation_.begin(), relation_.end(), Relation::Unknown);
    for (const std::uint32_t cell : near_) {
        if (label_[cell] == kFree) {
            carve(cell, Relation::InFront);
        } else if (nearness == Nearness::ByDepth) {
            const Relation relation = relation_to(label_[cell]);
            if (relation != Relation::Behind) carve(cell, relation);
        }
    }
}

void Partition::cuts_of(const Entrant& face) {
    const std::span<const Point> ring = entrants_->ring(face);
    cuts_.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point p = ring[i], q = ring[i + 1 < ring.size() ? i + 1 : 0];
        if (!on_one_border(p, q)) cuts_.emplace_back(p, q);
    }
}

void Partition::find_cells_near(const Box& box) {
    // A float is off by at most 2^-25 here; four times that on either side errs towards a closer look.
    constexpr float kBoxError = 0x1p-23f;
    const float min_x = static_cast<float>(box.min_x) - kBoxError,
                max_x = static_cast<float>(box.max_x) + kBoxError;
    const float min_y = static_cast<float>(box.min_y) - kBoxError,
                max_y = static_cast<float>(box.max_y) + kBoxError;
    near_.clear();
    for (std::size_t i = 0; i < label_.size(); ++i)
        if ((min_x_[i] < max_x) & (max_x_[i] > min_x) & (min_y_[i] < max_y) & (max_y_[i] > min_y))
            near_.push_back(static_cast<std::uint32_t>(i));
}

Partition::Relation Partition::relation_to(std::uint32_t label) {
    Relation& relation = relation_[label];
    if (relation != Relation::Unknown) return relation;
    const Entrant& face = entrants_->faces[who_];
    const Entrant& other = entrants_->faces[label];
    const Box both = intersection(face.box, other.box);
    const auto decided = [&both](const NearnessDifference& d) {
        if (d.largest(both).certainly_negative()) return Relation::Behind;
        if (d.smallest(both).certainly_positive()) return Relation::InFront;
        return Relation::Mixed;
    };
    relation = decided(NearnessDifference::rough(face.plane, other.plane));
    if (relation == Relation::Mixed) {
        difference_[label] = NearnessDifference::exact(pixel_, face.plane, other.plane);
        if (difference_[label].is_zero())
            relation = face.id < other.id ? Relation::InFront : Relation::Behind;
        else
            relation = decided(difference_[label]);
    }
    return relation;
}

bool Partition::find_reaching_cuts(Range ring) {
    const Point* const point = points_.data() + ring.begin;
    reaching_.clear();
    for (std::uint32_t k = 0; k < cuts_.size(); ++k) {
        const EdgeCut& cut = cuts_[k];
        bool inside = false, outside = false;
        for (std::size_t i = 0; i < ring.size; ++i) {
            const double side = cut.side(point[i]);
            inside |= side > cut.on_line;
            outside |= side < -cut.on_line;
        }
        if (!inside) return false;
        if (outside) reaching_.push_back(k);
    }
    return true;
}

template <class Side, class Weld>
bool Partition::keep_inside(Range& current, double on_line, Side side, Weld weld) {
    const std::size_t n = current.size;
    reserve_points(2 * (n + 1));
    if (side_.size() < n) side_.resize(2 * n);
    const Point* const ring = points_.data() + current.begin;
    for (std::size_t i = 0; i < n; ++i) side_[i] = side(ring[i]);
    const SideCount count = settle_sides(side_.data(), n, on_line);
    if (count.inside == 0) return false;
    if (count.outside == 0) return true;
    Point* const inside = points_.data() + used_;
    Point* const outside = inside + n + 1;
    const SplitSizes size = split(ring, side_.data(), n, inside, outside, weld);
    current = {used_, size.inside};
    pending_.push_back({used_ + n + 1, size.outside});
    used_ += 2 * (n + 1);
    return true;
}

void Partition::carve(std::size_t cell, Relation relation) {
    Range current = ring_[cell];
    if (!find_reaching_cuts(current)) return;
    const std::size_t used_before = used_;
    pending_.clear();
    for (const std::uint32_t k : reaching_) {
        const EdgeCut& cut = cuts_[k];
        const auto side = [&cut](Point p) { return cut.side(p); };
        if (!keep_inside(current, cut.on_line, side, WeldToEdge{cut})) {
            used_ = used_before;  // the face passes the cell by
            return;
        }
    }
    if (relation == Relation::Mixed) {
        const NearnessDifference& nearer = difference_[label_[cell]];
        const auto side = [&nearer](Point p) { return nearer.at(p); };
        if (!keep_inside(current, nearer.on_line(), side, [](Point p) { return p; })) {
            used_ = used_before;  // it is behind wherever it overlaps the cell
            return;
        }
    }
    const std::uint32_t label = label_[cell];
    if (label == kFree) --free_cells_;
    set_cell(cell, current, who_);
    for (const Range piece : pending_) append_cell(piece, label);
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
    min_x_[cell] = static_cast<float>(min_x), max_x_[cell] = static_cast<float>(max_x);
    min_y_[cell] = static_cast<float>(min_y), max_y_[cell] = static_cast<float>(max_y);
}

void Partition::append_cell(Range ring, std::uint32_t label) {
    const std::size_t cell = label_.size();
    ring_.emplace_back(), label_.emplace_back();
    min_x_.emplace_back(), min_y_.emplace_back(), max_x_.emplace_back(), max_y_.emplace_back();
    set_cell(cell, ring, label);
    free_cells_ += label == kFree;
}

void Partition::reserve_points(std::size_t more) {
    if (used_ + more > points_.size()) points_.resize(2 * (used_ + more));
}

}  // namespace keikan::clip

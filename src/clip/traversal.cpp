// SPDX-License-Identifier: Apache-2.0
#include "traversal.hpp"

#include <algorithm>

#include "convex_outline.hpp"
#include "nearer_part.hpp"
#include "split.hpp"

namespace keikan::clip {

namespace {

constexpr Point kPixelRing[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// What the areas leave of 1 counts as nothing if it is no larger than the errors that areas are measured to
/// have (docs/numerics.md, section 7).
constexpr double kNothing = 5e-16;

bool boxes_overlap(const Box& a, const Box& b) {
    return a.min_x < b.max_x && b.min_x < a.max_x && a.min_y < b.max_y && b.min_y < a.max_y;
}

Box common_part(const Box& a, const Box& b) {
    return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x),
            std::min(a.max_y, b.max_y)};
}

Box box_of(std::span<const Point> ring) {
    Box box{ring[0].x, ring[0].y, ring[0].x, ring[0].y};
    for (const Point p : ring) {
        box.min_x = std::min(box.min_x, p.x), box.max_x = std::max(box.max_x, p.x);
        box.min_y = std::min(box.min_y, p.y), box.max_y = std::max(box.max_y, p.y);
    }
    return box;
}

}  // namespace

double Traversal::measure(PixelIndex pixel, const Entrants& entrants, Nearness nearness,
                          const Observer& observer, std::vector<Measure>& measures) {
    found_.clear();
    face_of_.clear();
    background_found_ = false;
    measures.assign(entrants.faces.size(), {});
    CarefulSum free;
    free.add(1);
    for (std::uint32_t who = 0; who < entrants.faces.size(); ++who) {
        find_visible(pixel, entrants, who, nearness, observer);
        Measure& measure = measures[who];
        for (std::size_t i = 0; i < remaining_.size(); ++i)
            measure.add(remaining_.ring(i), remaining_.sign(i));
        keep_remaining(entrants.faces[who].position);
        free.add(-measure.area.value());
    }
    if (observer) find_background(entrants, observer);
    return free.value() > kNothing ? free.value() : 0;
}

std::span<const VisibleOutline> Traversal::outlines(const Entrants& entrants, const Observer& observer) {
    if (!background_found_) find_background(entrants, observer);
    outlines_.clear();
    for (std::size_t i = 0; i < found_.size(); ++i)
        outlines_.push_back({face_of_[i], found_.sign(i), found_.ring(i)});
    return outlines_;
}

/// Leaves in remaining_ what of the face can be seen.
void Traversal::find_visible(PixelIndex pixel, const Entrants& entrants, std::uint32_t who, Nearness nearness,
                             const Observer& observer) {
    const Entrant& face = entrants.faces[who];
    remaining_.clear();
    remaining_.append(entrants.ring(face), 1);
    const bool in_order = nearness == Nearness::InOrder;
    const std::size_t fronts = in_order ? who : entrants.faces.size();
    for (std::size_t other = 0; other < fronts && !remaining_.empty(); ++other) {
        const Entrant& front = entrants.faces[other];
        if (other == who || !boxes_overlap(front.box, face.box)) continue;
        const std::span<const Point> clipper =
            in_order ? entrants.ring(front) : hiding_part(pixel, entrants, front, face);
        if (!clipper.empty()) subtract(clipper, front, face.position, observer);
    }
}

void Traversal::find_background(const Entrants& entrants, const Observer& observer) {
    background_found_ = true;
    remaining_.clear();
    remaining_.append(kPixelRing, 1);
    for (const Entrant& face : entrants.faces) {
        if (remaining_.empty()) break;
        subtract(entrants.ring(face), face, VisiblePiece::kBackground, observer);
    }
    keep_remaining(VisiblePiece::kBackground);
}

void Traversal::keep_remaining(std::uint32_t face) {
    for (std::size_t i = 0; i < remaining_.size(); ++i) {
        found_.append(remaining_.ring(i), remaining_.sign(i));
        face_of_.push_back(face);
    }
}

/// The part of `front` that hides whatever of `behind` is there, exactly convex; nothing if there is none.
std::span<const Point> Traversal::hiding_part(PixelIndex pixel, const Entrants& entrants,
                                              const Entrant& front, const Entrant& behind) {
    const std::span<const Point> ring = entrants.ring(front);
    if (front.w_max + front.w_error < behind.w_min - behind.w_error) return {};
    if (front.w_min - front.w_error > behind.w_max + behind.w_error) return ring;
    const Box both = common_part(front.box, behind.box);
    const NearnessDifference rough = NearnessDifference::rough(front.plane, behind.plane);
    if (rough.largest(both).certainly_negative()) return {};
    if (rough.smallest(both).certainly_positive()) return ring;

    const NearnessDifference nearer = NearnessDifference::exact(pixel, front.plane, behind.plane);
    if (nearer.is_zero()) return front.id < behind.id ? ring : std::span<const Point>();
    const std::size_t n = ring.size();
    side_.resize(n);
    const DepthCut cut(nearer);
    const Sides sides = sides_of(cut, ring.data(), n, side_.data());
    if (sides.inside == 0) return {};
    if (sides.outside == 0) return ring;
    nearer_part_.resize(2 * n);
    farther_part_.resize(2 * n);
    const SplitSizes size =
        split(cut, sides, ring.data(), side_.data(), n, nearer_part_.data(), farther_part_.data());
    nearer_part_.resize(size.inside);
    if (turning(nearer_part_) != Turning::Positive) replace_by_hull(nearer_part_);
    if (nearer_part_.size() < 3) return {};
    return nearer_part_;
}

/// Takes a clipper, of face `front`, out of remaining_, which is of face `behind`. As long as it is apart
/// from all rings, they stay where they are.
void Traversal::subtract(std::span<const Point> clipper, const Entrant& front, std::uint32_t behind,
                         const Observer& observer) {
    bool changed = false;
    for (std::size_t i = 0; i < remaining_.size(); ++i) {
        const std::span<const Point> ring = remaining_.ring(i);
        if (remaining_.size() == 1 || boxes_overlap(box_of(ring), front.box)) {
            const bool apart = difference_.position(ring, clipper) == IntersectionClassifier::Position::Apart;
            if (!apart) {
                if (!changed) {
                    next_.clear();
                    for (std::size_t k = 0; k < i; ++k) next_.append(remaining_.ring(k), remaining_.sign(k));
                    changed = true;
                }
                difference_.append_rest(remaining_.sign(i), next_);
            }
            if (observer)
                observer({ring, clipper, difference_.contacts(), remaining_.sign(i), behind, front.position});
            if (!apart) continue;
        }
        if (changed) next_.append(ring, remaining_.sign(i));
    }
    if (changed) std::swap(remaining_, next_);
}

}  // namespace keikan::clip

// SPDX-License-Identifier: Apache-2.0
#include "traversal.hpp"

#include <algorithm>

#include "convex_outline.hpp"
#include "nearer_part.hpp"
#include "split.hpp"

namespace keikan::clip {

namespace {

constexpr Point kPixelRing[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

bool boxes_overlap(const Box& a, const Box& b) {
    return a.min_x < b.max_x && b.min_x < a.max_x && a.min_y < b.max_y && b.min_y < a.max_y;
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

/// Whether `front` hides anything of `behind`; then clipper_ is the part of it that does, exactly convex.
bool Traversal::hides(PixelIndex pixel, const Entrants& entrants, std::uint32_t front, std::uint32_t behind,
                      Nearness nearness) {
    const Entrant& f = entrants.faces[front];
    const Entrant& b = entrants.faces[behind];
    if (!boxes_overlap(f.box, b.box)) return false;
    const std::span<const Point> ring = entrants.ring(f);
    const auto whole = [&] {
        clipper_.assign(ring.begin(), ring.end());
        return true;
    };
    if (nearness == Nearness::InOrder) return front < behind && whole();
    if (f.w_max + f.w_error < b.w_min - b.w_error) return false;
    if (f.w_min - f.w_error > b.w_max + b.w_error) return whole();

    const NearnessDifference nearer = NearnessDifference::exact(pixel, f.plane, b.plane);
    if (nearer.is_zero()) return f.id < b.id && whole();
    const std::size_t n = ring.size();
    side_.resize(n);
    const DepthCut cut(nearer);
    const Sides sides = sides_of(cut, ring.data(), n, side_.data());
    if (sides.inside == 0) return false;
    if (sides.outside == 0) return whole();
    clipper_.resize(2 * n);
    outside_.resize(2 * n);
    const SplitSizes size = split(cut, sides, ring.data(), side_.data(), n, clipper_.data(), outside_.data());
    clipper_.resize(size.inside);
    if (turning(clipper_) != Turning::Positive) replace_by_hull(clipper_);
    return clipper_.size() >= 3;
}

void Traversal::subtract(std::span<const Point> clipper, const Box& box, const Observer& observer) {
    next_.clear();
    for (std::size_t i = 0; i < remaining_.size(); ++i) {
        const std::span<const Point> ring = remaining_.ring(i);
        if (!boxes_overlap(box_of(ring), box)) {
            next_.add(ring, remaining_.sign(i));
            continue;
        }
        difference_(ring, remaining_.sign(i), clipper, next_);
        if (observer) observer({ring, clipper, difference_.contacts()});
    }
    std::swap(remaining_, next_);
}

const SignedRings& Traversal::visible(PixelIndex pixel, const Entrants& entrants, std::uint32_t who,
                                      Nearness nearness, const Observer& observer) {
    remaining_.clear();
    remaining_.add(entrants.ring(entrants.faces[who]), 1);
    for (std::uint32_t front = 0; front < entrants.faces.size() && !remaining_.empty(); ++front)
        if (front != who && hides(pixel, entrants, front, who, nearness))
            subtract(clipper_, entrants.faces[front].box, observer);
    return remaining_;
}

const SignedRings& Traversal::background(const Entrants& entrants, const Observer& observer) {
    remaining_.clear();
    remaining_.add(kPixelRing, 1);
    for (const Entrant& face : entrants.faces) {
        if (remaining_.empty()) break;
        subtract(entrants.ring(face), face.box, observer);
    }
    return remaining_;
}

}  // namespace keikan::clip

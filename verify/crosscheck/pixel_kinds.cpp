// SPDX-License-Identifier: GPL-3.0-or-later
#include "pixel_kinds.hpp"

#include <algorithm>

#include "keikan/clip/orient2d.hpp"
#include "keikan/clip/visible_areas.hpp"

namespace keikan::crosscheck {
namespace {

Point after(std::span<const Point> ring, std::size_t i) {
    return ring[(i + 1) % ring.size()];
}
Point before(std::span<const Point> ring, std::size_t i) {
    return ring[(i + ring.size() - 1) % ring.size()];
}

bool is_outside(std::span<const Point> clip, Point p) {
    for (std::size_t j = 0; j < clip.size(); ++j)
        if (orient2d(clip[j], after(clip, j), p) == Sign::Negative) return true;
    return false;
}

/// Whether q lies strictly within the corner of the subject at vertex i, or strictly left of its edge i.
bool within_corner(std::span<const Point> ring, std::size_t i, Point q) {
    const bool left_of_first = orient2d(before(ring, i), ring[i], q) == Sign::Positive;
    const bool left_of_second = orient2d(ring[i], after(ring, i), q) == Sign::Positive;
    const bool reflex = orient2d(before(ring, i), ring[i], after(ring, i)) == Sign::Negative;
    return reflex ? left_of_first || left_of_second : left_of_first && left_of_second;
}

/// Of a Touch: whether the one lies within the other there.
bool touches_inside(const ClipStep& step, const Contact& c) {
    const bool at_vertex = c.kind == ContactClass::SubjectVertex || c.kind == ContactClass::SharedVertex;
    if (at_vertex && !is_outside(step.clip, before(step.subject, c.subject)) &&
        !is_outside(step.clip, after(step.subject, c.subject)))
        return true;  // the subject within the clipper
    if (c.kind == ContactClass::SharedVertex)
        return within_corner(step.subject, c.subject, before(step.clip, c.clip)) ||
               within_corner(step.subject, c.subject, after(step.clip, c.clip));
    const Point a = step.subject[c.subject], b = after(step.subject, c.subject);
    return c.kind == ContactClass::ClipVertex &&
           (orient2d(a, b, before(step.clip, c.clip)) == Sign::Positive ||
            orient2d(a, b, after(step.clip, c.clip)) == Sign::Positive);
}

double area_of(const SignedRings& rings) {
    double twice = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) twice += rings.sign(i) * twice_signed_area(rings.ring(i));
    return twice / 2;
}

}  // namespace

const char* name_of(PixelKind kind) {
    constexpr const char* kNames[kPixelKinds] = {
        "edge-edge", "subject-vertex",  "clip-vertex",  "shared-vertex",
        "hole",      "touching-inside", "cyclic-depth", "interpenetration"};
    return kNames[static_cast<std::size_t>(kind)];
}

void KindsOfPixel::start() {
    found_ = 0;
    hidings_.clear();
}

void KindsOfPixel::take(const ClipStep& step) {
    for (const Contact& contact : step.contacts) {
        found_ |= bit_of(static_cast<PixelKind>(contact.kind));
        if (contact.turn == Turn::Touch && touches_inside(step, contact))
            found_ |= bit_of(PixelKind::TouchingInside);
    }
    if (step.subject_face != ClipStep::kBackground && takes_area(step))
        hidings_.push_back({step.clip_face, step.subject_face});
}

bool KindsOfPixel::takes_area(const ClipStep& step) {
    if (difference_.position(step.subject, step.clip) == IntersectionClassifier::Position::Apart)
        return false;
    rest_.clear();
    difference_.append_rest(step.sign, rest_);
    const double taken = step.sign * twice_signed_area(step.subject) / 2 - area_of(rest_);
    return taken * step.sign > kVisibleAreaError;
}

/// Whether hidings lead from `from` to `to`.
bool KindsOfPixel::in_cycle(std::uint32_t from, std::uint32_t to, std::vector<std::uint32_t>& visited) const {
    for (const Hiding& h : hidings_) {
        if (h.front != from || std::ranges::count(visited, h.behind) > 0) continue;
        if (h.behind == to) return true;
        visited.push_back(h.behind);
        if (in_cycle(h.behind, to, visited)) return true;
    }
    return false;
}

PixelKinds KindsOfPixel::kinds(std::span<const VisibleOutline> outlines) {
    if (std::ranges::any_of(outlines, [](const VisibleOutline& o) { return o.sign < 0; }))
        found_ |= bit_of(PixelKind::Hole);
    // Pairs that hide parts of each other pass through each other; what else leads back is a longer cycle.
    std::vector<Hiding> one_way;
    for (const Hiding& h : hidings_) {
        const auto reverse = [&](const Hiding& o) { return o.front == h.behind && o.behind == h.front; };
        if (std::ranges::any_of(hidings_, reverse))
            found_ |= bit_of(PixelKind::Interpenetration);
        else
            one_way.push_back(h);
    }
    hidings_.swap(one_way);
    std::vector<std::uint32_t> visited;
    for (const Hiding& h : hidings_) {
        visited.clear();
        if (in_cycle(h.behind, h.front, visited)) {
            found_ |= bit_of(PixelKind::CyclicDepth);
            break;
        }
    }
    return found_;
}

}  // namespace keikan::crosscheck

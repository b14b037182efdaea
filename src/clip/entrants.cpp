// SPDX-License-Identifier: Apache-2.0
#include "entrants.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace keikan::clip {
namespace {

constexpr Point kPixelRing[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Box box_of(std::span<const Point> ring) {
    Box box{1, 1, 0, 0};
    for (const Point p : ring) {
        box.min_x = std::min(box.min_x, p.x), box.max_x = std::max(box.max_x, p.x);
        box.min_y = std::min(box.min_y, p.y), box.max_y = std::max(box.max_y, p.y);
    }
    return box;
}

bool boxes_apart(const Box& a, const Box& b) {
    return a.max_x <= b.min_x || b.max_x <= a.min_x || a.max_y <= b.min_y || b.max_y <= a.min_y;
}

/// Whether an edge of `a` has all of `b` on its outer side.
bool edge_separates(std::span<const Point> a, std::span<const Point> b) {
    Point p = a.back();
    for (const Point q : a) {
        const double dx = q.x - p.x, dy = q.y - p.y;
        const double on_line = kHalfUlp * (std::abs(dx) + std::abs(dy));
        bool outside = true;
        for (const Point r : b) {
            if (dx * (r.y - p.y) - dy * (r.x - p.x) > on_line) {
                outside = false;
                break;
            }
        }
        if (outside) return true;
        p = q;
    }
    return false;
}

}  // namespace

EntrantReader::DepthRange EntrantReader::depth_range(PixelIndex pixel, const DepthPlane& plane) {
    const double ax = plane.a * pixel.x, by = plane.b * pixel.y;
    const double corner = plane.c + ax + by;
    // Two products, two sums, and two more sums with the slopes below.
    const double sizes =
        std::abs(plane.c) + std::abs(ax) + std::abs(by) + std::abs(plane.a) + std::abs(plane.b);
    const double error = 8 * kHalfUlp * sizes;
    return {corner + std::min(plane.a, 0.0) + std::min(plane.b, 0.0) - error,
            corner + std::max(plane.a, 0.0) + std::max(plane.b, 0.0) + error};
}

/// The outline if it is strictly convex as it stands, else its hull.
ConvexOutline EntrantReader::convex(std::span<const Point> outline) {
    const Turning found = turning(outline);
    if (found != Turning::NotStrictlyConvex) return {outline, found == Turning::Negative};
    if (hulls_used_ == hulls_.size()) hulls_.emplace_back();
    std::vector<Point>& hull = hulls_[hulls_used_++];
    hull.assign(outline.begin(), outline.end());
    replace_by_hull(hull);
    return {hull, false};
}

void EntrantReader::find_candidates(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness) {
    candidates_.clear();
    views_.clear();
    hulls_used_ = 0;
    double hidden_below = -HUGE_VAL;  // the largest w below which a face that covers the pixel hides all
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (!may_overlap(pixel, faces[i].outline)) continue;
        Candidate candidate;
        if (nearness == Nearness::ByDepth) {
            candidate.depth = depth_range(pixel, faces[i].depth);
            if (candidate.depth.max < hidden_below) continue;
        }
        candidate.position = static_cast<std::uint32_t>(i);
        candidate.outline = convex(faces[i].outline);
        if (candidate.outline.size() < 3) continue;
        candidate.views = views_.size();
        candidate.overlap = overlap(pixel, candidate.outline, views_);
        if (candidate.overlap == Overlap::Nothing) continue;
        const bool whole = candidate.overlap == Overlap::WholePixel;
        if (whole && nearness == Nearness::ByDepth)
            hidden_below = std::max(hidden_below, candidate.depth.min);
        candidates_.push_back(candidate);
        if (whole && nearness == Nearness::InOrder) break;
    }
    if (hidden_below > -HUGE_VAL)
        std::erase_if(candidates_, [&](const Candidate& c) { return c.depth.max < hidden_below; });
}

void EntrantReader::read(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness,
                         Entrants& entrants) {
    find_candidates(pixel, faces, nearness);
    entrants.clear();
    for (const Candidate& candidate : candidates_) {
        const auto views = std::span(views_).subspan(candidate.views, candidate.outline.size());
        const std::span<const Point> ring = candidate.overlap == Overlap::WholePixel
                                                ? std::span<const Point>(kPixelRing)
                                                : clip_to_pixel(pixel, candidate.outline, views, scratch_);
        if (ring.empty()) continue;
        Entrant& entrant = entrants.faces.emplace_back();
        entrant.position = candidate.position;
        entrant.id = faces[candidate.position].id;
        entrant.ring = static_cast<std::uint32_t>(entrants.corners.size());
        entrant.size = static_cast<std::uint32_t>(ring.size());
        entrant.box = box_of(ring);
        entrants.corners.insert(entrants.corners.end(), ring.begin(), ring.end());
    }
}

void find_lone_faces(Entrants& entrants) {
    std::vector<Entrant>& faces = entrants.faces;
    const bool few = faces.size() <= kMostCompared;
    for (Entrant& face : faces) face.alone = few;
    if (!few) return;
    for (std::size_t i = 1; i < faces.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            Entrant &a = faces[i], &b = faces[j];
            if ((!a.alone && !b.alone) || boxes_apart(a.box, b.box)) continue;
            const std::span<const Point> ring_a = entrants.ring(a), ring_b = entrants.ring(b);
            if (edge_separates(ring_a, ring_b) || edge_separates(ring_b, ring_a)) continue;
            a.alone = b.alone = false;
        }
}

void measure_depths(PixelIndex pixel, std::span<const FaceView> faces, Entrants& entrants) {
    for (Entrant& entrant : entrants.faces) {
        if (entrant.alone) continue;
        const LocalPlane plane = local_plane(pixel, faces[entrant.position].depth);
        entrant.plane = plane;
        entrant.w_min = HUGE_VAL, entrant.w_max = -HUGE_VAL;
        for (const Point p : entrants.ring(entrant)) {
            const double w = plane.c.hi + (plane.a * p.x + plane.b * p.y);
            entrant.w_min = std::min(entrant.w_min, w);
            entrant.w_max = std::max(entrant.w_max, w);
        }
        entrant.w_error = 5 * kHalfUlp * (std::abs(plane.a) + std::abs(plane.b) + std::abs(plane.c.hi));
    }
}

void put_in_order_of_depth(Entrants& entrants) {
    const auto plane = [](const Entrant& e) {
        return std::tuple(e.plane.image.a, e.plane.image.b, e.plane.image.c);
    };
    const auto before = [&](const Entrant& p, const Entrant& q) {
        if (p.alone != q.alone) return q.alone;
        if (p.w_max != q.w_max) return p.w_max > q.w_max;
        if (p.id != q.id) return p.id < q.id;
        if (plane(p) != plane(q)) return plane(p) < plane(q);
        const std::span<const Point> a = entrants.ring(p), b = entrants.ring(q);
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), [](Point u, Point v) {
            return std::pair(u.x, u.y) < std::pair(v.x, v.y);
        });
    };
    std::sort(entrants.faces.begin(), entrants.faces.end(), before);
}

void put_in_order_of_list(Entrants& entrants) {
    std::sort(entrants.faces.begin(), entrants.faces.end(), [](const Entrant& p, const Entrant& q) {
        return p.alone != q.alone ? q.alone : p.position < q.position;
    });
}

}  // namespace keikan::clip

// SPDX-License-Identifier: Apache-2.0
#include "closed_layer.hpp"

#include <algorithm>
#include <cmath>

#include "edge_moments.hpp"
#include "part_with.hpp"

namespace keikan {
namespace {

/// Position of `face` among the candidates, which rise by face; their number where it is none of them.
std::size_t position_of(std::uint32_t face, std::span<const Candidate> candidates) {
    constexpr std::size_t kFew = 24;
    if (candidates.size() <= kFew) {
        std::size_t i = 0;
        while (i < candidates.size() && candidates[i].face != face) ++i;
        return i;
    }
    const auto at = std::lower_bound(candidates.begin(), candidates.end(), face,
                                     [](const Candidate& c, std::uint32_t f) { return c.face < f; });
    if (at == candidates.end() || at->face != face) return candidates.size();
    return static_cast<std::size_t>(at - candidates.begin());
}

/// Whether w of `front` is larger than w of `back` all over the box, for certain. Their difference is affine,
/// so its least value is at a corner.
bool nearer_over_box(const DepthPlane& front, const DepthPlane& back, double left, double top, double right,
                     double bottom) {
    for (const double x : {left, right})
        for (const double y : {top, bottom}) {
            const double difference =
                (front.a * x + front.b * y + front.c) - (back.a * x + back.b * y + back.c);
            // The subtraction itself rounds once more; doubling both bounds covers it, as |w| is below the
            // sum of the sizes that the bound is made of.
            if (!(difference > 2 * (plane_error(front, x, y) + plane_error(back, x, y)))) return false;
        }
    return true;
}

}  // namespace

bool ClosedLayer::begin(PixelIndex pixel, const std::vector<FaceFacts>& facts,
                        std::span<const Candidate> candidates) {
    search_ = 0;
    progress_.assign(candidates.size(), Progress{});
    const double left = pixel.x, top = pixel.y, right = left + 1, bottom = top + 1;
    unsigned met = 0;  // bit k: the corner k, or the middle, lies in the bounding box of some candidate
    for (const Candidate& c : candidates) {
        const FaceFacts& f = facts[c.face];
        const bool to_left = f.left <= left, to_right = f.right >= right;
        const bool to_top = f.top <= top, to_bottom = f.bottom >= bottom;
        const bool middle =
            f.left <= left + 0.5 && f.right >= left + 0.5 && f.top <= top + 0.5 && f.bottom >= top + 0.5;
        met |= unsigned{to_left && to_top} | unsigned{to_right && to_top} << 1 |
               unsigned{to_right && to_bottom} << 2 | unsigned{to_left && to_bottom} << 3 |
               unsigned{middle} << 4;
    }
    return met == 31;
}

void ClosedLayer::add_member(std::size_t candidate) {
    progress_[candidate] = {};
    progress_[candidate].search = search_;
    members_.push_back(static_cast<std::uint32_t>(candidate));
}

/// Collects what is connected with `start` through shared edges, and sums up the moments of each face, edge
/// by edge; an edge inside the layer is worked out once for both of its faces. An edge needs no neighbour
/// when it cannot meet the pixel's interior: the pixel lies wholly on its inner side, or the edge's box
/// beside the pixel. (With the outer side, which no candidate has, these are all the ways in which a segment
/// and a square can be apart.)
bool ClosedLayer::grow(PixelIndex pixel, const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
                       const FaceNeighbours& neighbours, std::span<const Candidate> candidates,
                       std::size_t start) {
    ++search_;
    members_.clear();
    add_member(start);
    bool closed = true;
    for (std::size_t m = 0; m < members_.size(); ++m) {
        const Candidate& member = candidates[members_[m]];
        Progress& mine = progress_[members_[m]];
        mine.is_done = true;
        const std::uint32_t begin = faces.begin[member.face];
        const std::uint32_t edges = faces.begin[member.face + 1] - begin;
        const int turn = facts[member.face].turn;
        if (turn == 0) {  // every edge is open, and more of them than Progress has bits for
            closed = false;
            continue;
        }
        const Point* const corner = faces.points.data() + begin;
        for (std::uint32_t e = 0; e < edges; ++e) {
            const Point& p = corner[e];
            const Point& q = corner[e + 1 < edges ? e + 1 : 0];
            if (mine.given >> e & 1) continue;
            if (member.inside >> e & 1) {
                mine.moments += edge_moments_beside(p, q, pixel, is_right_of_what_is_inside(p, q, turn));
                continue;
            }
            if (box_misses_pixel(p, q, pixel)) {
                mine.moments += edge_moments_beside(p, q, pixel, std::min(p.x, q.x) >= pixel.x + 1);
                continue;
            }
            const std::uint32_t across = neighbours.across[begin + e];
            const std::size_t next =
                across == FaceNeighbours::kOpen ? candidates.size() : position_of(across, candidates);
            if (next == candidates.size()) {
                closed = false;
                continue;
            }
            if (!has_reached(next)) add_member(next);
            if (!closed) continue;
            const Moments moments = edge_moments(p, q, pixel);
            mine.moments += moments;
            if (progress_[next].is_done) continue;
            // The neighbour gets the negative for the same edge, which there runs the other way.
            const std::uint32_t there = faces.begin[across];
            for (std::uint32_t k = 0; k < facts[across].corners; ++k)
                if (neighbours.across[there + k] == member.face && faces.points[there + k] == q) {
                    progress_[next].given |= static_cast<std::uint8_t>(1u << k);
                    progress_[next].moments -= moments;
                }
        }
    }
    return closed;
}

bool ClosedLayer::hides(PixelIndex pixel, const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
                        std::span<const Candidate> candidates, std::size_t other) const {
    if (candidates[other].w_max < w_min_) return true;
    // Face by face, where both can be: the difference of two planes that slope alike is much tighter.
    const std::uint32_t back = candidates[other].face;
    const double left = std::max<double>(facts[back].left, pixel.x);
    const double top = std::max<double>(facts[back].top, pixel.y);
    const double right = std::min<double>(facts[back].right, pixel.x + 1);
    const double bottom = std::min<double>(facts[back].bottom, pixel.y + 1);
    return std::all_of(members_.begin(), members_.end(), [&](std::uint32_t member) {
        const FaceFacts& front = facts[candidates[member].face];
        const double common_left = std::max(left, front.left), common_right = std::min(right, front.right);
        const double common_top = std::max(top, front.top), common_bottom = std::min(bottom, front.bottom);
        return common_left > common_right || common_top > common_bottom ||
               candidates[member].w_min > candidates[other].w_max ||
               nearer_over_box(faces.plane[candidates[member].face], faces.plane[back], common_left,
                               common_top, common_right, common_bottom);
    });
}

bool ClosedLayer::find(PixelIndex pixel, const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
                       const FaceNeighbours& neighbours, std::span<const Candidate> candidates,
                       std::size_t start) {
    if (!grow(pixel, faces, facts, neighbours, candidates, start)) return false;
    std::sort(members_.begin(), members_.end());
    parts_.clear();
    double area = 0;
    w_min_ = candidates[start].w_min;
    for (const std::uint32_t m : members_) {
        const std::uint32_t face = candidates[m].face;
        const double sign = facts[face].turn;
        const Moments& moments = progress_[m].moments;
        const double share = sign * moments.area;
        area += share;
        w_min_ = std::min(w_min_, candidates[m].w_min);
        if (share > kLeastShare)
            parts_.push_back(part_with(face, {share, sign * moments.x, sign * moments.y}));
    }
    return std::abs(area - 1) < 0.25;  // a whole number, rounded by far less
}

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#include "faces_apart.hpp"

#include <algorithm>

#include "edge_moments.hpp"
#include "keikan/clip/orient2d.hpp"
#include "part_with.hpp"

namespace keikan {
namespace {

/// Beyond this many faces the pairs would cost more than is saved.
constexpr std::size_t kMostFaces = 8;

/// The one face that covers the pixel, with all others certainly in front of it; kNone where no face covers
/// the pixel, kUnclear where one does and another is not certainly in front.
constexpr std::uint32_t kNone = 0xFFFFFFFFu, kUnclear = 0xFFFFFFFEu;

std::uint32_t cover_behind(std::span<const Candidate> candidates, std::span<const std::uint32_t> kept) {
    std::uint32_t cover = kNone;
    for (const std::uint32_t i : kept)
        if (candidates[i].covers && (cover == kNone || candidates[i].w_max < candidates[cover].w_max))
            cover = i;
    if (cover == kNone) return kNone;
    for (const std::uint32_t i : kept)
        if (i != cover && !(candidates[i].w_min > candidates[cover].w_max)) return kUnclear;
    return cover;
}

/// Whether some edge of `face`, which turns by `turn`, has all corners of `other` on its outer side or on it.
bool an_edge_separates(std::span<const Point> face, int turn, std::span<const Point> other) {
    for (std::size_t e = 0; e < face.size(); ++e) {
        const Point p = face[e], q = face[e + 1 < face.size() ? e + 1 : 0];
        if (std::all_of(other.begin(), other.end(),
                        [&](Point corner) { return static_cast<int>(orient2d(p, q, corner)) * turn <= 0; }))
            return true;
    }
    return false;
}

bool are_apart(const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
               const FaceNeighbours& neighbours, std::uint32_t f, std::uint32_t g) {
    const FaceFacts &one = facts[f], &other = facts[g];
    if (one.right <= other.left || other.right <= one.left || one.bottom <= other.top ||
        other.bottom <= one.top)
        return true;
    const auto across = std::span(neighbours.across).subspan(faces.begin[f], one.corners);
    if (std::find(across.begin(), across.end(), g) != across.end()) return true;
    return an_edge_separates(faces[f].outline, one.turn, faces[g].outline) ||
           an_edge_separates(faces[g].outline, other.turn, faces[f].outline);
}

Moments moments_in_pixel(const ProjectedFaces& faces, const std::vector<FaceFacts>& facts, const Candidate& c,
                         PixelIndex pixel) {
    const auto outline = faces[c.face].outline;
    const int turn = facts[c.face].turn;
    Moments sum;
    for (std::size_t e = 0; e < outline.size(); ++e) {
        const Point p = outline[e], q = outline[e + 1 < outline.size() ? e + 1 : 0];
        if (c.inside >> e & 1)
            sum += edge_moments_beside(p, q, pixel, is_right_of_what_is_inside(p, q, turn));
        else
            sum += edge_moments(p, q, pixel);
    }
    return turn > 0 ? sum : Moments{-sum.area, -sum.x, -sum.y};
}

}  // namespace

bool FacesApart::divide(PixelIndex pixel, const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
                        const FaceNeighbours& neighbours, std::span<const Candidate> candidates,
                        std::span<const std::uint32_t> kept) {
    if (kept.size() > kMostFaces) return false;
    const std::uint32_t cover = cover_behind(candidates, kept);
    if (cover == kUnclear) return false;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (kept[i] == cover) continue;
        const std::uint32_t face = candidates[kept[i]].face;
        if (facts[face].turn == 0) return false;
        for (std::size_t j = 0; j < i; ++j)
            if (kept[j] != cover && !are_apart(faces, facts, neighbours, face, candidates[kept[j]].face))
                return false;
    }

    parts_.clear();
    std::size_t cover_at = 0;
    Moments rest{1, 0.5, 0.5};
    for (const std::uint32_t i : kept) {
        if (i == cover) {
            cover_at = parts_.size();
            continue;
        }
        const Moments moments = moments_in_pixel(faces, facts, candidates[i], pixel);
        if (moments.area <= kLeastShare) continue;
        rest -= moments;
        parts_.push_back(part_with(candidates[i].face, moments));
    }
    // The rest is nothing when rounding alone could have left it.
    background_ = 0;
    if (rest.area > kLeastShare) {
        if (cover == kNone)
            background_ = rest.area;
        else
            parts_.insert(parts_.begin() + static_cast<std::ptrdiff_t>(cover_at),
                          part_with(candidates[cover].face, rest));
    }
    return true;
}

}  // namespace keikan

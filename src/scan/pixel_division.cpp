// SPDX-License-Identifier: Apache-2.0
#include "pixel_division.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace keikan {
namespace {

/// Whether the segment meets the closed pixel, in plain arithmetic: extraction is a choice of what to draw
/// how well, and no area depends on it.
bool meets_pixel(Point p, Point q, PixelIndex pixel) {
    const double left = pixel.x, top = pixel.y, right = left + 1, bottom = top + 1;
    if (std::max(p.x, q.x) < left || std::min(p.x, q.x) > right || std::max(p.y, q.y) < top ||
        std::min(p.y, q.y) > bottom)
        return false;
    const auto side = [&](double x, double y) { return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x); };
    const std::array<double, 4> sides{side(left, top), side(right, top), side(left, bottom),
                                      side(right, bottom)};
    const auto [least, greatest] = std::minmax_element(sides.begin(), sides.end());
    return *least <= 0 && *greatest >= 0;
}

/// A centroid's coordinate, which rounding may have left just outside.
float within_pixel(double v) {
    return static_cast<float>(std::clamp(v, 0.0, 1.0));
}

}  // namespace

DividedView PixelDivision::operator()(PixelIndex pixel, std::span<const Candidate> candidates) {
    if (question_.options.extraction == Extraction::Paper && !flagged(pixel, candidates))
        return by_scanline(pixel, candidates);
    if (question_.options.engine == Engine::Splitting) return by_exact_areas(pixel, candidates);
    kept_.resize(candidates.size());
    std::iota(kept_.begin(), kept_.end(), 0u);
    return by_visible_areas(pixel, candidates);
}

DividedView PixelDivision::by_exact_areas(PixelIndex pixel, std::span<const Candidate> candidates) {
    // A layer that tiles the pixel hides what lies wholly behind it. If nothing else is left, its faces'
    // areas are the answer; otherwise it has shortened the question. Layers are looked for from the nearest
    // face on, among those that no search has reached and no layer hides.
    fate_.assign(candidates.size(), Fate::Open);
    nearest_first_.clear();
    if (layer_.begin(pixel, question_.facts, candidates)) {
        nearest_first_.resize(candidates.size());
        std::iota(nearest_first_.begin(), nearest_first_.end(), 0u);
        std::sort(nearest_first_.begin(), nearest_first_.end(), [&](std::uint32_t i, std::uint32_t j) {
            return candidates[i].w_max != candidates[j].w_max ? candidates[i].w_max > candidates[j].w_max
                                                              : i < j;
        });
    }
    for (const std::uint32_t start : nearest_first_) {
        if (fate_[start] != Fate::Open) continue;
        const bool found =
            layer_.find(pixel, question_.faces, question_.facts, question_.neighbours, candidates, start);
        for (const std::uint32_t i : layer_.reached())
            if (fate_[i] == Fate::Open) fate_[i] = Fate::Asked;
        if (!found) continue;
        bool alone = true;
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            if (layer_.has_reached(i) || fate_[i] == Fate::Hidden) continue;
            if (layer_.hides(pixel, question_.faces, question_.facts, candidates, i))
                fate_[i] = Fate::Hidden;
            else
                alone = false;
        }
        if (alone) return {Division::ExactAreas, layer_.parts(), 0};
    }
    kept_.clear();
    for (std::uint32_t i = 0; i < candidates.size(); ++i)
        if (fate_[i] != Fate::Hidden) kept_.push_back(i);
    if (apart_.divide(pixel, question_.faces, question_.facts, question_.neighbours, candidates, kept_))
        return {Division::ExactAreas, apart_.parts(), apart_.background()};
    return by_visible_areas(pixel, candidates);
}

DividedView PixelDivision::by_visible_areas(PixelIndex pixel, std::span<const Candidate> candidates) {
    asked_.clear();
    asked_face_.clear();
    for (const std::uint32_t i : kept_) {
        asked_.push_back(question_.faces[candidates[i].face]);
        asked_face_.push_back(candidates[i].face);
    }
    const PixelCoverage coverage = visible_areas_(pixel, asked_, Nearness::ByDepth);
    parts_.clear();
    for (const VisiblePart& part : coverage.parts)
        parts_.push_back({asked_face_[part.face], within_pixel(part.centroid.x),
                          within_pixel(part.centroid.y), part.area});
    return {Division::ExactAreas, parts_, coverage.background};
}

DividedView PixelDivision::by_scanline(PixelIndex pixel, std::span<const Candidate> candidates) {
    asked_.clear();
    for (const Candidate& c : candidates) asked_.push_back(question_.faces[c.face]);
    const auto parts = scanline_lengths_(pixel, asked_);
    parts_.assign(parts.begin(), parts.end());
    for (SeenPart& part : parts_) part.face = candidates[part.face].face;
    return {Division::Scanline, parts_, scanline_lengths_.background()};
}

bool PixelDivision::flagged(PixelIndex pixel, std::span<const Candidate> candidates) const {
    for (const Candidate& c : candidates) {
        const std::uint16_t object = question_.facts[c.face].object;
        const bool conductor = question_.geometry.objects[object].kind == ObjectKind::Conductor;
        const auto outline = question_.faces[c.face].outline;
        for (std::size_t e = 0; e < outline.size(); ++e) {
            if (e < FaceFacts::kMostEdges && (c.inside >> e & 1)) continue;
            const Point p = outline[e], q = outline[e + 1 < outline.size() ? e + 1 : 0];
            const bool near_horizontal =
                std::abs(q.y - p.y) < question_.options.near_horizontal_slope * std::abs(q.x - p.x);
            if ((conductor || near_horizontal) && meets_pixel(p, q, pixel)) return true;
        }
    }
    return false;
}

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#include "tile_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keikan {
namespace {

/// The inner side of an edge, over unit squares: for the pixel with corner (x, y), tile-local, the edge
/// function's least and greatest value are a x + b y + least and a x + b y + greatest, with the rounding
/// error already taken off or put on.
struct EdgeSide {
    double a = 0;
    double b = 0;
    double least = 0;
    double greatest = 0;
};

/// The edge function is a (x - p.x) + b (y - p.y) with a = p.y - q.y, b = q.x - p.x, turned so that the
/// inside is positive. p and q come tile-local; making them so, the differences, the products and the sums
/// round at most six times on any term, so six u of the terms' sizes bound the error; sixteen are taken, so
/// that a bound on x may be worked out from the function as well (row_range).
EdgeSide edge_side(Point p, Point q, double turn) {
    constexpr double kRoundings = 16 * 0x1p-53;
    EdgeSide side;
    side.a = turn * (p.y - q.y);
    side.b = turn * (q.x - p.x);
    const double c = -(side.a * p.x + side.b * p.y);
    // A tile-local coordinate of a pixel's corner is at most kTileSize. Localising p moved it by up to
    // u |p|, and its edge's direction by as much from both ends.
    const double reach = std::abs(p.x) + std::abs(p.y) + std::abs(q.x) + std::abs(q.y) + 2 * kTileSize;
    const double error = kRoundings * (std::abs(side.a) + std::abs(side.b)) * reach +
                         kRoundings * reach * (std::abs(p.x) + std::abs(p.y) + 2 * kTileSize);
    side.least = c + std::min(side.a, 0.0) + std::min(side.b, 0.0) - error;
    side.greatest = c + std::max(side.a, 0.0) + std::max(side.b, 0.0) + error;
    return side;
}

/// Bounds of the face's w over unit squares, in the form of EdgeSide.
EdgeSide nearness_side(const DepthPlane& plane, int x, int y) {
    EdgeSide side;
    side.a = plane.a;
    side.b = plane.b;
    const double c = plane.a * x + plane.b * y + plane.c;
    // Once at the tile's far corner bounds the constant's roundings, once more the sum's.
    const double error = 2 * plane_error(plane, x + kTileSize, y + kTileSize);
    side.least = c + std::min(side.a, 0.0) + std::min(side.b, 0.0) - error;
    side.greatest = c + std::max(side.a, 0.0) + std::max(side.b, 0.0) + error;
    return side;
}

/// Pixels [first, end) along one axis that the closed interval [low, high] meets, tile-local.
struct PixelRange {
    int first = 0;
    int end = 0;
};

PixelRange pixels_met(double low, double high, int pixels) {
    if (!(high >= 0 && low <= pixels)) return {};
    // Clamped before the conversion, which must not overflow and then rounds towards zero, that is down. A
    // low end on the border between two pixels meets both.
    const double from = std::max(low, 0.0);
    const int first = static_cast<int>(from);
    const int last = static_cast<int>(std::min(high, pixels - 1.0));
    return {first > 0 && first == from ? first - 1 : first, last + 1};
}

/// Of the pixels [xs.first, xs.end) of row y, those that no edge excludes on its own: where
/// a x + (b y + greatest) >= 0 for every edge. The quotient rounds four times more than the function itself,
/// which `greatest` allows for. `inverse` is -1/a for each edge.
PixelRange row_range(std::span<const EdgeSide> sides, std::span<const double> inverse, PixelRange xs, int y) {
    double low = xs.first, high = xs.end - 1;
    for (std::size_t e = 0; e < sides.size(); ++e) {
        const double bound = (sides[e].b * y + sides[e].greatest) * inverse[e];
        if (sides[e].a > 0)
            low = std::max(low, bound);
        else if (sides[e].a < 0)
            high = std::min(high, bound);
    }
    if (!(low <= high)) return {};
    const int first = static_cast<int>(low);
    return {first < low ? first + 1 : first, static_cast<int>(high) + 1};
}

}  // namespace

void TileCandidates::add(Candidate candidate) {
    if (candidate.covers)
        nearest_cover_[candidate.pixel] = std::max(nearest_cover_[candidate.pixel], candidate.w_min);
    found_.push_back(candidate);
}

template <std::size_t kEdges>
void TileCandidates::look_at_convex(const FaceView& face, const FaceFacts& facts, std::uint32_t index) {
    // kEdges is 3 for triangles, which are nearly all faces, and whose loop is then unrolled; 0 for others.
    const std::size_t n = kEdges != 0 ? kEdges : face.outline.size();
    std::array<EdgeSide, FaceFacts::kMostEdges> side;
    const unsigned all = (1u << n) - 1;
    Point q{face.outline[0].x - x_, face.outline[0].y - y_};
    for (std::size_t e = 0; e < n; ++e) {
        const Point& corner = face.outline[e + 1 < n ? e + 1 : 0];
        const Point p = q;
        q = {corner.x - x_, corner.y - y_};
        side[e] = edge_side(p, q, facts.turn);
    }
    const EdgeSide w = nearness_side(face.depth, x_, y_);
    const PixelRange xs = pixels_met(facts.left - x_, facts.right - x_, columns_);
    const PixelRange ys = pixels_met(facts.top - y_, facts.bottom - y_, rows_);
    std::array<double, FaceFacts::kMostEdges> inverse;
    for (std::size_t e = 0; e < n; ++e) inverse[e] = -1 / side[e].a;
    for (int y = ys.first; y < ys.end; ++y) {
        const PixelRange row = row_range(std::span(side).first(n), std::span(inverse).first(n), xs, y);
        for (int x = row.first; x < row.end; ++x) {
            unsigned inside = 0;
            bool met = true;
            for (std::size_t e = 0; e < n; ++e) {
                const double at = side[e].a * x + side[e].b * y;
                met &= at + side[e].greatest >= 0;
                inside |= static_cast<unsigned>(at + side[e].least >= 0) << e;
            }
            if (!met) continue;
            const double at = w.a * x + w.b * y;
            add({std::max(at + w.least, facts.w_min), std::min(at + w.greatest, facts.w_max), index,
                 static_cast<std::uint16_t>(y * kTileSize + x), static_cast<std::uint8_t>(inside),
                 inside == all});
        }
    }
}

void TileCandidates::look_at_box(const FaceView& face, const FaceFacts& facts, std::uint32_t index) {
    const EdgeSide w = nearness_side(face.depth, x_, y_);
    const PixelRange xs = pixels_met(facts.left - x_, facts.right - x_, columns_);
    const PixelRange ys = pixels_met(facts.top - y_, facts.bottom - y_, rows_);
    for (int y = ys.first; y < ys.end; ++y)
        for (int x = xs.first; x < xs.end; ++x) {
            const double at = w.a * x + w.b * y;
            add({std::max(at + w.least, facts.w_min), std::min(at + w.greatest, facts.w_max), index,
                 static_cast<std::uint16_t>(y * kTileSize + x), 0, false});
        }
}

void TileCandidates::keep_what_may_be_seen() {
    // Sorted by pixel: count, then fill; within a pixel the faces keep rising.
    begin_.fill(0);
    const auto hidden = [&](const Candidate& c) { return c.w_max < nearest_cover_[c.pixel]; };
    for (const Candidate& c : found_)
        if (!hidden(c)) ++begin_[c.pixel + 1u];
    for (std::size_t p = 0; p < kPixels; ++p) begin_[p + 1] += begin_[p];
    kept_.resize(begin_[kPixels]);
    std::array<std::uint32_t, kPixels> place;
    std::copy(begin_.begin(), begin_.end() - 1, place.begin());
    for (const Candidate& c : found_)
        if (!hidden(c)) kept_[place[c.pixel]++] = c;
}

void TileCandidates::look(const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
                          std::span<const std::uint32_t> tile, int x, int y, int columns, int rows) {
    x_ = x;
    y_ = y;
    columns_ = columns;
    rows_ = rows;
    found_.clear();
    nearest_cover_.fill(-std::numeric_limits<double>::infinity());
    for (const std::uint32_t f : tile) {
        if (facts[f].turn == 0)
            look_at_box(faces[f], facts[f], f);
        else if (facts[f].corners == 3)
            look_at_convex<3>(faces[f], facts[f], f);
        else
            look_at_convex<0>(faces[f], facts[f], f);
    }
    keep_what_may_be_seen();
}

}  // namespace keikan

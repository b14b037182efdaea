// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "keikan/scan/projected_faces.hpp"

namespace keikan {

/// What the scan asks of a face again and again, worked out once.
struct FaceFacts {
    double left = 0, top = 0, right = 0, bottom = 0;  ///< bounding box of the outline
    double w_min = 0, w_max = 0;  ///< its depth plane over the outline stays within these, rounding included
    std::uint16_t object = 0;
    std::uint16_t corners = 0;
    /// The outline turns one way at every corner (exactly), so it is what the half-planes of its edges have
    /// in common: +1 from +x towards +y, -1 the other way. 0: rounding left it concave or with a straight
    /// corner, or it has more than kMostEdges edges; then only its bounding box may be relied upon.
    std::int16_t turn = 0;
    static constexpr std::uint16_t kMostEdges = 8;
};

/// How far a x + b y + c, worked out as (a x + b y) + c, may be from the plane's exact value: two roundings
/// on each product's way, one on c's, so 3 u (|a x| + |b y| + |c|) with u = 2^-53; the fourth u covers the
/// terms of second order.
inline double plane_error(const DepthPlane& plane, double x, double y) {
    constexpr double kFourRoundings = 4 * 0x1p-53;
    const auto size = [](double v) { return v < 0 ? -v : v; };
    return kFourRoundings * (size(plane.a * x) + size(plane.b * y) + size(plane.c));
}

/// Facts of all faces, one for each.
std::vector<FaceFacts> face_facts(const ProjectedFaces& faces, const Geometry& geometry);

/// For each edge (at the place of its first corner in `ProjectedFaces::points`): the one face that has the
/// same edge the other way round, with the same doubles and the same turn, so that the two lie side by side;
/// or kOpen. An edge of three or more faces is open, and so is every edge of a face with turn 0.
struct FaceNeighbours {
    static constexpr std::uint32_t kOpen = 0xFFFFFFFFu;
    std::vector<std::uint32_t> across;
};

FaceNeighbours face_neighbours(const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
                               const Geometry& geometry);

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#include "face_facts.hpp"

#include <algorithm>

#include "keikan/clip/orient2d.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/parallel.hpp"

namespace keikan {
namespace {

/// The common sign of all corners of a strictly convex outline, 0 where it is none.
std::int16_t strict_turn(std::span<const Point> outline) {
    const std::size_t n = outline.size();
    if (n > FaceFacts::kMostEdges) return 0;
    const Sign first = orient2d(outline[0], outline[1], outline[2]);
    if (n == 3 || first == Sign::Zero) return static_cast<std::int16_t>(first);
    // Corners that all turn one way could still wind twice; a fan whose triangles agree as well cannot.
    for (std::size_t i = 1; i < n; ++i) {
        if (orient2d(outline[i], outline[(i + 1) % n], outline[(i + 2) % n]) != first) return 0;
        if (i + 1 < n && orient2d(outline[0], outline[i], outline[i + 1]) != first) return 0;
    }
    return static_cast<std::int16_t>(first);
}

FaceFacts facts_of(const FaceView& face) {
    FaceFacts facts;
    const Point first = face.outline[0];
    facts.left = facts.right = first.x;
    facts.top = facts.bottom = first.y;
    bool one = false;
    for (const Point p : face.outline) {
        facts.left = std::min(facts.left, p.x);
        facts.right = std::max(facts.right, p.x);
        facts.top = std::min(facts.top, p.y);
        facts.bottom = std::max(facts.bottom, p.y);
        const double w = face.depth.a * p.x + face.depth.b * p.y + face.depth.c;
        const double error = plane_error(face.depth, p.x, p.y);
        facts.w_min = one ? std::min(facts.w_min, w - error) : w - error;
        facts.w_max = one ? std::max(facts.w_max, w + error) : w + error;
        one = true;
    }
    facts.corners = static_cast<std::uint16_t>(std::min<std::size_t>(face.outline.size(), 0xFFFF));
    facts.turn = strict_turn(face.outline);
    return facts;
}

/// An edge of a face, on its way to be matched.
struct Edge {
    std::uint32_t far_corner = 0;  ///< the larger of its two corners, in the numbering of all meshes
    std::uint32_t place = 0;       ///< of its first corner in ProjectedFaces::points
    std::uint32_t face = 0;
};

}  // namespace

std::vector<FaceFacts> face_facts(const ProjectedFaces& faces, const Geometry& geometry) {
    KEIKAN_CHECK(geometry.objects.size() <= 0xFFFF, "more than 65535 objects");
    std::vector<FaceFacts> facts(faces.size());
    parallel_ranges(faces.size(), 4096, [&](std::size_t begin, std::size_t end) {
        const auto after =
            std::upper_bound(geometry.first_face.begin(), geometry.first_face.end(), faces.id[begin]);
        auto object = static_cast<std::size_t>(after - geometry.first_face.begin()) - 1;
        for (std::size_t f = begin; f < end; ++f) {
            while (faces.id[f] >= geometry.first_face[object + 1]) ++object;
            facts[f] = facts_of(faces[f]);
            facts[f].object = static_cast<std::uint16_t>(object);
        }
    });
    return facts;
}

FaceNeighbours face_neighbours(const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
                               const Geometry& geometry) {
    std::vector<std::uint32_t> first_corner(geometry.objects.size() + 1, 0);
    for (std::size_t o = 0; o < geometry.objects.size(); ++o)
        first_corner[o + 1] =
            first_corner[o] + static_cast<std::uint32_t>(geometry.objects[o].mesh.positions.size());

    // Edges in buckets by their smaller corner: count, then fill.
    const auto for_each_edge = [&](const auto& visit) {
        for (std::uint32_t f = 0; f < faces.size(); ++f) {
            const FaceFacts& face = facts[f];
            if (face.turn == 0) continue;
            const std::size_t o = face.object;
            const auto corners = geometry.objects[o].mesh.face(faces.id[f] - geometry.first_face[o]);
            if (corners.size() != face.corners) continue;  // cut by the near plane: the corners are others
            for (std::uint32_t k = 0; k < face.corners; ++k) {
                const std::uint32_t from = first_corner[o] + corners[k];
                const std::uint32_t to = first_corner[o] + corners[k + 1u < face.corners ? k + 1u : 0u];
                visit(f, k, std::min(from, to), std::max(from, to));
            }
        }
    };
    std::vector<std::uint32_t> bucket(first_corner.back() + 1u, 0);
    for_each_edge(
        [&](std::uint32_t, std::uint32_t, std::uint32_t near, std::uint32_t) { ++bucket[near + 1]; });
    for (std::size_t b = 1; b < bucket.size(); ++b) bucket[b] += bucket[b - 1];
    std::vector<Edge> edges(bucket.back());
    for_each_edge([&](std::uint32_t f, std::uint32_t k, std::uint32_t near, std::uint32_t far) {
        edges[bucket[near]++] = {far, faces.begin[f] + k, f};
    });

    // bucket[b] is now the end of bucket b. Two edges match when both ends are the same doubles, crosswise:
    // checked on the image itself, so that nothing rests on the numbering.
    FaceNeighbours neighbours;
    neighbours.across.assign(faces.points.size(), FaceNeighbours::kOpen);
    const auto end_of = [&](const Edge& e) {
        return faces.points[e.place + 1 < faces.begin[e.face + 1] ? e.place + 1 : faces.begin[e.face]];
    };
    const auto match_bucket = [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
            std::uint32_t same = 0, other = 0;
            for (std::uint32_t j = begin; j < end; ++j)
                if (j != i && edges[j].far_corner == edges[i].far_corner) ++same, other = j;
            if (same != 1) continue;
            const Edge &mine = edges[i], &theirs = edges[other];
            if (facts[mine.face].turn == facts[theirs.face].turn &&
                faces.points[mine.place] == end_of(theirs) && faces.points[theirs.place] == end_of(mine))
                neighbours.across[mine.place] = theirs.face;
        }
    };
    parallel_ranges(bucket.size() - 1, 4096, [&](std::size_t first, std::size_t last) {
        for (std::size_t b = first; b < last; ++b) match_bucket(b == 0 ? 0 : bucket[b - 1], bucket[b]);
    });
    return neighbours;
}

}  // namespace keikan

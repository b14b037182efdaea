// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "keikan/scene/mesh.hpp"

// What can be said of any mesh, for tests of the generators.
namespace keikan {

/// Twice the area vector of a polygon, from its first corner.
inline glm::dvec3 doubled_area(const Mesh& mesh, std::span<const std::uint32_t> face) {
    const glm::dvec3 origin = mesh.positions[face[0]];
    glm::dvec3 area{0, 0, 0};
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        area += glm::cross(mesh.positions[face[i]] - origin, mesh.positions[face[i + 1]] - origin);
    return area;
}

/// The largest distance of a corner from its face's plane (through the corners' mean, across the area
/// vector).
inline double largest_distance_from_plane(const Mesh& mesh) {
    double largest = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        const glm::dvec3 normal = glm::normalize(doubled_area(mesh, face));
        glm::dvec3 mean{0, 0, 0};
        for (const auto corner : face) mean += mesh.positions[corner] / double(face.size());
        for (const auto corner : face)
            largest = std::max(largest, std::abs(glm::dot(mesh.positions[corner] - mean, normal)));
    }
    return largest;
}

/// The smallest turn at a corner of any face, as the sine of the angle: positive for strictly convex faces.
inline double smallest_turn(const Mesh& mesh) {
    double smallest = 1;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        const glm::dvec3 normal = glm::normalize(doubled_area(mesh, face));
        for (std::size_t i = 0; i < face.size(); ++i) {
            const glm::dvec3 a = mesh.positions[face[i]], b = mesh.positions[face[(i + 1) % face.size()]],
                             c = mesh.positions[face[(i + 2) % face.size()]];
            smallest = std::min(smallest,
                                glm::dot(glm::cross(glm::normalize(b - a), glm::normalize(c - b)), normal));
        }
    }
    return smallest;
}

/// Edges that do not belong to exactly two faces, which run along it in opposite directions.
inline std::size_t open_edges(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> runs;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i) ++runs[{face[i], face[(i + 1) % face.size()]}];
    }
    std::size_t open = 0;
    for (const auto& [edge, count] : runs) {
        const auto back = runs.find({edge.second, edge.first});
        if (count != 1 || back == runs.end() || back->second != 1) ++open;
    }
    return open;
}

/// Six times the volume of each part that hangs together by its vertices: positive where faces look out.
inline std::vector<double> sixfold_volumes(const Mesh& mesh) {
    std::vector<std::uint32_t> parent(mesh.positions.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t v) {
        while (parent[v] != v) v = parent[v] = parent[parent[v]];
        return v;
    };
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (const auto corner : mesh.face(f)) parent[root(corner)] = root(mesh.face(f)[0]);
    std::map<std::uint32_t, double> volumes;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        const std::uint32_t part = root(face[0]);
        const glm::dvec3 origin = mesh.positions[part];  // near: a volume of millilitres 1 km from the origin
        volumes[part] += glm::dot(mesh.positions[face[0]] - origin, doubled_area(mesh, face));
    }
    std::vector<double> result;
    for (const auto& [part, volume] : volumes) result.push_back(volume);
    return result;
}

/// True where every face names existing vertices, has three or more, and the arrays belong together.
inline bool is_well_formed(const Mesh& mesh) {
    if (mesh.face_begin.empty() || mesh.face_begin.front() != 0 ||
        mesh.face_begin.back() != mesh.corners.size())
        return false;
    if (mesh.face_material.size() != mesh.face_count()) return false;
    if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size()) return false;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (mesh.face(f).size() < 3) return false;
        for (const auto corner : mesh.face(f))
            if (corner >= mesh.positions.size()) return false;
    }
    return std::all_of(mesh.positions.begin(), mesh.positions.end(), [](glm::dvec3 p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
}

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
};

inline Box bounding_box(const Mesh& mesh) {
    Box box;
    for (const glm::dvec3& p : mesh.positions) {
        box.low = glm::min(box.low, p);
        box.high = glm::max(box.high, p);
    }
    return box;
}

}  // namespace keikan

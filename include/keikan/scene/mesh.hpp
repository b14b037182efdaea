// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace keikan {

/// Convex planar faces in world coordinates [m], z up. Face f has the corners
/// corners[face_begin[f]] ... corners[face_begin[f + 1] - 1], indices into `positions`.
struct Mesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;  ///< empty: flat shading; else one for each position
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> face_begin{0};  ///< faces + 1 values
    std::vector<std::uint16_t> face_material;  ///< one for each face: index into Scene::materials
    /// The faces bound a solid, counter-clockwise seen from outside: back faces cannot be seen.
    bool closed = false;

    std::size_t face_count() const { return face_begin.size() - 1; }
    std::span<const std::uint32_t> face(std::size_t f) const {
        return std::span(corners).subspan(face_begin[f], face_begin[f + 1] - face_begin[f]);
    }
    std::uint32_t add_position(glm::dvec3 p) {
        positions.push_back(p);
        return static_cast<std::uint32_t>(positions.size() - 1);
    }
    void add_face(std::span<const std::uint32_t> face_corners, std::uint16_t material) {
        corners.insert(corners.end(), face_corners.begin(), face_corners.end());
        face_begin.push_back(static_cast<std::uint32_t>(corners.size()));
        face_material.push_back(material);
    }
};

/// What a mesh stands for; decides what the paper's extraction rule (2.1) flags.
enum class ObjectKind : std::uint8_t { Terrain, Tower, Insulator, Conductor, Building, Model, Water };

/// A named part of the landscape: the unit of object ids and of ground-truth coverage.
struct Object {
    std::string name;
    ObjectKind kind = ObjectKind::Model;
    Mesh mesh;
};

/// Everything that can be seen, as faces. The face with FaceId first_face[o] + f is face f of object o.
struct Geometry {
    std::vector<Object> objects;
    std::vector<std::uint32_t> first_face;  ///< objects + 1 values; the last is the number of faces
    std::vector<std::string> notes;  ///< worth telling: voids filled, faces triangulated, levels of detail
};

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "keikan/scene/mesh.hpp"

namespace keikan {

/// Where a mesh from a file goes: scaled, stood upright, turned, then moved.
struct MeshPlacement {
    glm::dvec3 position_m{0, 0, 0};
    double yaw_rad = 0;  ///< about the world's z, positive from x towards y
    double scale = 1;    ///< metres per unit of the file
    bool y_up = true;    ///< the file's y is up (glTF always, OBJ usually): (x, y, z) becomes (x, -z, y)
};

struct LoadedMesh {
    Mesh mesh;                                ///< not closed: a file promises nothing
    std::vector<std::string> file_materials;  ///< names met, in the order of first use
    std::size_t faces_in_file = 0;            ///< polygons with area
    std::size_t not_planar = 0;               ///< of these, triangulated because they are not planar ...
    std::size_t concave = 0;                  ///< ... or planar and not convex
    std::size_t without_area = 0;             ///< left out: points, lines, and polygons without area

    /// One line for the scene's notes.
    std::string note(const std::string& name) const;
};

/// Reads OBJ (with its materials), PLY, or glTF 2 (.gltf, .glb). Polygons stay polygons where they are planar
/// (kFilePlanarity) and convex; others are triangulated (a polygon that crosses itself, as a fan). Corners on
/// the same spot become one vertex, so that faces share their edges; shading is flat. `material_of` maps a
/// material's name in the file ("" if it has none) to an index into Scene::materials.
///
/// Errors: InputError with the file and the reason: not there, not readable, empty, a coordinate that is not
///         finite; and whatever `material_of` throws.
LoadedMesh read_mesh_file(const std::filesystem::path& file, const MeshPlacement& placement,
                          const std::function<std::uint16_t(const std::string& file_material)>& material_of);

/// A polygon counts as planar if every corner is within this share of its distance from the file's origin of
/// the polygon's mean plane. Formats and Assimp keep coordinates in float: each of a corner's three
/// coordinates is off by up to 2^-25 of that distance (half a unit in the last place), and exporters round
/// once or twice more: 4 is granted for it. Such a face keeps its corners, shared with its neighbours; its
/// depth plane then errs by no more.
inline constexpr double kFilePlanarity = 4 * 1.7320508075688772 / (1 << 25);

}  // namespace keikan

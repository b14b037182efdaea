// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "keikan/scene/scene.hpp"
#include "keikan/scene/terrain.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"
#include "scene_document.hpp"

namespace keikan {

Geometry build_geometry(const Scene& scene) {
    KEIKAN_CHECK(scene.document, "a scene without a document");
    const std::string file = scene.file.string();
    const GeometryBlocks blocks = read_geometry_blocks(*scene.document, file, scene.materials);
    Geometry geometry;
    if (blocks.terrain) {
        const HeightGrid grid = read_terrain_grid(*blocks.terrain, file);
        geometry.objects.push_back(
            {blocks.terrain->name, ObjectKind::Terrain, terrain_mesh(grid, blocks.terrain->material)});
        if (grid.voids_filled > 0) {
            geometry.notes.push_back(fmt::format("{}: {} voids filled from the nearest heights in eight directions",
                                                 blocks.terrain->name, grid.voids_filled));
        }
    }
    geometry.first_face.push_back(0);
    for (const Object& object : geometry.objects) {
        geometry.first_face.push_back(geometry.first_face.back() +
                                      static_cast<std::uint32_t>(object.mesh.face_count()));
    }
    return geometry;
}

std::string describe(const Scene& scene, const Geometry& geometry) {
    return fmt::format("{}: {} objects, {} faces\n", scene.file.string(), geometry.objects.size(),
                       geometry.first_face.back());
}

}  // namespace keikan

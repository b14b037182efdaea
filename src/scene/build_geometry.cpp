// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <limits>

#include "build_objects.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/scene/terrain.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"
#include "scene_document.hpp"

namespace keikan {
namespace {

void add_terrain(const TerrainBlock& block, const HeightGrid& grid, Geometry& geometry) {
    geometry.objects.push_back({block.name, ObjectKind::Terrain, terrain_mesh(grid, block.material)});
    const glm::dvec2 north_east = grid.point(grid.columns - 1, grid.rows - 1);
    geometry.notes.push_back(
        fmt::format("{}: {} x {} samples, {:g} x {:g} m apart, x {:.1f} to {:.1f}, y {:.1f} to {:.1f} m",
                    block.name, grid.columns, grid.rows, grid.spacing_m.x, grid.spacing_m.y,
                    grid.south_west_m.x, north_east.x, grid.south_west_m.y, north_east.y));
    if (grid.voids_filled > 0) {
        geometry.notes.push_back(
            fmt::format("{}: {} voids filled from the nearest heights in the eight directions of the compass",
                        block.name, grid.voids_filled));
    }
}

void number_faces(Geometry& geometry, const std::string& file) {
    std::size_t count = 0;
    geometry.first_face.assign(1, 0);
    for (const Object& object : geometry.objects) {
        count += object.mesh.face_count();
        if (count > std::numeric_limits<std::uint32_t>::max())
            throw InputError(file, "", "has more than 2^32 faces");
        geometry.first_face.push_back(static_cast<std::uint32_t>(count));
    }
}

}  // namespace

Geometry build_geometry(const Scene& scene) {
    KEIKAN_CHECK(scene.document, "a scene without a document");
    const std::string file = scene.file.string();
    const GeometryBlocks blocks = read_geometry_blocks(*scene.document, file, scene.materials);
    Geometry geometry;
    std::optional<HeightGrid> grid;
    if (blocks.terrain) {
        grid = read_terrain_grid(*blocks.terrain, file);
        add_terrain(*blocks.terrain, *grid, geometry);
    }
    const Ground ground(grid ? &*grid : nullptr);
    for (const ObjectBlock& block : blocks.objects) {
        try {
            build_object(block, ground, scene.camera, geometry);
        } catch (const InputError& error) {
            throw InputError(file, block.path, error.what());
        }
    }
    number_faces(geometry, file);
    return geometry;
}

}  // namespace keikan

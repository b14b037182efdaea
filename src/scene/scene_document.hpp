// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "keikan/scene/scene.hpp"
#include "read_objects.hpp"
#include "scene_blocks.hpp"

namespace keikan {

/// The blocks of a scene that faces are made from.
struct GeometryBlocks {
    std::optional<TerrainBlock> terrain;
    std::vector<ObjectBlock> objects;
};

/// Reads and validates "terrain" and "objects". Nothing is built, and no named file opened but the frames
/// beside height grids.
GeometryBlocks read_geometry_blocks(const nlohmann::json& document, const std::string& file,
                                    const std::vector<Material>& materials);

/// The files whose contents decide what is built, in the order of the blocks that name them; also those that
/// they name themselves (the buffers of a .gltf).
std::vector<std::filesystem::path> geometry_files(const GeometryBlocks& blocks);

/// See Scene::geometry_hash. `size` is that of the picture, whatever the document says.
std::uint64_t geometry_hash(const nlohmann::json& document, ImageSize size, const GeometryBlocks& blocks);

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "json_node.hpp"
#include "keikan/scene/camera.hpp"
#include "keikan/scene/height_grid.hpp"
#include "keikan/scene/material.hpp"
#include "keikan/scene/water.hpp"

namespace keikan {

// One reader for each block of a scene file. Each throws an InputError that names file, JSON path and reason.

/// Height of the ground over (x, y); nothing where there is no terrain.
using TerrainHeight = std::function<std::optional<double>(double x, double y)>;

/// Materials by name; what other blocks name has to be among them.
class MaterialNames {
  public:
    explicit MaterialNames(const std::vector<Material>& materials) : materials_(materials) {}
    std::uint16_t index_of(const JsonNode& name) const;

  private:
    const std::vector<Material>& materials_;
};

struct TerrainBlock {
    std::string name;
    std::filesystem::path grid_file;
    std::optional<std::filesystem::path> frame_file;  ///< the side-car, where the frame comes from one
    std::optional<GridFrame> frame;
    GridWindow window;
    std::uint16_t material = 0;
    std::string path;  ///< JSON path, for errors that show only while building
};

ImageSize read_image_size(const JsonNode& node);
Camera read_camera(const JsonNode& node, ImageSize size, const TerrainHeight& ground);
Light read_light(const JsonNode& node);
Background read_background(const JsonNode& node);
Haze read_haze(const JsonNode& node);
/// Sorted by name.
std::vector<Material> read_materials(const JsonNode& node);
TerrainBlock read_terrain_block(const JsonNode& node, const std::filesystem::path& folder,
                                const MaterialNames& materials);
/// The "surface" of water whose mean plane is at `level_m`.
WaterSurface read_water_surface(const JsonNode& node, double level_m);
/// The frame of a height grid, as a side-car file or a scene states it.
GridFrame read_grid_frame(const JsonNode& node);

/// The file that a scene names, relative to the scene's folder. Errors: it is not there.
std::filesystem::path named_file(const JsonNode& node, const std::filesystem::path& folder);

/// The grid of a terrain, voids filled, cut to its window.
HeightGrid read_terrain_grid(const TerrainBlock& block, const std::string& scene_file);

}  // namespace keikan

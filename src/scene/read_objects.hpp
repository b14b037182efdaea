// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "keikan/scene/building.hpp"
#include "keikan/scene/lattice_tower.hpp"
#include "keikan/scene/mesh_file.hpp"
#include "keikan/scene/power_line.hpp"
#include "keikan/scene/water.hpp"
#include "scene_blocks.hpp"

namespace keikan {

/// A height that a scene gives in the world, or relative to the ground below.
struct HeightAboveGround {
    double metres = 0;
    bool above_ground = true;  ///< else above z = 0
};

struct TowerBlock {
    TowerDesign design;
    TowerMaterials materials;
    glm::dvec2 place{0, 0};
    HeightAboveGround base;
    double yaw_rad = 0;
    std::optional<TowerDetail> detail;
};

struct PowerLineBlock {
    PowerLineDesign design;
};

struct BuildingBlock {
    BuildingDesign design;
    BuildingMaterials materials;
    std::optional<double>
        floor_m;  ///< none: on the highest ground along the footprint, walls down to the lowest
};

struct MeshBlock {
    std::filesystem::path file;
    MeshPlacement placement;
    HeightAboveGround base;
    std::uint16_t material = 0;  ///< for what `material_of` does not name
    std::map<std::string, std::uint16_t> material_of;
};

struct WaterBlock {
    std::vector<glm::dvec2> outline_m;
    double level_m = 0;
    std::uint16_t material = 0;
    std::optional<WaterSurface> surface;  ///< none: flat colour
};

/// One item of "objects".
struct ObjectBlock {
    std::string name;
    std::string path;  ///< JSON path, for errors that show only while building
    std::variant<TowerBlock, PowerLineBlock, BuildingBlock, MeshBlock, WaterBlock> block;
};

/// Reads and validates "objects"; builds nothing.
std::vector<ObjectBlock> read_objects(const JsonNode& node, const std::filesystem::path& folder,
                                      const MaterialNames& materials);

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "keikan/scene/lattice_tower.hpp"
#include "prism_parts.hpp"
#include "tower_shape.hpp"

namespace keikan {

/// What of a tower is steel, piece by piece, in the tower's own frame.
struct TowerSteel {
    Mesh mesh;
    std::size_t members = 0;
    std::size_t secondary = 0;
    std::size_t panels = 0;
};

/// Legs, bracing, diaphragms, cross-arms, peak and foundations.
TowerSteel tower_steel(const TowerDesign& design, const TowerShape& shape, const TowerStand& stand,
                       const TowerMaterials& materials);

}  // namespace keikan

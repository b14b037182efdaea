// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <glm/vec2.hpp>

#include "keikan/scene/lattice_tower.hpp"

namespace keikan {

/// Four feet that reach the ground: the base plane passes through the highest, each leg goes on along its own
/// slope, which moves the foot outwards, until it meets the ground. Errors: whatever `ground` throws.
TowerStand stand_on_ground(const TowerDesign& design, glm::dvec2 place, double yaw_rad,
                           const std::function<double(double x_m, double y_m)>& ground);

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "keikan/scene/lattice_tower.hpp"

namespace keikan {

/// Where the nodes of a tower's body are, in its own frame: x along the arms, y along the line, z up from the
/// base plane. A body is three truncated pyramids on top of each other: legs, cage, peak.
class TowerShape {
  public:
    /// Errors: InputError, for a design that cannot stand.
    explicit TowerShape(const TowerDesign& design);

    double waist_m() const { return arm_m(0); }  ///< lower chord of the lowest arms
    double arm_m(int arm) const;                 ///< lower chord of arm 0, 1, 2
    double cage_top_m() const { return arm_m(2) + design_.arm_depth_m; }
    bool has_ground_arms() const { return design_.ground_arm_m > 0; }
    double ground_arm_depth_m() const { return 0.6 * design_.arm_depth_m; }

    double half_width(double z) const;  ///< of the square of the leg axes; below the base plane too
    double leg_width(double z) const;   ///< of the angle steel
    double brace_width(double z) const;
    /// The axis of leg 0..3 (-x-y, +x-y, +x+y, -x+y) at height z.
    glm::dvec3 node(int leg, double z) const;

    /// Heights between panels of the legs, falling: waist first, top of the leg panel last. Panels are as
    /// tall as they are wide, about, so they grow downwards in a geometric row that ends exactly on the base
    /// plane.
    const std::vector<double>& leg_levels() const { return leg_levels_; }
    /// Heights between panels of cage and peak, rising, waist first.
    const std::vector<double>& cage_levels() const { return cage_levels_; }

  private:
    TowerDesign design_;
    std::vector<double> leg_levels_;
    std::vector<double> cage_levels_;
};

}  // namespace keikan

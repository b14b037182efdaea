// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "keikan/scene/camera.hpp"
#include "keikan/scene/height_grid.hpp"
#include "keikan/scene/mesh.hpp"
#include "read_objects.hpp"

namespace keikan {

/// What objects stand on: the triangles of the terrain, or the plane z = 0 where the scene has none.
class Ground {
  public:
    explicit Ground(const HeightGrid* grid) : grid_(grid) {}
    /// NaN beside the terrain, as GroundHeight (power_line.hpp) wants it.
    double height_or_nan(double x, double y) const;
    /// Errors: InputError (reason only) beside the terrain.
    double height(double x, double y) const;

  private:
    const HeightGrid* grid_;
};

/// Builds one item of "objects" and appends what it is made of.
///
/// Errors: InputError (reason only; the caller knows the place).
void build_object(const ObjectBlock& block, const Ground& ground, const Camera& camera, Geometry& geometry);

}  // namespace keikan

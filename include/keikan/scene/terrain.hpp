// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>

#include "keikan/scene/height_grid.hpp"
#include "keikan/scene/mesh.hpp"

namespace keikan {

/// The ground as triangles: two for every cell of the grid, which share vertices with their neighbours.
///
/// Properties:
///   (1) The vertices are the samples, bit for bit, row by row from the south; 2 (c - 1) (r - 1) faces,
///       counter-clockwise seen from above, cell by cell in the same order.
///   (2) A cell is divided along the diagonal whose ends differ less in height (the one from south-west to
///       north-east when they are equal), so that ridges and valleys are not cut across.
///   (3) Normals are those of central differences of the samples, one-sided at the border.
Mesh terrain_mesh(const HeightGrid& grid, std::uint16_t material);

/// Height of that surface over (x, y): on its triangles, not of a smooth guess between the samples.
/// Nothing outside the grid.
///
/// Error: rounding only: within 4 units in the last place of the cell's greatest height.
std::optional<double> height_at(const HeightGrid& grid, double x, double y);

}  // namespace keikan

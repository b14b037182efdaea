// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

namespace keikan::fuzz {

/// Column and row of a small grid.
struct GridPlace {
    int x = 0, y = 0;
};
/// Strictly convex, turning from +x towards +y.
using GridPolygon = std::vector<GridPlace>;

/// All triangles and convex quadrilaterals with corners on the 3 x 3 grid: 146.
const std::vector<GridPolygon>& polygons_of_3_x_3();
/// All triangles with corners on the 4 x 4 grid: 516.
const std::vector<GridPolygon>& triangles_of_4_x_4();

}  // namespace keikan::fuzz

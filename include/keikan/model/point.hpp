// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

namespace keikan {

/// A point of the image, in pixels: x grows to the right, y grows downwards, and pixel (i, j) is the
/// unit square [i, i+1] x [j, j+1]. Where a header says *pixel-local*, the pixel's own corner with the
/// smallest coordinates is the origin and the square is [0, 1] x [0, 1].
struct Point {
    double x = 0;
    double y = 0;
    friend bool operator==(const Point&, const Point&) = default;
};

/// A closed polygon: its corners in order; the edge from the last to the first is implied.
using Ring = std::vector<Point>;

}  // namespace keikan

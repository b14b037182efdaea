// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/grid_polygons.hpp"

namespace keikan::fuzz {
namespace {

int twice_area(GridPlace a, GridPlace b, GridPlace c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Any three corners of a strictly convex polygon, in its order, turn as it does.
bool is_convex(const GridPolygon& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        for (std::size_t j = i + 1; j < polygon.size(); ++j)
            for (std::size_t k = j + 1; k < polygon.size(); ++k)
                if (twice_area(polygon[i], polygon[j], polygon[k]) <= 0) return false;
    return true;
}

/// Each with its first place as start, so that none is there twice.
std::vector<GridPolygon> polygons_of(int side, bool quads) {
    const int n = side * side;
    const auto place = [side](int i) { return GridPlace{i % side, i / side}; };
    std::vector<GridPolygon> polygons;
    const auto add = [&polygons](const GridPolygon& polygon) {
        if (is_convex(polygon)) polygons.push_back(polygon);
    };
    for (int a = 0; a < n; ++a)
        for (int b = a + 1; b < n; ++b)
            for (int c = a + 1; c < n; ++c) {
                add({place(a), place(b), place(c)});
                for (int d = a + 1; quads && d < n; ++d) add({place(a), place(b), place(c), place(d)});
            }
    return polygons;
}

}  // namespace

const std::vector<GridPolygon>& polygons_of_3_x_3() {
    static const std::vector<GridPolygon> polygons = polygons_of(3, true);
    return polygons;
}

const std::vector<GridPolygon>& triangles_of_4_x_4() {
    static const std::vector<GridPolygon> polygons = polygons_of(4, false);
    return polygons;
}

}  // namespace keikan::fuzz

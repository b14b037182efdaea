// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/terrain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "keikan/support/check.hpp"
#include "keikan/support/parallel.hpp"

namespace keikan {
namespace {

/// The four heights of a cell; south-west first, named by compass.
struct Cell {
    float sw, se, nw, ne;
    bool divided_sw_to_ne() const { return std::abs(sw - ne) <= std::abs(se - nw); }
};

Cell cell_of(const HeightGrid& grid, int column, int row) {
    return {grid.height(column, row), grid.height(column + 1, row), grid.height(column, row + 1),
            grid.height(column + 1, row + 1)};
}

/// Slope along one axis at sample i of n: central difference, one-sided at the ends.
template <typename HeightAt>
float slope(int i, int n, double spacing, const HeightAt& height) {
    const int before = std::max(i - 1, 0), after = std::min(i + 1, n - 1);
    return static_cast<float>((static_cast<double>(height(after)) - static_cast<double>(height(before))) /
                              ((after - before) * spacing));
}

glm::vec3 normal_at(const HeightGrid& grid, int column, int row) {
    const float east =
        slope(column, grid.columns, grid.spacing_m.x, [&](int c) { return grid.height(c, row); });
    const float north =
        slope(row, grid.rows, grid.spacing_m.y, [&](int r) { return grid.height(column, r); });
    const float scale = 1 / std::sqrt(east * east + north * north + 1);
    return {-east * scale, -north * scale, scale};
}

void write_row_of_vertices(const HeightGrid& grid, int row, Mesh& mesh) {
    for (int column = 0; column < grid.columns; ++column) {
        const std::size_t i = grid.index(column, row);
        mesh.positions[i] = glm::dvec3(grid.point(column, row), static_cast<double>(grid.heights[i]));
        mesh.normals[i] = normal_at(grid, column, row);
    }
}

void write_row_of_faces(const HeightGrid& grid, int row, Mesh& mesh) {
    const auto cells = static_cast<std::size_t>(grid.columns - 1);
    std::uint32_t* corner = mesh.corners.data() + static_cast<std::size_t>(row) * cells * 6;
    for (int column = 0; column + 1 < grid.columns; ++column) {
        const auto sw = static_cast<std::uint32_t>(grid.index(column, row)), se = sw + 1;
        const auto nw = sw + static_cast<std::uint32_t>(grid.columns), ne = nw + 1;
        const auto six = cell_of(grid, column, row).divided_sw_to_ne() ? std::array{sw, se, ne, sw, ne, nw}
                                                                       : std::array{sw, se, nw, se, ne, nw};
        corner = std::copy(six.begin(), six.end(), corner);
    }
}

}  // namespace

Mesh terrain_mesh(const HeightGrid& grid, std::uint16_t material) {
    KEIKAN_CHECK(grid.columns >= 2 && grid.rows >= 2, "a terrain needs 2 x 2 samples");
    const std::size_t vertices = grid.heights.size();
    const std::size_t faces =
        2 * static_cast<std::size_t>(grid.columns - 1) * static_cast<std::size_t>(grid.rows - 1);
    Mesh mesh;
    mesh.positions.resize(vertices);
    mesh.normals.resize(vertices);
    mesh.corners.resize(faces * 3);
    mesh.face_material.assign(faces, material);
    mesh.face_begin.resize(faces + 1);
    for (std::size_t f = 0; f <= faces; ++f) mesh.face_begin[f] = static_cast<std::uint32_t>(3 * f);
    parallel_ranges(static_cast<std::size_t>(grid.rows), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            write_row_of_vertices(grid, static_cast<int>(row), mesh);
            if (row + 1 < static_cast<std::size_t>(grid.rows))
                write_row_of_faces(grid, static_cast<int>(row), mesh);
        }
    });
    return mesh;
}

std::optional<double> height_at(const HeightGrid& grid, double x, double y) {
    const double u = (x - grid.south_west_m.x) / grid.spacing_m.x;
    const double v = (y - grid.south_west_m.y) / grid.spacing_m.y;
    if (!(u >= 0 && v >= 0 && u <= grid.columns - 1 && v <= grid.rows - 1)) return std::nullopt;
    const int column = std::min(static_cast<int>(u), grid.columns - 2);
    const int row = std::min(static_cast<int>(v), grid.rows - 2);
    const double s = u - column, t = v - row;  // both in [0, 1]
    const Cell cell = cell_of(grid, column, row);
    const double sw = static_cast<double>(cell.sw), se = static_cast<double>(cell.se);
    const double nw = static_cast<double>(cell.nw), ne = static_cast<double>(cell.ne);
    if (cell.divided_sw_to_ne()) {
        return s >= t ? sw + s * (se - sw) + t * (ne - se) : sw + s * (ne - nw) + t * (nw - sw);
    }
    return s + t <= 1 ? sw + s * (se - sw) + t * (nw - sw) : ne + (1 - s) * (nw - ne) + (1 - t) * (se - ne);
}

}  // namespace keikan

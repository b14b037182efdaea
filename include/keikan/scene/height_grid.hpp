// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

namespace keikan {

/// How the numbers of a height grid become metres. Samples are points, not cells: a grid of c columns
/// reaches (c - 1) spacings from west to east.
struct GridFrame {
    glm::dvec2 south_west_m{0, 0};  ///< x (east) and y (north) of the sample in the south-west corner
    glm::dvec2 spacing_m{30, 30};   ///< between columns and between rows, positive
    double height_scale_m = 1;      ///< height = offset + scale * value
    double height_offset_m = 0;
    std::optional<int> void_value;  ///< this value means that the height is unknown
    friend bool operator==(const GridFrame&, const GridFrame&) = default;
};

/// Heights of the ground on a rectangular grid, x east, y north, z up, metres.
struct HeightGrid {
    int columns = 0;
    int rows = 0;
    glm::dvec2 south_west_m{0, 0};
    glm::dvec2 spacing_m{1, 1};
    std::vector<float> heights;    ///< row by row from the south, each row from the west
    std::size_t voids_filled = 0;  ///< samples whose height is a guess (fill_voids)

    float height(int column, int row) const { return heights[index(column, row)]; }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    glm::dvec2 point(int column, int row) const {
        return {south_west_m.x + column * spacing_m.x, south_west_m.y + row * spacing_m.y};
    }
    friend bool operator==(const HeightGrid&, const HeightGrid&) = default;
};

/// The part of a grid that a scene uses: columns [first_column, first_column + columns) and rows likewise,
/// counted from the south-west, every `stride`-th of them. 0 columns or rows: all that are left.
struct GridWindow {
    int first_column = 0;
    int first_row = 0;
    int columns = 0;
    int rows = 0;
    int stride = 1;
    friend bool operator==(const GridWindow&, const GridWindow&) = default;
};

/// Reads a height grid: a 16-bit grey PNG (north up, as maps are), or raw SRTM .hgt (1201 or 3601 samples
/// square, big-endian metres, -32768 for a void). Voids are filled.
///
/// `frame` may be left out for an .hgt file whose name says its place (N36W085.hgt): columns and rows are
/// then taken as equally spaced at the tile's middle latitude on the WGS 84 ellipsoid, the south-west corner
/// at (0, 0). Over one degree the true width of a tile changes (by 1.3 % at 36 degrees north); where that
/// matters, reproject with keikan-import.
///
/// Errors: InputError for a file that cannot be read, is of another kind or size, has no frame, or has no
///         sample but voids.
HeightGrid read_height_grid(const std::filesystem::path& file, const std::optional<GridFrame>& frame);

/// Gives every void (NaN) the mean of the nearest known heights in the eight directions of the compass,
/// weighted by the inverse square of the distance in samples; where all eight see nothing known, the mean of
/// all known heights. Known heights do not change. Returns the number of voids.
///
/// Requires: at least one known height.
std::size_t fill_voids(int columns, int rows, std::vector<float>& heights);

/// The grid that remains of `grid` when only `window` is used.
///
/// Errors: InputError (without file and place) where the window reaches outside or leaves less than 2 x 2.
HeightGrid windowed(const HeightGrid& grid, const GridWindow& window);

}  // namespace keikan

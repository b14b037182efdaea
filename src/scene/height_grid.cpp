// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/height_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "degree.hpp"
#include "grey16_png.hpp"
#include "json_node.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {
namespace {

constexpr int kHgtVoid = -32768;

std::string extension_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// The latitude in the name of an SRTM tile, "N36W085": that of its southern border.
std::optional<int> latitude_in_name(const std::string& stem) {
    const auto digit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(stem[i])) != 0; };
    if (stem.size() < 7 || !digit(1) || !digit(2) || !digit(4) || !digit(5) || !digit(6)) return std::nullopt;
    const char hemisphere = static_cast<char>(std::toupper(static_cast<unsigned char>(stem[0])));
    const char side = static_cast<char>(std::toupper(static_cast<unsigned char>(stem[3])));
    if ((hemisphere != 'N' && hemisphere != 'S') || (side != 'E' && side != 'W')) return std::nullopt;
    const int degrees = 10 * (stem[1] - '0') + (stem[2] - '0');
    return hemisphere == 'N' ? degrees : -degrees;
}

/// Metres in one degree of longitude and of latitude on the WGS 84 ellipsoid.
glm::dvec2 degree_m(double latitude_deg) {
    constexpr double kEquatorRadius = 6378137, kFlattening = 1 / 298.257223563;
    constexpr double kSquaredEccentricity = kFlattening * (2 - kFlattening);
    const double sine = std::sin(latitude_deg * kDegree);
    const double root = std::sqrt(1 - kSquaredEccentricity * sine * sine);
    const double prime_vertical = kEquatorRadius / root;
    const double meridian = kEquatorRadius * (1 - kSquaredEccentricity) / (root * root * root);
    return {kDegree * prime_vertical * std::cos(latitude_deg * kDegree), kDegree * meridian};
}

struct RawGrid {
    int columns = 0;
    int rows = 0;
    std::vector<int> values;  ///< from the north
};

RawGrid read_hgt(const std::string& file) {
    const std::string bytes = file_bytes(file);
    int side = 0;
    for (const int known : {1201, 3601}) {
        if (bytes.size() == static_cast<std::size_t>(known) * static_cast<std::size_t>(known) * 2)
            side = known;
    }
    if (side == 0) {
        throw InputError(
            file, "", fmt::format("{} bytes are neither 1201 x 1201 nor 3601 x 3601 samples", bytes.size()));
    }
    RawGrid grid{side, side, {}};
    grid.values.resize(bytes.size() / 2);
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
        const auto high = static_cast<unsigned char>(bytes[2 * i]),
                   low = static_cast<unsigned char>(bytes[2 * i + 1]);
        grid.values[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(high << 8 | low));
    }
    return grid;
}

RawGrid read_png(const std::string& file) {
    const Grey16 png = read_grey16_png(file);
    return {png.columns, png.rows, std::vector<int>(png.values.begin(), png.values.end())};
}

HeightGrid framed(const RawGrid& raw, const GridFrame& frame) {
    HeightGrid grid{raw.columns, raw.rows, frame.south_west_m, frame.spacing_m, {}, 0};
    grid.heights.resize(raw.values.size());
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const int value = raw.values[grid.index(column, grid.rows - 1 - row)];
            const double height = frame.height_offset_m + frame.height_scale_m * value;
            grid.heights[grid.index(column, row)] = value == frame.void_value
                                                        ? std::numeric_limits<float>::quiet_NaN()
                                                        : static_cast<float>(height);
        }
    }
    return grid;
}

}  // namespace

HeightGrid read_height_grid(const std::filesystem::path& file, const std::optional<GridFrame>& given) {
    const std::string extension = extension_of(file);
    const bool hgt = extension == ".hgt";
    if (!hgt && extension != ".png")
        throw InputError(file.string(), "", "is neither a .hgt nor a .png height grid");
    const RawGrid raw = hgt ? read_hgt(file.string()) : read_png(file.string());
    if (raw.columns < 2 || raw.rows < 2) throw InputError(file.string(), "", "has fewer than 2 x 2 samples");

    GridFrame frame = given.value_or(GridFrame{});
    if (!given) {
        const auto south = hgt ? latitude_in_name(file.stem().string()) : std::nullopt;
        if (!south)
            throw InputError(file.string(), "",
                             "has no frame: neither a side-car .json nor a place in its name");
        frame.spacing_m = degree_m(*south + 0.5) / static_cast<double>(raw.columns - 1);
    }
    if (hgt && !frame.void_value) frame.void_value = kHgtVoid;

    HeightGrid grid = framed(raw, frame);
    if (std::all_of(grid.heights.begin(), grid.heights.end(), [](float h) { return std::isnan(h); })) {
        throw InputError(file.string(), "", "has no sample but voids");
    }
    grid.voids_filled = fill_voids(grid.columns, grid.rows, grid.heights);
    return grid;
}

HeightGrid windowed(const HeightGrid& grid, const GridWindow& window) {
    const int columns_left = grid.columns - window.first_column, rows_left = grid.rows - window.first_row;
    const int wide = window.columns == 0 ? columns_left : window.columns;
    const int high = window.rows == 0 ? rows_left : window.rows;
    if (window.first_column < 0 || window.first_row < 0 || window.stride < 1 || wide > columns_left ||
        high > rows_left) {
        throw InputError(
            fmt::format("the window reaches outside the grid of {} x {} samples", grid.columns, grid.rows));
    }
    HeightGrid part;
    part.columns = (wide - 1) / window.stride + 1;
    part.rows = (high - 1) / window.stride + 1;
    if (wide < 1 || high < 1 || part.columns < 2 || part.rows < 2) {
        throw InputError("the window leaves fewer than 2 x 2 samples");
    }
    part.south_west_m = grid.point(window.first_column, window.first_row);
    part.spacing_m = grid.spacing_m * static_cast<double>(window.stride);
    part.voids_filled = grid.voids_filled;
    part.heights.resize(static_cast<std::size_t>(part.columns) * static_cast<std::size_t>(part.rows));
    for (int row = 0; row < part.rows; ++row) {
        for (int column = 0; column < part.columns; ++column) {
            part.heights[part.index(column, row)] = grid.height(window.first_column + column * window.stride,
                                                                window.first_row + row * window.stride);
        }
    }
    return part;
}

}  // namespace keikan

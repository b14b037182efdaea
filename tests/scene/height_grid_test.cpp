// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/height_grid.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "../support/scratch_folder.hpp"
#include "keikan/support/input_error.hpp"

using namespace keikan;

namespace {

constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();
const std::filesystem::path kHill = std::filesystem::path(KEIKAN_SOURCE_DIR) / "data/terrain/hill.png";

/// An SRTM tile of 1201 x 1201 samples: row r from the north, column c hold `height(c, r)`.
template <typename Height>
std::string hgt(const Height& height) {
    std::string bytes;
    for (int row = 0; row < 1201; ++row) {
        for (int column = 0; column < 1201; ++column) {
            const auto value = static_cast<std::uint16_t>(height(column, row));
            bytes += static_cast<char>(value >> 8);
            bytes += static_cast<char>(value & 255);
        }
    }
    return bytes;
}

}  // namespace

TEST_CASE("fill_voids: a void between two heights takes their mean, weighted by nearness",
          "[scene][terrain]") {
    // One row: 10, void, void, 40. The first void sees 10 at one step and 40 at two: (10 + 40/4) / (1 + 1/4).
    std::vector<float> heights{10, kVoid, kVoid, 40};
    CHECK(fill_voids(4, 1, heights) == 2);
    CHECK(heights == std::vector<float>{10, 16, 34, 40});
}

TEST_CASE("fill_voids: looks in all eight directions", "[scene][terrain]") {
    // Sides are at 1, corners at sqrt 2, so weigh 1 and 1/2: (4 * 2 + 4 * 8 / 2) / 6.
    std::vector<float> heights{8, 2, 8, 2, kVoid, 2, 8, 2, 8};
    CHECK(fill_voids(3, 3, heights) == 1);
    CHECK(heights[4] == Approx(4));
}

TEST_CASE("fill_voids: a void that sees nothing takes the mean of all that is known", "[scene][terrain]") {
    std::vector<float> heights(15, kVoid);
    heights[0] = 3;                          // column 0, row 0 of 5 x 3
    CHECK(fill_voids(5, 3, heights) == 14);  // column 2, row 1 is no queen's move away
    CHECK(heights[7] == 3);
}

TEST_CASE("fill_voids: what is known stays as it is", "[scene][terrain]") {
    std::vector<float> heights{1, 2, 3, 4};
    CHECK(fill_voids(2, 2, heights) == 0);
    CHECK(heights == std::vector<float>{1, 2, 3, 4});
}

TEST_CASE("read_height_grid: a PNG grid stands in its frame, south first", "[scene][terrain]") {
    const HeightGrid grid = read_height_grid(kHill, GridFrame{{-640, -640}, {20, 20}, 0.01, 0, std::nullopt});
    REQUIRE(grid.columns == 65);
    REQUIRE(grid.rows == 65);
    CHECK(grid.point(64, 64) == glm::dvec2(640, 640));
    // The analytic hill of scripts/make_terrain, rounded to a centimetre.
    const auto hill = [](double x, double y) {
        return 60 + 180 * std::exp(-(x * x + 2.25 * y * y) / 90000) +
               12 * std::sin(x / 90) * std::cos(y / 70);
    };
    for (const int column : {0, 13, 32, 64}) {
        for (const int row : {0, 9, 32, 64}) {
            const glm::dvec2 at = grid.point(column, row);
            CHECK(grid.height(column, row) == Approx(hill(at.x, at.y)).margin(0.00502));
        }
    }
}

TEST_CASE("read_height_grid: an SRTM tile is big-endian, north first, and its name says its place",
          "[scene][terrain]") {
    const ScratchFolder folder;
    const auto file =
        folder.write("n36W085.hgt", hgt([](int c, int r) { return c == 3 && r == 1200 ? -32768 : c - r; }));
    const HeightGrid grid = read_height_grid(file, std::nullopt);
    CHECK(grid.height(0, 0) == -1200);       // south-west
    CHECK(grid.height(1200, 1200) == 1200);  // north-east
    CHECK(grid.voids_filled == 1);
    CHECK(grid.height(3, 0) == Approx(-1197).margin(1));
    // A degree at 36.5 degrees north: 89.591 km wide and 110.967 km high (WGS 84).
    CHECK(grid.spacing_m.x * 1200 == Approx(89591).margin(1));
    CHECK(grid.spacing_m.y * 1200 == Approx(110967).margin(10));
}

TEST_CASE("read_height_grid: what is no height grid is refused", "[scene][terrain]") {
    const ScratchFolder folder;
    const GridFrame frame;
    CHECK_THROWS_AS(read_height_grid(folder / "missing.png", frame), InputError);
    CHECK_THROWS_AS(read_height_grid(folder.write("short.hgt", "abc"), frame), InputError);
    CHECK_THROWS_AS(read_height_grid(folder.write("no.png", "no PNG at all"), frame), InputError);
    CHECK_THROWS_AS(read_height_grid(folder.write("grid.tif", "II*"), frame), InputError);
    CHECK_THROWS_AS(read_height_grid(kHill, std::nullopt), InputError);
    CHECK_THROWS_AS(
        read_height_grid(folder.write("N36W085.hgt", hgt([](int, int) { return -32768; })), std::nullopt),
        InputError);

    std::ifstream hill(kHill, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(hill), std::istreambuf_iterator<char>()};
    for (const std::size_t length : {8UL, 40UL, bytes.size() / 2, bytes.size() - 20}) {
        CHECK_THROWS_AS(read_height_grid(folder.write("cut.png", bytes.substr(0, length)), frame),
                        InputError);
    }
}

TEST_CASE("windowed: every stride-th sample of the window, in place", "[scene][terrain]") {
    HeightGrid grid{6, 5, {100, 200}, {10, 20}, {}, 0};
    for (int i = 0; i < 30; ++i) grid.heights.push_back(static_cast<float>(i));
    const HeightGrid part =
        windowed(grid, {.first_column = 1, .first_row = 2, .columns = 5, .rows = 3, .stride = 2});
    CHECK(part.columns == 3);
    CHECK(part.rows == 2);
    CHECK(part.south_west_m == glm::dvec2(110, 240));
    CHECK(part.spacing_m == glm::dvec2(20, 40));
    CHECK(part.heights == std::vector<float>{13, 15, 17, 25, 27, 29});
    CHECK_THROWS_AS(windowed(grid, {.first_column = 2, .columns = 5}), InputError);
    CHECK_THROWS_AS(windowed(grid, {.stride = 5}), InputError);
}

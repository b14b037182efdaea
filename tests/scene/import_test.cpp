// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "../support/file_contents.hpp"
#include "../support/scratch_folder.hpp"
#include "json_node.hpp"
#include "keikan/scene/height_grid.hpp"
#include "scene_blocks.hpp"

using namespace keikan;

namespace {

struct Run {
    int code = 0;
    std::string out;
    std::string err;
};

Run keikan_import(const ScratchFolder& folder, const std::string& arguments) {
    const std::string command = std::string("'") + KEIKAN_IMPORT_PROGRAM + "' " + arguments + " > '" +
                                (folder / "out").string() + "' 2> '" + (folder / "err").string() + "'";
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), contents(folder / "out"), contents(folder / "err")};
}

std::string quoted(const std::filesystem::path& path) {
    return "'" + path.string() + "'";
}

/// An ESRI ASCII grid with its frame as .prj beside it: 40 x 30 samples, heights by `height(column, row)`.
template <typename Height>
std::filesystem::path ascii_grid(const ScratchFolder& folder, const std::string& name, const std::string& srs,
                                 double west, double south, double cell, const Height& height) {
    std::string text = "ncols 40\nnrows 30\nxllcorner " + std::to_string(west) + "\nyllcorner " +
                       std::to_string(south) + "\ncellsize " + std::to_string(cell) +
                       "\nNODATA_value -9999\n";
    for (int row = 0; row < 30; ++row) {
        for (int column = 0; column < 40; ++column) text += std::to_string(height(column, row)) + " ";
        text += "\n";
    }
    folder.write(name + ".prj", srs);
    return folder.write(name + ".asc", text);
}

constexpr const char* kWgs84 =
    R"(GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]],PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]])";
constexpr const char* kUtm54N =
    R"(PROJCS["WGS_1984_UTM_Zone_54N",GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]],PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],PARAMETER["False_Easting",500000.0],PARAMETER["False_Northing",0.0],PARAMETER["Central_Meridian",141.0],PARAMETER["Scale_Factor",0.9996],PARAMETER["Latitude_Of_Origin",0.0],UNIT["Meter",1.0]])";

HeightGrid read_back(const std::filesystem::path& grid) {
    std::filesystem::path frame = grid;
    frame.replace_extension(".json");
    const std::string file = frame.string();
    const nlohmann::json document = parse_json_file(file);
    return read_height_grid(grid, read_grid_frame(JsonNode(document, file, "")));
}

}  // namespace

TEST_CASE("keikan-import: whole metres in a metric frame come back as they were, voids filled",
          "[scene][import]") {
    const ScratchFolder folder;
    const auto height = [](int c, int r) { return c == 5 && r == 7 ? -9999 : 100 + 3 * c - 2 * r; };
    const auto source = ascii_grid(folder, "hills", kUtm54N, 380000, 3950000, 25, height);
    const Run run = keikan_import(folder, "dem " + quoted(source) + " -o " + quoted(folder / "grid.png"));
    INFO(run.err);
    REQUIRE(run.code == 0);
    const auto summary = nlohmann::json::parse(run.out);
    CHECK(summary["voids"] == 1);
    CHECK(summary["resampled"] == false);
    const HeightGrid grid = read_back(folder / "grid.png");
    REQUIRE(grid.columns == 40);
    REQUIRE(grid.rows == 30);
    CHECK(grid.voids_filled == 1);
    CHECK(grid.spacing_m == glm::dvec2(25, 25));
    CHECK(grid.south_west_m == glm::dvec2(380012.5, 3950012.5));  // the middle of the corner cell
    for (int row = 0; row < 30; ++row) {
        for (int column = 0; column < 40; ++column) {
            const int expected = row == 7 && column == 5 ? 101 : height(column, row);
            CHECK(grid.height(column, 29 - row) ==
                  Approx(expected).margin(row == 7 && column == 5 ? 0.5 : 0));
        }
    }
}

TEST_CASE("keikan-import: degrees become the metres of their UTM zone", "[scene][import]") {
    // A plane in longitude and latitude around 138.6 E, 35.4 N, in zone 54 (central meridian 141 E).
    const ScratchFolder folder;
    const auto source =
        ascii_grid(folder, "fuji", kWgs84, 138.5, 35.3, 0.005, [](int c, int r) { return 50.0 + c + r; });
    const Run run = keikan_import(
        folder, "dem " + quoted(source) + " -o " + quoted(folder / "grid.png") + " --spacing 200");
    INFO(run.err);
    REQUIRE(run.code == 0);
    const auto summary = nlohmann::json::parse(run.out);
    CHECK(summary["crs"] == "EPSG:32654");
    CHECK(summary["resampled"] == true);
    const HeightGrid grid = read_back(folder / "grid.png");
    CHECK(grid.spacing_m == glm::dvec2(200, 200));
    // 0.2 degrees of longitude are 18.16 km here, 0.15 of latitude 16.64 km.
    CHECK(grid.columns * 200 == Approx(18160).margin(800));
    CHECK(grid.rows * 200 == Approx(16640).margin(800));
    CHECK(grid.south_west_m.x == Approx(272750).margin(600));
    // A cell is 454 m wide and 555 m high; the frame is turned by 1.4 degrees.
    const int c = grid.columns / 2, r = grid.rows / 2;
    CHECK((grid.height(c + 10, r) - grid.height(c - 10, r)) / 4000 == Approx(1 / 454.0).margin(1e-4));
    CHECK((grid.height(c, r - 10) - grid.height(c, r + 10)) / 4000 == Approx(1 / 555.0).margin(1e-4));
}

TEST_CASE("keikan-import: only a window of the metric frame", "[scene][import]") {
    const ScratchFolder folder;
    const auto source =
        ascii_grid(folder, "hills", kUtm54N, 380000, 3950000, 25, [](int c, int) { return 10.0 * c; });
    const Run run = keikan_import(folder, "dem " + quoted(source) + " -o " + quoted(folder / "grid.png") +
                                              " --window 380250 3950250 380500 3950500");
    INFO(run.err);
    REQUIRE(run.code == 0);
    const HeightGrid grid = read_back(folder / "grid.png");
    CHECK(grid.columns == 10);
    CHECK(grid.rows == 10);
    CHECK(grid.height(0, 0) == Approx(100).margin(0.01));
}

TEST_CASE("keikan-import: bad input is one line, exit code 2, and leaves no file", "[scene][import]") {
    const ScratchFolder folder;
    const auto source =
        ascii_grid(folder, "hills", kUtm54N, 380000, 3950000, 25, [](int, int) { return 1.0; });
    const std::string to = " -o " + quoted(folder / "grid.png");
    for (const std::string& arguments :
         {"dem " + quoted(folder / "missing.tif") + to,
          "dem " + quoted(folder.write("text.tif", "no raster")) + to,
          "dem " + quoted(source) + to + " --srs EPSG:4326", "dem " + quoted(source) + to + " --srs nowhere",
          "dem " + quoted(source) + to + " --spacing -3",
          "dem " + quoted(source) + to + " --window 0 0 10 10",
          "dem " + quoted(source) + " -o " + quoted(folder / "grid.tif"),
          "dem " + quoted(source) + " -o " + quoted(folder / "no/such/grid.png"), std::string("dem"),
          std::string("mesh")}) {
        INFO(arguments);
        const Run run = keikan_import(folder, arguments);
        INFO(run.err);
        CHECK(run.code == 2);
        CHECK_FALSE(run.err.empty());
        CHECK(run.out.empty());
        CHECK_FALSE(std::filesystem::exists(folder / "grid.png"));
        CHECK_FALSE(std::filesystem::exists(folder / "grid.json"));
    }
    CHECK(keikan_import(folder, "--help").code == 0);
    CHECK(keikan_import(folder, "--version").code == 0);
}

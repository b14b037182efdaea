// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <nlohmann/json.hpp>

#include "command_line/command_line.hpp"
#include "import_dem.hpp"

namespace {

void print(const keikan::ImportedDem& dem, const std::string& grid) {
    const nlohmann::ordered_json line = {{"grid", grid},
                                         {"columns", dem.columns},
                                         {"rows", dem.rows},
                                         {"crs", dem.crs},
                                         {"lowest_m", dem.lowest_m},
                                         {"highest_m", dem.highest_m},
                                         {"height_step_m", dem.height_step_m},
                                         {"voids", dem.voids},
                                         {"resampled", dem.resampled}};
    std::puts(line.dump().c_str());
}

int run(int argc, char** argv) {
    CLI::App app("Converts geographic data to files that keikan reads.", "keikan-import");
    app.set_version_flag("--version", "keikan-import " KEIKAN_VERSION);
    app.require_subcommand(1);
    CLI::App& dem = *app.add_subcommand(
        "dem",
        "An elevation model that GDAL reads, to a 16-bit PNG height grid and its metric frame (.json)");
    keikan::DemImport request;
    bool quiet = false;
    dem.add_option("FILE", request.source, "the elevation model, e.g. a GeoTIFF; its first band")->required();
    dem.add_option("-o,--output", request.grid, "the grid to write, GRID.png; its frame goes to GRID.json")
        ->required();
    dem.add_option("--srs", request.srs,
                   "frame to reproject to, e.g. EPSG:32725 (default: its own, else its UTM zone)");
    dem.add_option("--spacing", request.spacing_m, "metres between samples")->check(CLI::PositiveNumber);
    dem.add_option("--window", request.window, "XMIN YMIN XMAX YMAX in the metric frame");
    dem.add_flag("--quiet", quiet, "print no summary");
    dem.callback([&] {
        const keikan::ImportedDem imported = keikan::import_dem(request);
        if (!quiet) print(imported, request.grid.string());
    });
    return keikan::run_command_line(app, argc, argv, "keikan-import");
}

}  // namespace

int main(int argc, char** argv) {
    return keikan::run_program("keikan-import", [argc, argv] { return run(argc, argv); });
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// keikan-verify: the product against the exact oracle.
//
//   scene    every pixel of a picture       scene_command.cpp
//   areas    pixel cases, one or millions   areas_command.cpp
//   fuzz     degenerate random pixels       fuzz_command.cpp
//   truth    exact coverage as pictures      truth_command.cpp
//   peers    the same pixels through others  peers_command.cpp
//   water    water, many samples a pixel     water_command.cpp
//   convert  pixel cases, WKT, GeoJSON, SVG convert_command.cpp
#include "command_line/command_line.hpp"
#include "commands.hpp"
#include "truth_command.hpp"
#include "verdict.hpp"

namespace {

void describe_program(CLI::App& app, keikan::CommonOptions& common) {
    keikan::add_program_options(app, common, "keikan-verify " KEIKAN_VERSION,
                                "Chooses the pixels that are put to every rung of the oracle");
    app.add_option("--json", common.json, "Write the summary to this file too (- is standard output alone)");
    keikan::add_scene_command(app, common);
    keikan::add_areas_command(app, common);
    keikan::add_fuzz_command(app, common);
    keikan::add_truth_command(app, common);
    keikan::add_peers_command(app, common);
    keikan::add_water_command(app, common);
    keikan::add_convert_command(app);
}

}  // namespace

int main(int argc, char** argv) {
    using namespace keikan;
    return run_program("keikan-verify", [argc, argv] {
        CLI::App app("Every pixel against the exact oracle");
        CommonOptions common;
        describe_program(app, common);
        common.command_line = command_line(argc, argv);
        const int done = run_command_line(app, argc, argv, "keikan-verify");
        return common.pass ? done : kCheckFailed;
    });
}

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
#include <CLI/CLI.hpp>

#include "commands.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/program.hpp"
#include "truth_command.hpp"
#include "verdict.hpp"

namespace {

void describe_program(CLI::App& app, keikan::CommonOptions& common) {
    app.set_version_flag("--version", "keikan-verify " KEIKAN_VERSION);
    app.require_subcommand(1);
    app.fallthrough();  // --threads and its like may stand after the command
    app.add_option("--threads", common.threads, "Threads to use (default: all of the machine)")
        ->check(CLI::Range(1, 1024));
    app.add_option("--seed", common.seed, "Chooses the pixels that are put to every rung of the oracle")
        ->capture_default_str();
    app.add_flag("--quiet", common.quiet, "No messages and no progress bar");
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
        try {
            describe_program(app, common);
            common.command_line = command_line(argc, argv);
            app.parse(argc, argv);  // runs the command
            return common.pass ? kDone : kCheckFailed;
        } catch (const CLI::Success& help_or_version) {
            return app.exit(help_or_version);
        } catch (const CLI::ParseError& wrong_usage) {
            throw InputError(wrong_usage.what());
        }
    });
}

// SPDX-License-Identifier: Apache-2.0
//
// keikan: landscapes without aliasing. The picture's way, as in the paper's Fig. 1, is a command each:
//
//   scan     scene -> faces -> scan file     scan_command.cpp
//   shade    scan file, colours -> picture   shade_command.cpp
//   render   both at once                    render_command.cpp
//
// and beside it: areas (visible areas of single pixels), pixel (one pixel of a scene as such a question),
// clip (one difference of two polygons), compare (methods against each other and exact truth), info (what is
// in a scene).
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "commands.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/program.hpp"

namespace {

void describe_program(CLI::App& app, keikan::CommonOptions& common) {
    app.set_version_flag("--version", "keikan " KEIKAN_VERSION);
    app.require_subcommand(1);
    app.fallthrough();  // --threads and its like may stand after the command
    app.add_option("--threads", common.threads, "Threads to use (default: all of the machine)")
        ->check(CLI::Range(1, 1024));
    app.add_option("--seed", common.seed, "For whatever draws random numbers")->capture_default_str();
    app.add_flag("--quiet", common.quiet, "No messages and no progress bar");
    keikan::add_render_command(app, common);
    keikan::add_scan_command(app, common);
    keikan::add_shade_command(app, common);
    keikan::add_areas_command(app, common);
    keikan::add_pixel_command(app, common);
    keikan::add_compare_command(app, common);
    keikan::add_clip_command(app);
    keikan::add_info_command(app, common);
    for (CLI::App* const command : app.get_subcommands({}))
        command->footer("Also --threads N, --seed N, --quiet: see keikan --help.");
}

/// CLI11 would only say that a command is missing where it does not know the one given.
std::string usage_trouble(const CLI::App& app, const CLI::ParseError& trouble) {
    const std::vector<std::string> unknown = app.remaining();
    if (app.get_subcommands().empty() && !unknown.empty() && !unknown.front().starts_with('-'))
        return "'" + unknown.front() + "' is not a command; keikan --help lists them";
    return trouble.what();
}

}  // namespace

int main(int argc, char** argv) {
    using namespace keikan;
    return run_program("keikan", [argc, argv] {
        CLI::App app("Landscapes without aliasing, every pixel proven");
        CommonOptions common;
        try {
            describe_program(app, common);
            app.parse(argc, argv);  // runs the command
            return kDone;
        } catch (const CLI::Success& help_or_version) {
            return app.exit(help_or_version);
        } catch (const CLI::ParseError& wrong_usage) {
            throw InputError(usage_trouble(app, wrong_usage));
        }
    });
}

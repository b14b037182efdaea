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
#include "command_line/command_line.hpp"
#include "commands.hpp"

namespace {

void describe_program(CLI::App& app, keikan::CommonOptions& common) {
    keikan::add_program_options(app, common, "keikan " KEIKAN_VERSION, "For whatever draws random numbers");
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

}  // namespace

int main(int argc, char** argv) {
    return keikan::run_program("keikan", [argc, argv] {
        CLI::App app("Landscapes without aliasing, every pixel proven");
        keikan::CommonOptions common;
        describe_program(app, common);
        return keikan::run_command_line(app, argc, argv, "keikan");
    });
}

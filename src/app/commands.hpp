// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "command_line/command_line.hpp"

namespace keikan {

using CommonOptions = ProgramOptions;

// Each adds its command to the program; parsing the command line then runs it. `common` must outlive that.
void add_render_command(CLI::App& app, const CommonOptions& common);
void add_scan_command(CLI::App& app, const CommonOptions& common);
void add_shade_command(CLI::App& app, const CommonOptions& common);
void add_areas_command(CLI::App& app, const CommonOptions& common);
void add_pixel_command(CLI::App& app, const CommonOptions& common);
void add_compare_command(CLI::App& app, const CommonOptions& common);
void add_clip_command(CLI::App& app);
void add_info_command(CLI::App& app, const CommonOptions& common);

}  // namespace keikan

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "command_line/command_line.hpp"

namespace keikan {

/// Options that every command takes, and what it answers.
struct CommonOptions : ProgramOptions {
    std::string json;          ///< where the summary goes beside standard output; empty: nowhere
    std::string command_line;  ///< as it was given, in words of a shell
    bool pass = true;          ///< what the command found
};

// Each adds its command to the program; parsing the command line then runs it and sets `common.pass`, which
// must outlive that.
void add_scene_command(CLI::App& app, CommonOptions& common);
void add_areas_command(CLI::App& app, CommonOptions& common);
void add_fuzz_command(CLI::App& app, CommonOptions& common);
void add_peers_command(CLI::App& app, CommonOptions& common);
void add_water_command(CLI::App& app, CommonOptions& common);
void add_convert_command(CLI::App& app);

}  // namespace keikan

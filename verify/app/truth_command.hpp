// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "commands.hpp"

namespace keikan {

/// Adds `truth` to the program, as the commands of commands.hpp are added.
void add_truth_command(CLI::App& app, CommonOptions& common);

}  // namespace keikan

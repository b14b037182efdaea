// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>

#include "commands.hpp"
#include "crosscheck/check_summary.hpp"
#include "keikan/clip/visible_areas.hpp"

namespace keikan {

/// The result of a command: the summary as one line of JSON on standard output (and in the file of --json);
/// on standard error the first disagreements, each with the command that repeats it, and the verdict in
/// words. Sets `common.pass`.
void tell_verdict(const crosscheck::CheckSummary& summary, const std::string& json, CommonOptions& common,
                  const std::function<std::string(const crosscheck::Disagreement&)>& replay_command);

/// "splitting", "traversal" or "published". Errors: InputError.
Engine engine_of(const std::string& name);

/// `text` as one word of a shell command.
std::string shell_word(const std::string& text);

/// The command as it was given, with "keikan-verify" for the program.
std::string command_line(int argc, const char* const* argv);

}  // namespace keikan

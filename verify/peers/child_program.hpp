// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace keikan::peers {

/// What became of a program that was given its whole input at once.
struct ProgramRun {
    std::string output;
    std::string last_complaint;  ///< the last line that it wrote to standard error
    bool stopped = false;        ///< it was killed: for so long it neither read nor wrote anything
    int signal = 0;              ///< that ended it; a shell's exit code of 128 + n counts as signal n
    int exit_code = 0;
    double processor_seconds = 0;  ///< with its children, as far as it has waited for them
};

/// Runs `command` by /bin/sh -c with `input` as its standard input, and waits until it ends or has been idle
/// for `idle_seconds`; then it and the processes it started are killed. Output beyond `most_output` bytes is
/// taken as idleness: a program that never stops writing is stopped.
ProgramRun run_program(const std::string& command, std::string_view input, double idle_seconds,
                       std::size_t most_output);

}  // namespace keikan::peers

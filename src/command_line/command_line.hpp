// SPDX-License-Identifier: Apache-2.0
//
// What the command lines of all programs have in common. Not installed: programs alone include it.
#pragma once
#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "keikan/support/input_error.hpp"
#include "keikan/support/program.hpp"

namespace keikan {

/// Options that every command takes.
struct ProgramOptions {
    int threads = 0;  ///< 0: all of the machine
    std::uint64_t seed = 1;
    bool quiet = false;
};

/// --version, and the options above; they may stand after the command, of which there must be one. `options`
/// must outlive the parsing.
inline void add_program_options(CLI::App& app, ProgramOptions& options, const std::string& version,
                                const std::string& what_the_seed_is_for) {
    app.set_version_flag("--version", version);
    app.require_subcommand(1);
    app.fallthrough();
    app.add_option("--threads", options.threads, "Threads to use (default: all of the machine)")
        ->check(CLI::Range(1, 1024));
    app.add_option("--seed", options.seed, what_the_seed_is_for)->capture_default_str();
    app.add_flag("--quiet", options.quiet, "No messages and no progress bar");
}

/// What is wrong with a command line. CLI11 would only say that a command is missing where it does not know
/// the one given.
inline std::string usage_trouble(const CLI::App& app, const CLI::ParseError& trouble,
                                 const std::string& program) {
    const std::vector<std::string> unknown = app.remaining();
    if (app.get_subcommands().empty() && !unknown.empty() && !unknown.front().starts_with('-'))
        return "'" + unknown.front() + "' is not a command; " + program + " --help lists them";
    return trouble.what();
}

/// Parses the command line, which runs the command. Help and version are printed. Returns the exit code;
/// errors: InputError of one line where the usage is wrong, and whatever the command throws.
inline int run_command_line(CLI::App& app, int argc, char** argv, const std::string& program) {
    try {
        app.parse(argc, argv);
        return kDone;
    } catch (const CLI::Success& help_or_version) {
        return app.exit(help_or_version);
    } catch (const CLI::ParseError& wrong_usage) {
        throw InputError(usage_trouble(app, wrong_usage, program));
    }
}

}  // namespace keikan

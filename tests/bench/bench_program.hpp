// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <functional>

namespace keikan::bench {

/// Parses the command line, then runs the benchmark. Returns the exit code: 2 after an error, told in a line.
inline int run_program(CLI::App& app, int count, char** arguments, const std::function<int()>& run) {
    CLI11_PARSE(app, count, arguments);
    try {
        return run();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}

}  // namespace keikan::bench

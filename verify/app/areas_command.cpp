// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <fstream>
#include <iostream>
#include <memory>
#include <vector>

#include "commands.hpp"
#include "crosscheck/check_cases.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "verdict.hpp"

namespace keikan {
namespace {

struct AreasCommand {
    std::vector<std::string> files;
    std::string engine = "splitting";
};

crosscheck::CheckSummary check_file(const std::string& file, const crosscheck::CaseCheckOptions& options) {
    if (file == "-") return crosscheck::check_cases(std::cin, "standard input", options);
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError(file, "", "cannot be opened");
    return crosscheck::check_cases(in, file, options);
}

void areas(const AreasCommand& command, CommonOptions& common) {
    const ThreadLimit threads(common.threads);
    const auto start = std::chrono::steady_clock::now();
    crosscheck::CaseCheckOptions options;
    options.engine = engine_of(command.engine);
    options.seed = common.seed;
    crosscheck::CheckSummary summary;
    for (const std::string& file : command.files) summary += check_file(file, options);
    summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    tell_verdict(summary, crosscheck::summary_json(summary), common, [&](const crosscheck::Disagreement& d) {
        std::string files;
        for (const std::string& file : command.files) files += " " + shell_word(file);
        return fmt::format("cat{} | grep -F {} | keikan-verify areas -", files == " -" ? "" : files,
                           shell_word(fmt::format("\"id\": \"{}\"", d.case_id)));
    });
}

}  // namespace

void add_areas_command(CLI::App& app, CommonOptions& common) {
    auto* const sub =
        app.add_subcommand("areas", "Pixel cases (docs/cases.md): visible areas, float against exact");
    const auto command = std::make_shared<AreasCommand>();
    sub->add_option("FILE", command->files, "Pixel cases, or - for standard input")->required();
    sub->add_option("--engine", command->engine, "For visible areas: splitting, traversal, published")
        ->capture_default_str();
    sub->callback([command, &common] { areas(*command, common); });
}

}  // namespace keikan

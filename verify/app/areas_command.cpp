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
#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "report/case_report.hpp"
#include "report_page.hpp"
#include "verdict.hpp"

namespace keikan {
namespace {

struct AreasCommand {
    std::vector<std::string> files;
    std::string engine = "splitting", report;
};

/// `choice` sees every case, where there is one.
crosscheck::CheckSummary check_stream(std::istream& in, const std::string& name,
                                      const crosscheck::CaseCheckOptions& options,
                                      report::CaseChoice* choice) {
    PixelCaseReader reader(in, name);
    const auto seen = [&](const PixelCase& pixel_case, const crosscheck::PixelVerdict& verdict) {
        if (choice) choice->add(pixel_case, verdict);
    };
    return crosscheck::check_cases([&] { return reader.next(); }, options, {}, seen);
}

crosscheck::CheckSummary check_file(const std::string& file, const crosscheck::CaseCheckOptions& options,
                                    report::CaseChoice* choice) {
    if (file == "-") return check_stream(std::cin, "standard input", options, choice);
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError(file, "", "cannot be opened");
    return check_stream(in, file, options, choice);
}

void write_report(const AreasCommand& command, const CommonOptions& common, const report::CaseChoice& choice,
                  const crosscheck::CheckSummary& summary) {
    report::Page page = page_of("areas", common);
    for (const std::string& file : command.files)
        page.subject += (page.subject.empty() ? "" : " ") + (file == "-" ? "standard input" : file);
    page.engine = command.engine;
    page.summary = crosscheck::summary_json(summary);
    page.junit = report::junit_cases(summary);
    choice.fill(page);
    report::write_page(command.report, page);
}

void areas(const AreasCommand& command, CommonOptions& common) {
    const ThreadLimit threads(common.threads);
    const auto start = std::chrono::steady_clock::now();
    crosscheck::CaseCheckOptions options;
    options.engine = engine_of(command.engine);
    options.seed = common.seed;
    options.kinds = !command.report.empty();
    if (options.kinds) report::make_report_folder(command.report);
    report::CaseChoice choice(options.engine);
    crosscheck::CheckSummary summary;
    for (const std::string& file : command.files)
        summary += check_file(file, options, options.kinds ? &choice : nullptr);
    summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (options.kinds) write_report(command, common, choice, summary);
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
    sub->add_option("--report", command->report,
                    "Folder for the page of the pixel inspector and the summary");
    sub->callback([command, &common] { areas(*command, common); });
}

}  // namespace keikan

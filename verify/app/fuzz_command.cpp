// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "commands.hpp"
#include "crosscheck/check_cases.hpp"
#include "fuzz/degenerate_families.hpp"
#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "verdict.hpp"

namespace keikan {
namespace {

struct FuzzCommand {
    std::vector<std::string> families{"all"};
    std::uint64_t count = 100'000;
    double seconds = 0;
    std::string engine = "splitting", save;
    bool no_contacts = false;
    std::uint64_t rational_one_in = crosscheck::CaseCheckOptions().rational_one_in;
    std::uint64_t cgal_one_in = crosscheck::CaseCheckOptions().boolean_sets_one_in;
};

std::vector<fuzz::Family> families_of(const std::vector<std::string>& names) {
    std::vector<fuzz::Family> families;
    for (const std::string& name : names) {
        if (name == "all") {
            for (std::size_t f = 0; f < fuzz::kFamilyNames.size(); ++f)
                families.push_back(static_cast<fuzz::Family>(f));
        } else if (const auto family = fuzz::family_of(name)) {
            families.push_back(*family);
        } else {
            std::string known;
            for (const std::string_view k : fuzz::kFamilyNames) known += fmt::format(" {}", k);
            throw InputError(fmt::format("--family {}: there are only: all{}", name, known));
        }
    }
    return families;
}

/// A finding as a pixel case of its own, named after its id; written whole, so that whatever happens later
/// keeps it.
void save(const std::string& folder, const PixelCase& pixel_case) {
    std::string name = pixel_case.id;
    for (char& c : name)
        if (c == '/') c = '-';
    write_whole_file((std::filesystem::path(folder) / (name + ".jsonl")).string(),
                     pixel_case_line(pixel_case) + "\n");
}

void run_fuzz(const FuzzCommand& command, CommonOptions& common) {
    using Clock = std::chrono::steady_clock;
    const std::vector<fuzz::Family> families = families_of(command.families);
    crosscheck::CaseCheckOptions options;
    options.engine = engine_of(command.engine);
    options.contacts = !command.no_contacts;
    options.seed = common.seed;
    options.rational_one_in = command.rational_one_in;
    options.boolean_sets_one_in = command.cgal_one_in;
    if (!command.save.empty()) std::filesystem::create_directories(command.save);
    const ThreadLimit threads(common.threads);
    const auto start = Clock::now();
    const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    if (!common.quiet) fmt::print(stderr, "seed {}\n", common.seed);

    // Families take turns, so that a run cut short by time has seen them all.
    std::uint64_t made = 0;
    const auto next = [&]() -> std::optional<PixelCase> {
        const bool over =
            command.seconds > 0 ? made % 512 == 0 && elapsed() >= command.seconds : made >= command.count;
        if (over) return std::nullopt;
        const std::uint64_t n = made++;
        return fuzz::degenerate_case(families[n % families.size()], common.seed, n / families.size());
    };
    crosscheck::CheckSummary summary = crosscheck::check_cases(
        next, options, [&](const PixelCase& pixel_case, const crosscheck::PixelVerdict&) {
            if (!command.save.empty()) save(command.save, pixel_case);
        });
    summary.seconds = elapsed();
    tell_verdict(summary, crosscheck::summary_json(summary), common, [&](const crosscheck::Disagreement& d) {
        return fmt::format(
            "keikan-verify fuzz --family {} --seed {} --save DIR; keikan-verify areas DIR/*.jsonl",
            d.case_id.substr(0, d.case_id.find('/')), common.seed);
    });
}

}  // namespace

void add_fuzz_command(CLI::App& app, CommonOptions& common) {
    auto* const sub = app.add_subcommand("fuzz", "Degenerate random pixels, float against exact");
    const auto command = std::make_shared<FuzzCommand>();
    sub->add_option("--family", command->families,
                    "Which kinds of degenerate pixels, separated by commas, or all")
        ->delimiter(',')
        ->capture_default_str();
    sub->add_option("--count", command->count, "Pixels")->capture_default_str();
    sub->add_option("--seconds", command->seconds, "Run for so long instead")->check(CLI::PositiveNumber);
    sub->add_option("--engine", command->engine, "For visible areas: splitting, traversal, published")
        ->capture_default_str();
    sub->add_option("--save", command->save, "Folder for the findings, a pixel case each");
    sub->add_option("--rational-one-in", command->rational_one_in,
                    "After the first 256, rational splitting answers one pixel in so many")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    sub->add_option("--cgal-one-in", command->cgal_one_in,
                    "After the first 256, CGAL's Boolean set operations answer one pixel in so many")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    sub->add_flag("--no-contacts", command->no_contacts,
                  "Areas only: do not classify the clipper's contacts");
    sub->callback([command, &common] { run_fuzz(*command, common); });
}

}  // namespace keikan

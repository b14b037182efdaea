// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "crosscheck/check_cases.hpp"
#include "families.hpp"
#include "fuzz/campaign.hpp"
#include "fuzz/degenerate_families.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "keikan/support/progress.hpp"
#include "report/case_report.hpp"
#include "report_page.hpp"
#include "verdict.hpp"

namespace keikan {
namespace {

constexpr std::uint64_t kDefaultCount = 100'000;

struct FuzzCommand {
    std::vector<std::string> families{"all"}, engines{"all"};
    std::optional<std::uint64_t> count;
    double seconds = 0;
    std::uint64_t from = 0, shrink = fuzz::CampaignOptions().shrunk_per_family;
    std::string depth = "as-made", save, report;
    bool resume = false;
    bool no_contacts = false;
    std::uint64_t rational_one_in = crosscheck::CaseCheckOptions().rational_one_in;
    std::uint64_t cgal_one_in = crosscheck::CaseCheckOptions().boolean_sets_one_in;
};

fuzz::DepthChoice depth_of(const std::string& word) {
    for (std::size_t i = 0; i < std::size(fuzz::kDepthChoiceNames); ++i)
        if (word == fuzz::kDepthChoiceNames[i]) return static_cast<fuzz::DepthChoice>(i);
    throw InputError(fmt::format("--depth {}: there are only: as-made, always, never", word));
}

/// Who is asked. "all" are the engines that promise to be right: where contacts are checked, the traversal is
/// walked beside splitting anyway, and one answer of the oracle does for both.
std::vector<fuzz::Examinee> examinees_of(const FuzzCommand& command, std::uint64_t seed) {
    crosscheck::CaseCheckOptions options;
    options.contacts = !command.no_contacts;
    options.seed = seed;
    options.rational_one_in = command.rational_one_in;
    options.boolean_sets_one_in = command.cgal_one_in;
    std::vector<std::string> names;
    for (const std::string& name : command.engines) {
        if (name == "all") {
            names.push_back("splitting");
            if (command.no_contacts) names.push_back("traversal");
        } else {
            names.push_back(name);
        }
    }
    std::vector<fuzz::Examinee> examinees;
    for (const std::string& name : names) {
        if (std::ranges::count(examinees, name, &fuzz::Examinee::name) > 0) continue;
        options.engine = engine_of(name);
        examinees.push_back(fuzz::examinee_of(name, options));
    }
    return examinees;
}

fuzz::CampaignOptions campaign_of(const FuzzCommand& command, const CommonOptions& common) {
    fuzz::CampaignOptions options;
    options.cases = {families_of(command.families), common.seed, depth_of(command.depth)};
    options.examinees = examinees_of(command, common.seed);
    options.first = command.from;
    // Without a number, --seconds alone ends it.
    if (command.count || command.seconds == 0) options.count = command.count.value_or(kDefaultCount);
    if (command.seconds > 0) options.seconds = command.seconds;
    options.folder = command.save;
    options.resume = command.resume;
    options.shrunk_per_family = command.shrink;
    options.version = KEIKAN_VERSION;
    options.more_identity = {{"contacts", command.no_contacts ? "no" : "yes"},
                             {"rational one in", std::to_string(command.rational_one_in)},
                             {"cgal one in", std::to_string(command.cgal_one_in)}};
    if (command.resume && command.save.empty())
        throw InputError("--resume: needs --save, the folder to go on in");
    return options;
}

/// A bar with rate and findings; of the time or of the cases, whatever ends the campaign.
class CampaignProgress {
  public:
    CampaignProgress(const fuzz::CampaignOptions& options, bool wanted)
        : timed_(std::isfinite(options.seconds)),
          bar_("fuzzing", timed_ ? static_cast<std::size_t>(1000 * options.seconds) : options.count, wanted) {
    }

    void operator()(const fuzz::CampaignState& state) {
        if (!began_)
            began_ = {state.done, state.seconds};  // of a resumed campaign: what this run does counts
        const double seconds = state.seconds - began_->second;
        const double rate = seconds > 0 ? static_cast<double>(state.done - began_->first) / seconds : 0;
        bar_.note(fmt::format("{} pixels, {:.0f}/s, {} findings, {} kept", state.done, rate, state.findings,
                              state.stored.size()));
        bar_.reach(timed_ ? static_cast<std::size_t>(1000 * state.seconds) : state.done);
    }

  private:
    bool timed_;
    Progress bar_;
    std::optional<std::pair<std::uint64_t, double>> began_;
};

/// The summary of docs/verification.md, and what is a campaign's own.
std::string json_of(const fuzz::CampaignOptions& options, const fuzz::CampaignState& state) {
    using Json = nlohmann::ordered_json;
    Json json = Json::parse(crosscheck::summary_json(fuzz::summary_of(state)));
    Json engines = Json::object();
    for (std::size_t e = 0; e < options.examinees.size(); ++e) {
        const crosscheck::CheckSummary& s = state.summaries[e];
        const double error = std::min(s.max_area_error, std::numeric_limits<double>::max());
        engines[options.examinees[e].name] = {
            {"pixels", s.pixels}, {"disagreements", s.disagreement_count}, {"max_area_error", error}};
    }
    json["campaign"] = {{"seed", options.cases.seed}, {"from", state.first},
                        {"families", Json::array()},  {"depth", state.identity.at("depth")},
                        {"engines", engines},         {"findings", state.findings},
                        {"kept", state.stored}};
    for (const fuzz::Family family : options.cases.families)
        json["campaign"]["families"].push_back(fuzz::name_of(family));
    return json.dump();
}

/// The command that asks about one case of the campaign again; nothing for an id that is none of its own.
std::string replay_of(const std::string& id, const FuzzCommand& command,
                      const fuzz::CampaignOptions& options) {
    // "family/seed/index", and "/always" or "/never"
    const std::string family = id.substr(0, id.find('/'));
    const std::size_t index = id.find('/', family.size() + 1) + 1;
    std::string engines;
    for (const fuzz::Examinee& e : options.examinees) engines += (engines.empty() ? "" : ",") + e.name;
    return fmt::format("keikan-verify fuzz --family {} --seed {} --from {} --count 1 --engine {}{}{}", family,
                       options.cases.seed, id.substr(index, id.find('/', index) - index), engines,
                       command.depth == "as-made" ? "" : " --depth " + command.depth,
                       command.no_contacts ? " --no-contacts" : "");
}

/// The case of the campaign that bears this id.
PixelCase case_of(const std::string& id, const fuzz::CaseSeries& series) {
    const std::string family = id.substr(0, id.find('/'));
    const std::size_t at = id.find('/', family.size() + 1) + 1;
    const std::uint64_t index = std::stoull(id.substr(at, id.find('/', at) - at));
    for (std::size_t f = 0; f < series.families.size(); ++f)
        if (fuzz::name_of(series.families[f]) == family) return series(index * series.families.size() + f);
    throw InputError(id, "", "is no case of this campaign");
}

/// Cases of a campaign for its page, each once: those with a disagreement that the summary lists, the worst,
/// and the first of each family, to show what was tried.
class FuzzPixels {
  public:
    FuzzPixels(const FuzzCommand& command, const fuzz::CampaignOptions& options)
        : command_(command), options_(options) {}

    report::PixelToShow& at(const std::string& id, report::Reason reason) {
        const auto [place, is_new] = places_.try_emplace(id, pixels.size());
        if (is_new) {
            const std::string& engine = options_.examinees.front().name;
            pixels.push_back(report::case_to_show(case_of(id, options_.cases), engine_of(engine)));
            pixels.back().note = id.substr(0, id.find('/'));
            pixels.back().command = replay_of(id, command_, options_);
        }
        report::PixelToShow& pixel = pixels[place->second];
        if (std::ranges::count(pixel.reasons, reason) == 0) pixel.reasons.push_back(reason);
        return pixel;
    }

    std::vector<report::PixelToShow> pixels;

  private:
    const FuzzCommand& command_;
    const fuzz::CampaignOptions& options_;
    std::map<std::string, std::size_t> places_;
};

/// Of each family how many cases were asked and, of the findings that the summary lists, how many are its
/// own.
nlohmann::ordered_json families_json(const fuzz::CampaignOptions& options, const fuzz::CampaignState& state,
                                     const crosscheck::CheckSummary& summary) {
    std::map<std::string, std::set<std::string>> found;
    for (const crosscheck::Disagreement& d : summary.disagreements)
        found[d.case_id.substr(0, d.case_id.find('/'))].insert(d.case_id);
    nlohmann::ordered_json families = nlohmann::ordered_json::array();
    const std::uint64_t n = options.cases.families.size(), end = state.first + state.done;
    for (std::uint64_t f = 0; f < n; ++f) {
        const auto below = [&](std::uint64_t number) { return number / n + (number % n > f ? 1 : 0); };
        const std::string name(fuzz::name_of(options.cases.families[f]));
        families.push_back(
            {{"name", name}, {"tried", below(end) - below(state.first)}, {"findings", found[name].size()}});
    }
    return families;
}

void write_report(const FuzzCommand& command, const CommonOptions& common,
                  const fuzz::CampaignOptions& options, const fuzz::CampaignState& state,
                  const std::string& json) {
    const crosscheck::CheckSummary summary = fuzz::summary_of(state);
    report::Page page = page_of("fuzz", common);
    page.subject = fmt::format("{} families", options.cases.families.size());
    page.engine = options.examinees.front().name;
    page.summary = json;
    page.junit = report::junit_cases(summary);
    page.more = nlohmann::ordered_json{{"families", families_json(options, state, summary)},
                                       {"listed", summary.disagreements.size()}}
                    .dump();
    FuzzPixels chosen(command, options);
    for (const crosscheck::Disagreement& d : summary.disagreements) {
        report::PixelToShow& pixel = chosen.at(d.case_id, report::Reason::Disagrees);
        pixel.error = std::max(pixel.error, d.error);
        pixel.disagreements.push_back(d);
    }
    for (const crosscheck::WorstPixel& w : summary.worst) {
        report::PixelToShow& pixel = chosen.at(w.case_id, report::Reason::Worst);
        pixel.error = std::max(pixel.error, w.error);
    }
    for (std::size_t f = 0; f < std::min<std::size_t>(options.cases.families.size(), state.done); ++f)
        chosen.at(options.cases(state.first + f).id, report::Reason::Sample);
    page.pixels = std::move(chosen.pixels);
    report::write_page(command.report, page);
}

void run_fuzz(const FuzzCommand& command, CommonOptions& common) {
    const fuzz::CampaignOptions options = campaign_of(command, common);
    const ThreadLimit threads(common.threads);
    if (!common.quiet) fmt::print(stderr, "seed {}\n", common.seed);
    if (!command.report.empty()) report::make_report_folder(command.report);
    fuzz::CampaignState state;
    {
        CampaignProgress progress(options, !common.quiet);
        state = fuzz::run_campaign(options, std::ref(progress));
    }
    const std::string json = json_of(options, state);
    if (!command.report.empty()) write_report(command, common, options, state, json);
    tell_verdict(fuzz::summary_of(state), json, common,
                 [&](const crosscheck::Disagreement& d) { return replay_of(d.case_id, command, options); });
    if (!options.folder.empty() && !state.stored.empty() && !common.quiet)
        fmt::print(stderr, "{} findings, {} different ones kept in {}\n", state.findings, state.stored.size(),
                   options.folder.string());
}

}  // namespace

void add_fuzz_command(CLI::App& app, CommonOptions& common) {
    auto* const sub = app.add_subcommand("fuzz", "Degenerate random pixels, float against exact");
    const auto command = std::make_shared<FuzzCommand>();
    sub->add_option("--family", command->families,
                    "Which kinds of degenerate pixels, separated by commas, or all")
        ->delimiter(',')
        ->capture_default_str();
    sub->add_option("--count", command->count, "Pixels (default: 100000, or what --seconds allows)");
    sub->add_option("--seconds", command->seconds, "Run for so long, or until there are --count pixels")
        ->check(CLI::PositiveNumber);
    sub->add_option("--from", command->from, "Number of the first pixel")->capture_default_str();
    sub->add_option("--engine", command->engines,
                    "For visible areas: splitting, traversal, published, or all, which is the first two")
        ->delimiter(',')
        ->capture_default_str();
    sub->add_option("--depth", command->depth,
                    "Depth planes: as-made (by the family), always, never (nearest first)")
        ->capture_default_str();
    sub->add_option("--save", command->save,
                    "Folder for the findings: shrunk, as pixel case, WKT, GeoJSON and drawing each");
    sub->add_flag("--resume", command->resume, "Go on where the campaign in the folder of --save stopped");
    sub->add_option("--shrink", command->shrink, "Findings to shrink of each engine and family")
        ->capture_default_str();
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
    sub->add_option("--report", command->report,
                    "Folder for the page of the pixel inspector and the summary");
    sub->callback([command, &common] { run_fuzz(*command, common); });
}

}  // namespace keikan

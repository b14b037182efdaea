// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "commands.hpp"
#include "crosscheck/error_bounds.hpp"
#include "families.hpp"
#include "fuzz/degenerate_families.hpp"
#include "fuzz/shrink_case.hpp"
#include "keikan/cases/case_format.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "keikan/support/progress.hpp"
#include "peers/bug_report.hpp"
#include "peers/contest.hpp"
#include "peers/table.hpp"
#include "report/case_report.hpp"
#include "report_page.hpp"
#include "verdict.hpp"

namespace keikan {
namespace {

using namespace peers;

struct PeersCommand {
    std::string file, chart, show, report;
    std::vector<std::string> families{"all"}, peers, programs;
    std::uint64_t count = 10'000;
    int samples = 16;
    double limit_s = 2;
};

using NextCase = std::function<std::optional<PixelCase>()>;

/// The pixels of the others are nothing special without depth planes, which no library knows, or once they
/// are cut to the pixel.
bool is_hard_for_others(fuzz::Family family) {
    using enum fuzz::Family;
    return family != Cyclic && family != Interpenetrating && family != Coplanar && family != FarPowers;
}

/// Families take turns. Their polygons are taken as listed, nearest first, without depth planes.
NextCase made_cases(const std::vector<fuzz::Family>& families, std::uint64_t count, std::uint64_t seed) {
    return [=, made = std::uint64_t{0}]() mutable -> std::optional<PixelCase> {
        if (made == count) return std::nullopt;
        const std::uint64_t n = made++;
        PixelCase next = fuzz::degenerate_case(families[n % families.size()], seed, n / families.size());
        next.depth.reset();
        return next;
    };
}

NextCase cases_of_file(const std::string& file) {
    const CaseFormat format = case_format_of(file).value_or(CaseFormat::PixelCases);
    if (format == CaseFormat::Svg) throw InputError(file, "", "is a drawing: there are no cases in it");
    if (file == "-") return case_reader(std::cin, "standard input", CaseFormat::PixelCases);
    const auto in = std::make_shared<std::ifstream>(file, std::ios::binary);
    if (!*in) throw InputError(file, "", "cannot be opened");
    return [in, next = case_reader(*in, file, format)] { return next(); };
}

/// Everybody who may take part, in the order of the table.
std::vector<Contestant> contestants(const PeersCommand& command) {
    const Watchdog watchdog{.seconds = command.limit_s};
    std::vector<Contestant> all;
    std::vector<Peer> peers = {splitting(), traversal(), published(), clipper(), geos(), boost_geometry()};
    if (auto newer = boost_geometry_1_81()) peers.push_back(*std::move(newer));
    for (Peer peer : {cgal_inexact(), cgal_exact(), sampling(command.samples)}) peers.push_back(peer);
    for (const Peer& peer : peers) all.push_back(in_a_fork(peer, watchdog));
    // Ours have promised something, all but the paper's clipper to the letter.
    for (Contestant& c : all)
        if (c.name == "splitting" || c.name == "traversal") c.promised_error = crosscheck::area_bound;
    return all;
}

/// Those that are asked: without --peer all of them; and the external programs.
std::vector<Contestant> chosen_contestants(const PeersCommand& command) {
    std::vector<Contestant> chosen;
    std::vector<Contestant> all = contestants(command);
    std::string known;
    for (const Contestant& c : all) known += " " + c.name;
    if (command.peers.empty()) {
        chosen = std::move(all);
    } else if (command.peers != std::vector<std::string>{"none"}) {
        for (const std::string& name : command.peers) {
            const auto found = std::ranges::find(all, name, &Contestant::name);
            if (found == all.end())
                throw InputError(fmt::format("--peer {}: there are only:{} none", name, known));
            chosen.push_back(*found);
        }
    }
    for (std::size_t i = 0; i < command.programs.size(); ++i)
        chosen.push_back(external_program(i == 0 ? "exec" : fmt::format("exec-{}", i + 1),
                                          command.programs[i], {.seconds = command.limit_s}));
    if (chosen.empty()) throw InputError("--peer none: nobody is left to be asked");
    return chosen;
}

Contest held(const PeersCommand& command, const std::vector<Contestant>& contestants,
             const CommonOptions& common) {
    if (!command.file.empty()) return contest(cases_of_file(command.file), contestants);
    Progress progress("asking", command.count * contestants.size(), !common.quiet);
    return contest(made_cases(families_of(command.families, is_hard_for_others), command.count, common.seed),
                   contestants, [&](std::size_t asked) { progress.advance(asked); });
}

std::string summary_json(const Contest& contest, const CommonOptions& common, double seconds) {
    double area_error = 0, sum_error = 0;
    for (const Standing& s : contest.standings) {
        if (!s.promises) continue;
        area_error = std::max(area_error, s.all.largest_error);
        sum_error = std::max(sum_error, s.largest_sum_error);
    }
    nlohmann::ordered_json json{{"verdict", common.pass ? "pass" : "fail"},
                                {"pixels", contest.pixels},
                                {"polygons", contest.polygons},
                                {"max_area_error", area_error},
                                {"max_sum_error", sum_error},
                                {"classification", {{"checked", 0}, {"mismatches", 0}}},
                                {"oracle",
                                 {{"cgal", 0},
                                  {"rational", contest.pixels - contest.certified},
                                  {"quad", contest.pixels},
                                  {"certified", contest.certified}}},
                                {"worst", nlohmann::ordered_json::array()},
                                {"seconds", seconds},
                                {"seed", common.seed}};
    json["peers"] = nlohmann::ordered_json::parse(table_in_json(contest.standings));
    return json.dump();
}

void tell_depth(const Contest& contest) {
    for (const Standing& s : contest.standings)
        if (s.not_asked > 0)
            fmt::print(stderr, "{}: not asked about {} pixels{}\n", s.name, s.not_asked,
                       s.knows_depth ? ": too much went wrong before" : ", which have depth planes");
}

/// What a contestant gets wrong, beside the answer of the traversal.
report::PixelToShow pixel_to_show(const Finding& finding, const std::string& name) {
    report::PixelToShow show = report::case_to_show(finding.pixel_case, Engine::Traversal);
    report::NamedClaim claim{name, {finding.reply.answer.areas, finding.reply.answer.background}};
    if (finding.reply.outcome != Outcome::Answered)
        claim.failure = finding.reply.reason.empty() ? "no answer" : finding.reply.reason;
    show.claims.insert(show.claims.begin(), std::move(claim));
    show.note = name;
    show.reasons = {report::Reason::Worst};
    show.error =
        finding.reply.outcome == Outcome::Answered ? finding.error : std::numeric_limits<double>::infinity();
    return show;
}

std::vector<report::JunitCase> junit_cases(const std::vector<Standing>& standings) {
    std::vector<report::JunitCase> cases;
    for (const Standing& s : standings) {
        if (!s.promises) continue;
        report::JunitCase one{s.name + " keeps its bound", {}, s.broken_promises};
        if (s.broken_promises > 0) one.failures.push_back("the worst is " + s.worst);
        cases.push_back(std::move(one));
    }
    return cases;
}

void write_report(const PeersCommand& command, const CommonOptions& common, const Contest& result,
                  const std::string& json) {
    report::Page page = page_of("peers", common);
    page.subject = command.file.empty() ? fmt::format("{} pixels", result.pixels) : command.file;
    page.engine = "traversal";
    page.summary = json;
    page.junit = junit_cases(result.standings);
    for (std::size_t c = 0; c < result.standings.size(); ++c) {
        if (result.worst_few[c].empty() && result.worst[c])  // never wrong: its worst all the same
            page.pixels.push_back(pixel_to_show(*result.worst[c], result.standings[c].name));
        for (const Finding& finding : result.worst_few[c])
            page.pixels.push_back(pixel_to_show(finding, result.standings[c].name));
    }
    report::write_page(command.report, page);
}

void compare_peers(const PeersCommand& command, CommonOptions& common) {
    const ThreadLimit threads(common.threads);
    const auto start = std::chrono::steady_clock::now();
    if (!command.report.empty()) report::make_report_folder(command.report);
    const Contest result = held(command, chosen_contestants(command), common);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    common.pass =
        std::ranges::all_of(result.standings, [](const Standing& s) { return s.broken_promises == 0; });

    const std::string json = summary_json(result, common, seconds);
    if (!command.report.empty()) write_report(command, common, result, json);
    if (!command.chart.empty()) write_whole_file(command.chart, table_as_chart(result.standings));
    if (!common.json.empty() && common.json != "-") write_whole_file(common.json, json + "\n");
    std::fputs(common.json == "-" ? (json + "\n").c_str() : table_in_markdown(result.standings).c_str(),
               stdout);
    std::fflush(stdout);
    if (common.quiet) return;
    tell_depth(result);
    for (const Standing& s : result.standings)
        if (s.broken_promises > 0)
            fmt::print(stderr, "FAIL: {} breaks its promise in {} pixels; the worst is {}\n", s.name,
                       s.broken_promises, s.worst);
    fmt::print(stderr, "{} pixels, {} polygons; {:.1f} s\n", result.pixels, result.polygons, seconds);
}

/// The finding, shrunk. Each question goes to a contestant of its own, which has no failures to look back on.
Finding smallest_form(const Finding& finding, const std::function<std::vector<Contestant>()>& asked_alone) {
    constexpr std::size_t kMostQuestions = 1000, kMostHangs = 20;
    TruthTeller truth;
    const auto asked = [&](PixelCase pixel_case) {
        return asked_about(std::move(pixel_case), asked_alone().front(), truth);
    };
    PixelCase smallest = fuzz::shrunk(
        finding.pixel_case, [&](const PixelCase& c) { return shows_the_same(asked(c), finding); },
        finding.reply.outcome == Outcome::Hang ? kMostHangs : kMostQuestions);
    smallest.id = finding.pixel_case.id;
    return asked(std::move(smallest));
}

/// --show FAMILY:PEER
void show_worst(PeersCommand command, CommonOptions& common) {
    const std::size_t colon = command.show.rfind(':');
    if (colon == std::string::npos) throw InputError("--show " + command.show + ": is not FAMILY:PEER");
    const std::string family = command.show.substr(0, colon), peer = command.show.substr(colon + 1);
    const bool external = peer.starts_with("exec");
    command.peers = {external ? "none" : peer};
    if (!external) command.programs.clear();
    command.families = {family};
    const ThreadLimit threads(common.threads);
    const auto asked_alone = [&] {
        std::vector<Contestant> chosen = chosen_contestants(command);
        std::erase_if(chosen, [&](const Contestant& c) { return c.name != peer; });
        if (chosen.empty()) throw InputError("--show " + command.show + ": there is no such --exec");
        return chosen;
    };
    const std::vector<Contestant> asked = asked_alone();
    Contest result;
    if (command.file.empty() || family == "all") {
        result = held(command, asked, common);
    } else {
        const NextCase next = cases_of_file(command.file);
        result = contest(
            [&] {
                std::optional<PixelCase> found = next();
                while (found && family_named_in(found->id) != family) found = next();
                return found;
            },
            asked);
    }
    if (!result.worst.front())
        throw InputError(fmt::format("--show {}: {} was not asked about any pixel", command.show, peer));
    const Finding smallest = smallest_form(*result.worst.front(), asked_alone);
    std::string replay = "keikan-verify peers";
    if (command.file.empty())
        replay += fmt::format(" --count {} --seed {}", command.count, common.seed);
    else
        replay += " " + shell_word(command.file);
    replay += " --show " + shell_word(command.show);
    if (external) replay += " --exec " + shell_word(asked.front().version);
    std::fputs(bug_report(smallest, asked.front(), replay).c_str(), stdout);
    std::fflush(stdout);
}

}  // namespace

void add_peers_command(CLI::App& app, CommonOptions& common) {
    auto* const sub = app.add_subcommand(
        "peers", "The same pixels through polygon libraries and any program, against the exact oracle");
    const auto command = std::make_shared<PeersCommand>();
    auto* const file = sub->add_option("FILE", command->file, "Pixel cases, or - for standard input");
    sub->add_option("--family", command->families, "Kinds of degenerate pixels, separated by commas, or all")
        ->delimiter(',')
        ->capture_default_str()
        ->excludes(file);
    sub->add_option("--count", command->count, "Pixels")->capture_default_str()->excludes(file);
    sub->add_option("--peer", command->peers,
                    "Who is asked, separated by commas: splitting, traversal, published, clipper, geos, "
                    "boost-geometry, cgal-inexact, cgal-exact, sampling-NxN; none: the programs of --exec "
                    "alone (default: all)")
        ->delimiter(',');
    sub->add_option(
           "--exec", command->programs,
           "A program to be asked as well: pixel cases on its input, areas on its output; may be repeated")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    sub->add_option("--samples", command->samples, "N of N x N sampling")
        ->capture_default_str()
        ->check(CLI::Range(1, kMostSamplesAside));
    sub->add_option("--limit", command->limit_s, "Seconds after which a pixel counts as a hang")
        ->capture_default_str()
        ->check(CLI::Range(0.01, 3600.0));
    sub->add_option("--chart", command->chart, "Draw the table, an SVG");
    sub->add_option("--show", command->show, "FAMILY:PEER: print that peer's worst pixel as a bug report");
    sub->add_option("--report", command->report,
                    "Folder for the page of the pixel inspector and the summary");
    sub->callback([command, &common] {
        if (command->show.empty())
            compare_peers(*command, common);
        else
            show_worst(*command, common);
    });
}

}  // namespace keikan

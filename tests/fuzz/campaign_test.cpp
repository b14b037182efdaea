// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/campaign.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../support/scratch_folder.hpp"
#include "crosscheck/compare_pixel.hpp"
#include "fuzz/shrink_case.hpp"
#include "fuzz/summary_json.hpp"
#include "keikan/cases/case_format.hpp"
#include "keikan/clip/published_clipper.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "keikan/support/input_error.hpp"

using namespace keikan;
using namespace keikan::fuzz;

namespace {

std::vector<Family> all_families() {
    std::vector<Family> families;
    for (std::size_t f = 0; f < kFamilyNames.size(); ++f) families.push_back(static_cast<Family>(f));
    return families;
}

bool inside_the_pixel(const PixelCase& c) {
    return std::ranges::all_of(c.polygons, [](const Ring& ring) {
        return std::ranges::all_of(ring,
                                   [](Point p) { return p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1; });
    });
}

double twice_area(const Ring& ring) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        sum += (ring[i].x - ring[0].x) * (ring[i + 1].y - ring[0].y) -
               (ring[i].y - ring[0].y) * (ring[i + 1].x - ring[0].x);
    return sum;
}

/// The paper asks for polygons without repeated corners, and its areas are of polygons with area.
bool has_repeats_or_no_area(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (ring[i] == ring[(i + 1) % ring.size()]) return true;
    return twice_area(ring) == 0;
}

/// The paper's areas under one reading of case (4) of section 3.2.1, with holes as signed pieces.
std::vector<double> paper_areas(const PixelCase& c, PublishedReading::SharedVertex shared_vertex) {
    std::vector<Ring> rings = c.polygons;
    for (Ring& ring : rings)
        if (twice_area(ring) < 0) std::ranges::reverse(ring);
    PublishedReading reading;
    reading.hole = PublishedReading::Hole::Signed;
    reading.shared_vertex = shared_vertex;
    return PublishedClipper(reading).visible_areas(rings);
}

/// Splitting, into which case (4) as printed is planted: its answers, and what case (4) as printed changes.
crosscheck::PixelVerdict judge_planted(const PixelCase& c) {
    using enum PublishedReading::SharedVertex;
    VisibleAreas splitting;
    const std::vector<FaceView> faces = c.faces();
    std::vector<crosscheck::Disagreement> faults;
    crosscheck::Claim claim =
        crosscheck::claim_of(splitting(c.pixel, faces, c.nearness()), faces.size(), c.pixel, faults);
    if (!c.depth && inside_the_pixel(c) && std::ranges::none_of(c.polygons, has_repeats_or_no_area)) {
        const std::vector<double> printed = paper_areas(c, AsPrinted), mended = paper_areas(c, OneRule);
        for (std::size_t i = 0; i < faces.size(); ++i) claim.areas[i] += printed[i] - mended[i];
    }
    crosscheck::PixelVerdict verdict =
        crosscheck::PixelComparison()({c.pixel, faces, c.nearness()}, claim,
                                      {.on_disagreement = crosscheck::Proofs::OnDisagreement::Nothing});
    verdict.disagreements.insert(verdict.disagreements.end(), faults.begin(), faults.end());
    for (crosscheck::Disagreement& d : verdict.disagreements) d.case_id = c.id;
    return verdict;
}

/// Two polygons of at most 4 corners with coordinates of at most 4 bits.
bool is_small(const PixelCase& c) {
    return c.polygons.size() == 2 && !c.depth && std::ranges::all_of(c.polygons, [](const Ring& ring) {
               return ring.size() <= 4 && std::ranges::all_of(ring, [](Point p) {
                          return std::max(bits_of(p.x), bits_of(p.y)) <= 4;
                      });
           });
}

Examinee planted() {
    Examinee examinee{.name = "planted", .examine = {}, .make_judge = {}};
    examinee.examine = [](std::span<const PixelCase> cases, std::uint64_t, const auto& finding) {
        crosscheck::CheckSummary summary;
        for (const PixelCase& c : cases) {
            const crosscheck::PixelVerdict verdict = judge_planted(c);
            summary.add(verdict, c.pixel, c.id, c.polygons.size());
            if (!verdict.disagreements.empty()) finding(c, verdict);
        }
        return summary;
    };
    examinee.make_judge = [](bool) { return judge_planted; };
    return examinee;
}

CampaignOptions small_campaign(Engine engine, std::uint64_t count, const std::filesystem::path& folder = {}) {
    CampaignOptions options;
    options.cases = {{Family::Grid4, Family::Notch}, 1, DepthChoice::AsMade};
    options.examinees = {
        examinee_of("engine", {.engine = engine, .contacts = false, .all_rungs_for_first = 0})};
    options.count = count;
    options.folder = folder;
    options.shrunk_per_family = 4;
    return options;
}

std::vector<PixelCase> cases_in(const std::filesystem::path& file, CaseFormat format) {
    std::ifstream in(file);
    const auto next = case_reader(in, file.string(), format);
    std::vector<PixelCase> cases;
    while (auto c = next()) cases.push_back(std::move(*c));
    return cases;
}

std::string complaint(const CampaignOptions& options) {
    try {
        run_campaign(options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no complaint";
}

}  // namespace

TEST_CASE("run_campaign: case (4) as printed, planted, is found and shrunk to two small polygons",
          "[fuzz][campaign][planted]") {
    const ScratchFolder folder("planted");
    CampaignOptions options;
    options.cases = {all_families(), 1, DepthChoice::AsMade};
    options.examinees = {planted()};
    options.count = 12'288;  // an eighth of the 100,000 within which it has to be found
    options.folder = folder.path;
    options.shrunk_per_family = 5;
    const CampaignState state = run_campaign(options);
    CHECK_FALSE(summary_of(state).pass());
    CHECK(state.findings >= 10);
    REQUIRE(state.stored.size() >= 3);
    int smallest = 0;
    for (const std::string& name : state.stored) {
        INFO(name);
        const std::vector<PixelCase> cases = cases_in(folder / (name + ".jsonl"), CaseFormat::PixelCases);
        REQUIRE(cases.size() == 1);
        CHECK(cases[0].id == name);
        CHECK(cases[0].polygons.size() <= 3);
        smallest += is_small(cases[0]);
        // It is still the planted mistake, and nothing else.
        CHECK_FALSE(judge_planted(cases[0]).disagreements.empty());
        CHECK(examinee_of("", {}).make_judge(true)(cases[0]).disagreements.empty());
    }
    // Some need a third polygon, which makes the reflex corner of Fig. 4e, or a corner on an edge, to an ulp.
    CHECK(smallest >= 3);
}

TEST_CASE("run_campaign: engines that are right have no findings, with depth planes and without",
          "[fuzz][campaign]") {
    for (const DepthChoice depth : {DepthChoice::AsMade, DepthChoice::Always, DepthChoice::Never}) {
        CampaignOptions options;
        options.cases = {all_families(), 3, depth};
        options.examinees = {
            examinee_of("splitting", {.all_rungs_for_first = 24}),
            examinee_of("traversal",
                        {.engine = Engine::Traversal, .contacts = false, .all_rungs_for_first = 0})};
        options.count = 240;
        std::uint64_t told = 0;
        const CampaignState state = run_campaign(options, [&](const CampaignState& s) { told = s.done; });
        CHECK(told == 240);
        CHECK(summary_of(state).pass());
        CHECK(summary_of(state).pixels == 240);
        CHECK(state.summaries[0].rungs.cgal >= 24);
        CHECK(state.summaries[1].contacts.checked == 0);
    }
}

TEST_CASE("CaseSeries: planes always or never, the polygons of the family all the same", "[fuzz][campaign]") {
    const CaseSeries as_made{all_families(), 5, DepthChoice::AsMade};
    const CaseSeries always{all_families(), 5, DepthChoice::Always},
        never{all_families(), 5, DepthChoice::Never};
    for (std::uint64_t n = 0; n < 480; ++n) {
        const PixelCase c = as_made(n);
        CHECK(c.id ==
              degenerate_case(as_made.families[n % kFamilyNames.size()], 5, n / kFamilyNames.size()).id);
        CHECK(always(n).polygons == c.polygons);
        REQUIRE(always(n).depth);
        CHECK(always(n).depth->size() == c.polygons.size());
        if (c.depth) CHECK(*always(n).depth == *c.depth);
        CHECK(never(n).polygons == c.polygons);
        CHECK_FALSE(never(n).depth);
        CHECK(never(n).id == c.id + (c.depth ? "/never" : ""));
    }
}

TEST_CASE("run_campaign: a finding is kept as case, WKT, GeoJSON and drawing, the same case in each",
          "[fuzz][campaign]") {
    const ScratchFolder folder("kept");
    const CampaignState state = run_campaign(small_campaign(Engine::Published, 300, folder.path));
    REQUIRE_FALSE(state.stored.empty());
    CHECK(state.stored.size() <= 8);
    CHECK(state.findings > 8);
    for (const std::string& name : state.stored) {
        const PixelCase c = cases_in(folder / (name + ".jsonl"), CaseFormat::PixelCases).at(0);
        CHECK(c.areas);
        for (const auto& [ending, format] :
             {std::pair(".wkt", CaseFormat::Wkt), std::pair(".geojson", CaseFormat::GeoJson)}) {
            const PixelCase same = cases_in(folder / (name + ending), format).at(0);
            CHECK(same.id == c.id);
            CHECK(same.polygons == c.polygons);
            CHECK(same.depth == c.depth);
            CHECK(same.areas == c.areas);
        }
        CHECK(std::filesystem::file_size(folder / (name + ".svg")) > 100);
        std::ifstream file(folder / (name + ".jsonl"));
        const auto found = nlohmann::json::parse(file).at("found");
        CHECK(found.at("engine") == "engine");
        CHECK(found.at("seed") == 1);
        CHECK(found.at("as").get<std::string>().starts_with(found.at("family").get<std::string>()));
        CHECK(found.at("versions").contains("cgal"));
    }
    // Every finding stands in the log as it was found.
    CHECK(cases_in(folder / "campaign/found.log", CaseFormat::PixelCases).size() == state.findings);
}

TEST_CASE("run_campaign: what a summary says survives being written down", "[fuzz][campaign]") {
    const CampaignState state = run_campaign(small_campaign(Engine::Published, 400));
    const crosscheck::CheckSummary& summary = state.summaries[0];
    REQUIRE(summary.disagreement_count > 10);
    const crosscheck::CheckSummary again = fuzz::summary_of(nlohmann::json::parse(json_of(summary).dump()));
    CHECK(crosscheck::summary_json(again) == crosscheck::summary_json(summary));
    CHECK(again.disagreements == summary.disagreements);
}

TEST_CASE("run_campaign: another campaign is not gone on with, and none is written over",
          "[fuzz][campaign][errors]") {
    const ScratchFolder folder("resume");
    CampaignOptions options = small_campaign(Engine::Splitting, 3000, folder.path);
    // An interruption: the first batch is committed, then something is thrown.
    CHECK_THROWS_AS(run_campaign(options,
                                 [](const CampaignState& s) {
                                     if (s.done > 0) throw std::bad_alloc();
                                 }),
                    std::bad_alloc);
    CHECK_THAT(complaint(options), Catch::Contains("state.json") && Catch::Contains("--resume"));
    options.resume = true;
    CampaignOptions other = options;
    other.cases.seed = 2;
    CHECK_THAT(complaint(other),
               Catch::EndsWith("state.json:seed: the campaign to resume has 1, this one 2"));
    const CampaignState state = run_campaign(options);
    CHECK(state.done == 3000);
    CHECK(state.summaries[0].pixels == 3000);
    // At its end it has nothing to add; with a larger count it goes on.
    CHECK(run_campaign(options).summaries[0].pixels == 3000);
    options.count = 3500;
    CHECK(run_campaign(options).summaries[0].pixels == 3500);
    // A campaign that came to its end makes room for a new one.
    options.resume = false;
    options.count = 100;
    CHECK(run_campaign(options).summaries[0].pixels == 100);
    std::ofstream(folder / "campaign/state.json") << "{\"format\": 1}";
    CHECK_THAT(complaint(options), Catch::Contains("is not the state of a campaign"));
    std::ofstream(folder / "campaign/state.json") << "{\"format\": 99}";
    CHECK_THAT(complaint(options), Catch::Contains("another version"));
}

TEST_CASE("run_campaign: one campaign at a time in a folder", "[fuzz][campaign][errors]") {
    const ScratchFolder folder("locked");
    const CampaignOptions options = small_campaign(Engine::Splitting, 10, folder.path);
    const CampaignJournal other(folder.path);
    CHECK_THAT(complaint(options), Catch::Contains("another campaign is at work here"));
}

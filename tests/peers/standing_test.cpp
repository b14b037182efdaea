// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/standing.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "peers/contest.hpp"
#include "peers/table.hpp"
#include "planted.hpp"

using namespace keikan;
using namespace keikan::peers;
using namespace keikan::peers::test;
using Catch::Matchers::Contains;

namespace {

/// Wrong by a little, a lot and everything in between; silent, dead and stuck once each.
Peer wrong_doer() {
    return planted_peer([](int i, Answer& answer) {
        if (i == 1) answer.areas[0] += 2e-13;
        if (i == 2) answer.areas[0] += 2e-12;
        if (i == 3) answer.areas[0] -= 2e-9;
        if (i == 4) answer.background += 2e-6;
        if (i == 5) answer.areas[0] = 0.75;
        if (i == 6) throw std::runtime_error("gives up");
        if (i == 7) raise(SIGSEGV);
        if (i == 8)
            for (;;) pause();
    });
}

std::function<std::optional<PixelCase>()> one_after_the_other(std::vector<PixelCase> cases) {
    return [cases = std::move(cases), at = std::size_t{0}]() mutable -> std::optional<PixelCase> {
        if (at == cases.size()) return std::nullopt;
        return cases[at++];
    };
}

Contest contest_of(const Peer& peer, int pixels) {
    const std::vector<Contestant> one{in_a_fork(peer, {.seconds = 0.2})};
    return contest(one_after_the_other(half_covered_pixels(pixels)), one);
}

}  // namespace

TEST_CASE("contest: a planted wrong-doer is counted in the right columns", "[peers]") {
    const Contest result = contest_of(wrong_doer(), 10);
    CHECK(result.pixels == 10);
    CHECK(result.polygons == 10);
    CHECK(result.certified == 10);
    const Standing& s = result.standings.at(0);
    CHECK(s.all.pixels == 10);
    CHECK(s.all.exceptions == 1);
    CHECK(s.all.crashes == 1);
    CHECK(s.all.hangs == 1);
    CHECK(s.all.wrong == std::array<std::uint64_t, 4>{4, 3, 2, 1});
    CHECK(s.all.largest_error == Approx(0.25).epsilon(1e-12));
    CHECK(s.worst == "half/1/5");
    CHECK(s.largest_sum_error == Approx(0.25).epsilon(1e-12));
    REQUIRE(s.by_family.size() == 1);
    CHECK(s.by_family.at("half") == s.all);
    REQUIRE(result.worst.at(0));
    CHECK(result.worst[0]->pixel_case.id == "half/1/7");  // a crash is worse than anything
}

TEST_CASE("contest: without failures, the worst is the pixel with the largest error", "[peers]") {
    const Contest result =
        contest_of(planted_peer([](int i, Answer& answer) { answer.areas[0] += 1e-3 * (i % 4); }), 8);
    REQUIRE(result.worst.at(0));
    CHECK(result.worst[0]->pixel_case.id == "half/1/3");
    CHECK(result.worst[0]->error == Approx(3e-3).epsilon(1e-9));
}

TEST_CASE("contest: a promise is broken by a wrong area and by a failure", "[peers]") {
    Contestant contestant = in_a_fork(wrong_doer(), {.seconds = 0.2});
    contestant.promised_error = [](std::size_t faces) {
        CHECK(faces == 1);
        return 1e-12;
    };
    const Contest result = contest(one_after_the_other(half_covered_pixels(10)), std::span(&contestant, 1));
    CHECK(result.standings[0].promises);
    CHECK(result.standings[0].broken_promises == 7);  // wrong by more than 1e-12: 4; no answer: 3
}

TEST_CASE("contest: what was not asked counts nowhere else", "[peers]") {
    std::vector<PixelCase> cases = half_covered_pixels(3);
    cases[0].depth = {{0, 0, 1}};
    const std::vector<Contestant> two{in_a_fork(geos(), {}), in_a_fork(splitting(), {})};
    const Contest result = contest(one_after_the_other(std::move(cases)), two);
    CHECK(result.standings[0].all.pixels == 2);
    CHECK(result.standings[0].not_asked == 1);
    CHECK_FALSE(result.standings[0].knows_depth);
    CHECK(result.standings[1].all.pixels == 3);
    CHECK(result.standings[1].all.wrong == std::array<std::uint64_t, 4>{0, 0, 0, 0});
}

namespace {

std::vector<Standing> two_standings() {
    Standing quick, slow;
    quick.name = "quick";
    quick.all = {
        .pixels = 200, .exceptions = 0, .crashes = 0, .hangs = 0, .wrong = {}, .largest_error = 4.4e-16};
    quick.seconds = 0.5;
    quick.timed_pixels = 200;
    slow.name = "slow";
    slow.version = "slow 2.0";
    slow.all = {.pixels = 200,
                .exceptions = 3,
                .crashes = 2,
                .hangs = 1,
                .wrong = {100, 50, 10, 1},
                .largest_error = 0.25};
    slow.by_family["half"] = slow.all;
    slow.seconds = 2;
    slow.timed_pixels = 100;
    slow.worst = "half/1/5";
    return {quick, slow};
}

}  // namespace

TEST_CASE("table: 200 pixels in half a second are 400 a second, 50 are an eighth of that", "[peers]") {
    const std::vector<Standing> standings = two_standings();
    const std::string text = table_in_markdown(standings);
    CHECK_THAT(text, Contains("| quick | 200 | 0 | 0 | 0 | 0 | 0 | 0 | 0 | 4.4e-16 | 400 | 1.000 |\n"));
    CHECK_THAT(
        text,
        Contains("| slow | 200 | 3 | 2 | 1 | 100 (50 %) | 50 (25 %) | 10 (5 %) | 1 (0.5 %) | 0.25 | 50 | "
                 "0.125 |\n"));
}

TEST_CASE("table: the same in JSON", "[peers]") {
    const nlohmann::json rows = nlohmann::json::parse(table_in_json(two_standings()));
    REQUIRE(rows.size() == 2);
    const nlohmann::json& slow = rows[1];
    CHECK(slow["name"] == "slow");
    CHECK(slow["version"] == "slow 2.0");
    CHECK(slow["pixels"] == 200);
    CHECK(slow["exceptions"] == 3);
    CHECK(slow["crashes"] == 2);
    CHECK(slow["hangs"] == 1);
    CHECK(slow["wrong"] == nlohmann::json{{"1e-12", 100}, {"1e-9", 50}, {"1e-6", 10}, {"1e-3", 1}});
    CHECK(slow["wrong_share"]["1e-3"] == 0.005);
    CHECK(slow["largest_error"] == 0.25);
    CHECK(slow["pixels_per_second"] == 50);
    CHECK(slow["of_best"] == 0.125);
    CHECK(slow["worst"] == "half/1/5");
    CHECK(slow["families"]["half"]["crashes"] == 2);
}

TEST_CASE("chart: a bar for each share and each speed, none where there is nothing wrong", "[peers]") {
    const std::string svg = table_as_chart(two_standings());
    CHECK(svg.starts_with("<svg "));
    CHECK(svg.ends_with("</svg>\n"));
    CHECK_THAT(svg, Contains(">quick</text>") && Contains(">slow</text>") && Contains(">none</text>"));
    std::size_t bars = 0;
    for (std::size_t at = svg.find("<rect"); at != std::string::npos; at = svg.find("<rect", at + 1)) ++bars;
    // Background; five keys of the legend; a speed each; of the slow one four shares and the failures.
    CHECK(bars == 1 + 5 + 2 + 5);
    // 200 pixels: the axis begins at 10^-3, so the share of 0.5 reaches 1 + log10(0.5) / 3 of its 300.
    CHECK_THAT(svg, Contains("width=\"269.9\" height=\"16.0\" fill=\"#fde0c5\""));
}

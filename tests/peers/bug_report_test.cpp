// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/bug_report.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <stdexcept>

#include "fuzz/shrink_case.hpp"
#include "peers/contest.hpp"
#include "planted.hpp"

using namespace keikan;
using namespace keikan::peers;
using namespace keikan::peers::test;
using Catch::Matchers::Contains;

namespace {

PixelCase five_boxes() {
    PixelCase made;
    made.id = "boxes/1/0";
    made.polygons = {box(0, 0, 0.25, 0.25), box(0.5, 0, 0.75, 0.25), box(0, 0.5, 0.25, 0.75),
                     box(0.5, 0.5, 0.75, 0.75), box(0, 0, 1, 1)};
    return made;
}

/// Right, unless both the third box and the whole pixel are asked about: then it forgets to subtract.
Peer forgetful(bool throws) {
    return {.name = "forgetful", .version = "forgetful 1.0", .start = [throws]() -> Ask {
                return [ask = splitting().start(), throws](const PreparedPixel& pixel, Answer& answer) {
                    ask(pixel, answer);
                    const auto has = [&](const Ring& ring) {
                        return std::ranges::count(pixel.in_pixel, ring) == 1;
                    };
                    if (!has(box(0, 0.5, 0.25, 0.75)) || !has(box(0, 0, 1, 1))) return;
                    if (throws) throw std::runtime_error("forgot what to subtract");
                    answer.areas.back() += 1.0 / 16;
                };
            }};
}

Finding finding_of(const Contestant& contestant) {
    bool given = false;
    const Contest result = contest(
        [&]() -> std::optional<PixelCase> {
            if (std::exchange(given, true)) return std::nullopt;
            return five_boxes();
        },
        std::span(&contestant, 1));
    REQUIRE(result.worst.at(0));
    return *result.worst[0];
}

}  // namespace

namespace {

Finding shrunk(const Finding& finding, const Contestant& contestant) {
    TruthTeller truth;
    const auto still_shows = [&](const PixelCase& smaller) {
        return shows_the_same(asked_about(smaller, contestant, truth), finding);
    };
    PixelCase smallest = fuzz::shrunk(finding.pixel_case, still_shows);
    smallest.id = finding.pixel_case.id;
    return asked_about(std::move(smallest), contestant, truth);
}

}  // namespace

TEST_CASE("bug report: a wrong area is shrunk to the polygons that it takes", "[peers]") {
    const Contestant contestant = in_a_fork(forgetful(false), {});
    const Finding finding = finding_of(contestant);
    CHECK(finding.error == Approx(1.0 / 16).epsilon(1e-12));
    const Finding smallest = shrunk(finding, contestant);
    CHECK(smallest.pixel_case.polygons == std::vector<Ring>{box(0, 0.5, 0.25, 0.75), box(0, 0, 1, 1)});
    CHECK(smallest.error == Approx(1.0 / 16).epsilon(1e-12));

    const std::string report = bug_report(smallest, contestant, "keikan-verify peers --show boxes:forgetful");
    CHECK_THAT(report, Contains("# forgetful 1.0: wrong area by 0.0625"));
    CHECK_THAT(report, Contains("1. `POLYGON ((0 0.5, 0.25 0.5, 0.25 0.75, 0 0.75, 0 0.5))`"));
    CHECK_THAT(report, Contains("2. `POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))`"));
    CHECK_THAT(report, Contains("| polygon 1 | 0.0625 | 0.0625 | 1/16 |"));
    CHECK_THAT(report, Contains("| polygon 2 | 1 | 0.9375 | 15/16 |"));
    CHECK_THAT(report, Contains("{\"id\": \"boxes/1/0\""));
    CHECK_THAT(report, Contains("`keikan-verify peers --show boxes:forgetful`"));
}

TEST_CASE("bug report: an exception is shrunk and told with its message", "[peers]") {
    const Contestant contestant = in_a_fork(forgetful(true), {});
    const Finding smallest = shrunk(finding_of(contestant), contestant);
    CHECK(smallest.pixel_case.polygons.size() == 2);
    const std::string report = bug_report(smallest, contestant, "");
    CHECK_THAT(report, Contains("# forgetful 1.0: no answer: forgot what to subtract"));
    CHECK_THAT(report, Contains("| polygon 2 |  | 0.9375 | 15/16 |"));
}

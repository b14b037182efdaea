// SPDX-License-Identifier: GPL-3.0-or-later
#include "crosscheck/check_cases.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "keikan/clip/visible_areas.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"

using namespace keikan;
using namespace keikan::crosscheck;

namespace {

CheckSummary checked(const std::string& text, const CaseCheckOptions& options = {}) {
    std::istringstream in(text);
    return check_cases(in, "cases.jsonl", options);
}

CheckSummary checked_file(const std::filesystem::path& path) {
    std::ifstream in(path);
    return check_cases(in, path.string(), {});
}

const std::string kHalf = R"("polygons": [[[0, 0], [1, 0], [1, 1]]], "areas": ["1/2"], "background": )";

}  // namespace

TEST_CASE("check_cases: the collection of degenerate cases holds, every rung and every stated answer",
          "[crosscheck][degenerate]") {
    CheckSummary all;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(KEIKAN_SOURCE_DIR "/data/degenerate")) {
        if (entry.path().extension() != ".jsonl") continue;
        if (entry.path().parent_path().filename() == "known_failures") continue;
        INFO(entry.path().filename());
        const CheckSummary summary = checked_file(entry.path());
        for (const Disagreement& d : summary.disagreements) FAIL_CHECK(text_of(d));
        all += summary;
    }
    CHECK(all.pixels >= 82);
    CHECK(all.rungs.cgal == all.pixels);
    CHECK(all.max_area_error <= kVisibleAreaError);
}

TEST_CASE("check_cases: the hard cases from outside hold within 1e-15", "[crosscheck][degenerate]") {
    const char* const folder = std::getenv("KEIKAN_SHARED_DATA");
    const std::filesystem::path data = folder ? folder : KEIKAN_SOURCE_DIR "/../shared/data";
    if (!std::filesystem::exists(data / "hard_cases.jsonl")) {
        WARN("skipped: there is no hard_cases.jsonl (set KEIKAN_SHARED_DATA)");
        return;
    }
    const CheckSummary summary = checked_file(data / "hard_cases.jsonl");
    CHECK(summary.pixels == 140);
    CHECK(summary.pass());
    CHECK(summary.max_area_error <= 1e-15);
    CHECK(summary.max_sum_error <= 1e-15);
}

TEST_CASE("check_cases: a stated answer that is wrong fails, and says which", "[crosscheck][planted]") {
    CHECK(checked("{" + kHalf + "\"1/2\"}").pass());
    const CheckSummary summary = checked("{" + kHalf + "\"1/2\"}\n{\"id\": \"bad\", " + kHalf + "\"1/3\"}");
    CHECK_FALSE(summary.pass());
    REQUIRE(summary.disagreements.size() == 1);
    CHECK(summary.disagreements[0].kind == Disagreement::Kind::Given);
    CHECK(summary.disagreements[0].case_id == "bad");
}

TEST_CASE("check_cases: bad input is said with its line", "[crosscheck][errors]") {
    CHECK_THROWS_WITH(checked("{\"polygons\": []}\n{]"), Catch::StartsWith("cases.jsonl:2: broken JSON"));
}

TEST_CASE("check_cases: thousands of cases give the same summary for any number of threads",
          "[crosscheck][threads]") {
    std::string text;
    for (int i = 0; i < 1500; ++i) {
        const std::string at = std::to_string(i / 2048.0);
        text += "{\"polygons\": [[[0, 0], [1, " + at + "], [" + at +
                ", 1]], [[0, 1], [1, 0], [1, 1], [0.75, 1]]]}\n";
    }
    CaseCheckOptions options;
    options.all_rungs_for_first = 8;
    const auto with_threads = [&](int threads) {
        const ThreadLimit limit(threads);
        return checked(text, options);
    };
    const CheckSummary one = with_threads(1), two = with_threads(2);
    CHECK(one.pixels == 1500);
    CHECK(one.pass());
    CHECK(one.rungs.rational > 8);
    CHECK(one.rungs.cgal < one.rungs.rational);
    CHECK(summary_json(one) == summary_json(two));
}

TEST_CASE("summary_json: has every key that others rely on", "[crosscheck]") {
    CheckSummary summary = checked("{" + kHalf + "\"1/3\"}");
    summary.seconds = 1.5;
    const auto json = nlohmann::json::parse(summary_json(summary));
    CHECK(json["verdict"] == "fail");
    CHECK(json["pixels"] == 1);
    CHECK(json["polygons"] == 1);
    CHECK(json["max_area_error"] <= kVisibleAreaError);
    CHECK(json["max_sum_error"] <= kVisibleAreaError);
    // The face's four corners against the pixel's border, two of them on its corners and two inside its
    // sides.
    CHECK(json["classification"]["checked"] > 0);
    CHECK(json["classification"]["mismatches"] == 0);
    CHECK(json["oracle"] == nlohmann::json{{"cgal", 1}, {"rational", 1}, {"quad", 1}, {"certified", 1}});
    CHECK(json["worst"].size() == 1);
    CHECK(json["worst"][0]["pixel"] == nlohmann::json{0, 0});
    CHECK(json["worst"][0].contains("error"));
    CHECK(json["seconds"] == 1.5);
    CHECK(nlohmann::json::parse(summary_json(CheckSummary()))["verdict"] == "pass");
}

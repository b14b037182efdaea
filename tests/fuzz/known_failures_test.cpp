// SPDX-License-Identifier: GPL-3.0-or-later
//
// data/degenerate/known_failures: cases that an engine still answers wrongly, with the engine in
// "found": {"engine": ...}. The day one of them passes, the test here fails and says which.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../support/scratch_folder.hpp"
#include "fuzz/examinee.hpp"
#include "keikan/cases/pixel_case_file.hpp"

using namespace keikan;

namespace {

const std::filesystem::path kFolder = KEIKAN_SOURCE_DIR "/data/degenerate/known_failures";

Engine engine_of(const nlohmann::json& line) {
    const std::string name = line.at("found").at("engine");
    if (name == "published") return Engine::Published;
    if (name == "traversal") return Engine::Traversal;
    REQUIRE(name == "splitting");
    return Engine::Splitting;
}

struct Review {
    int cases = 0;
    std::vector<std::string> passing;
};

Review review(const std::filesystem::path& folder) {
    Review result;
    if (!std::filesystem::exists(folder)) return result;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".jsonl") continue;
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line); ++result.cases) {
            std::istringstream in(line);
            const PixelCase c = PixelCaseReader(in, entry.path().string()).next().value();
            const Engine engine = engine_of(nlohmann::json::parse(line));
            const bool contacts = engine == Engine::Traversal;
            const auto judge =
                fuzz::examinee_of("", {.engine = engine, .contacts = contacts}).make_judge(false);
            if (judge(c).disagreements.empty()) result.passing.push_back(c.id);
        }
    }
    return result;
}

}  // namespace

TEST_CASE("known failures: each of them still fails; one that passes moves to the other cases",
          "[fuzz][degenerate]") {
    const Review result = review(kFolder);
    for (const std::string& id : result.passing)
        FAIL_CHECK(id << " passes now: move it from known_failures to data/degenerate/<its family>");
    CHECK(result.cases >= 5);
}

TEST_CASE("known failures: one that passes is told", "[fuzz][degenerate]") {
    const ScratchFolder folder("known");
    std::ofstream(folder / "planted.jsonl")
        << R"({"id": "right", "polygons": [[[0, 0], [1, 0], [0, 1]]], "found": {"engine": "splitting"}})"
           "\n"
           R"({"id": "wrong", "polygons": [[[0, 0], [0, 0.5], [1, 1]], [[0, 0], [0.5, 0.5], [0.5, 0]]],)"
           R"( "found": {"engine": "published"}})"
           "\n";
    const Review result = review(folder.path);
    CHECK(result.cases == 2);
    CHECK(result.passing == std::vector<std::string>{"right"});
}

// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "../support/scratch_folder.hpp"
#include "run_keikan.hpp"

namespace {

std::string half_cases(int count) {
    std::string lines;
    for (int i = 0; i < count; ++i)
        lines += R"({"polygons": [[[0, 0], [0.5, 0], [0.5, 1], [0, 1]]]})"
                 "\n";
    return lines;
}

}  // namespace

TEST_CASE("keikan areas: a line for each case, an area for each polygon, in the order given",
          "[app][areas]") {
    const Run run = run_keikan(
        "areas",
        R"({"id": "say \"half\"", "polygons": [[[0, 0], [0.5, 0], [0.5, 1], [0, 1]], [[0, 0], [0, 1], [0.25, 0]]]})"
        "\n\n"
        R"({"polygons": [], "pixel": [3, 4]})"
        "\n"
        R"({"id": "third", "polygons": [["0x0p0", "0x0p0"]], "x": 1})"
        "\n");
    // The third line is no polygon of points: what stands before it is answered.
    CHECK(run.exit_code == 2);
    CHECK(run.complains_in_one_line());
    CHECK_THAT(run.err, Catch::Contains("standard input:4"));
    CHECK(run.out ==
          "{\"id\": \"say \\\"half\\\"\", \"areas\": [0.5, 0], \"background\": 0.5}\n"
          "{\"id\": \"3\", \"areas\": [], \"background\": 1}\n");
}

TEST_CASE("keikan areas: numbers have 17 significant digits, which name the same double", "[app][areas]") {
    const Run run = run_keikan("areas", R"({"polygons": [[[0, 0], [0.1, 0], [0.1, 0.7], [0, 0.7]]]})");
    REQUIRE(run.exit_code == 0);
    const double area = nlohmann::json::parse(run.out)["areas"][0].get<double>();
    CHECK(area == Approx(0.07).margin(2e-15).epsilon(0));  // kVisibleAreaError
    char digits[40];
    std::snprintf(digits, sizeof digits, "\"areas\": [%.17g]", area);
    CHECK_THAT(run.out, Catch::Contains(digits));
}

TEST_CASE("keikan areas: no case at all is no line at all", "[app][areas]") {
    const Run run = run_keikan("areas -");
    CHECK(run.exit_code == 0);
    CHECK(run.out.empty());
    CHECK(run.err.empty());
}

TEST_CASE("keikan areas: the bytes do not depend on the number of threads", "[app][areas][threads]") {
    std::string input = half_cases(3000);
    for (const auto& file :
         std::filesystem::recursive_directory_iterator(KEIKAN_SOURCE_DIR "/data/degenerate"))
        if (file.path().extension() == ".jsonl") input += contents(file.path());
    const Run one = run_keikan("areas --threads 1", input);
    CHECK(one.exit_code == 0);
    CHECK(run_keikan("areas --threads 2", input).out == one.out);
    CHECK(run_keikan("--threads 8 areas -", input).out == one.out);
}

TEST_CASE("keikan areas: answers come while the questions still go on", "[app][areas]") {
    // The second question is asked when the first has been answered, as a program at the other end would;
    // after ten seconds without an answer it gives up and asks nothing more.
    const ScratchFolder folder("app");
    std::ofstream(folder / "lockstep.sh") << R"sh(cd "$(dirname "$0")" && mkfifo questions && : > answers
        { echo '{"id": "first", "polygons": []}'
          for i in $(seq 1000); do [ -s answers ] && echo '{"id": "second", "polygons": []}' && break; sleep 0.01; done
        } > questions &
        ")sh" KEIKAN_PROGRAM R"sh(" areas < questions > answers)sh";
    REQUIRE(std::system(("sh " + (folder / "lockstep.sh").string()).c_str()) == 0);
    CHECK_THAT(contents(folder / "answers"), Catch::Contains("first") && Catch::Contains("second"));
}

TEST_CASE("keikan pixel: its line is answered by keikan areas", "[app][pixel]") {
    const Run pixel = run_keikan("pixel " + hill() + " --at 160,75");
    REQUIRE(pixel.exit_code == 0);
    const auto question = nlohmann::json::parse(pixel.out);
    CHECK(question["id"] == "160,75");
    CHECK(question["pixel"] == nlohmann::json::array({160, 75}));
    REQUIRE(question["polygons"].size() == question["depth"].size());
    CHECK(question["objects"].size() == question["polygons"].size());
    const Run areas = run_keikan("areas", pixel.out);
    REQUIRE(areas.exit_code == 0);
    const auto answer = nlohmann::json::parse(areas.out);
    double sum = answer["background"].get<double>();
    for (const auto& area : answer["areas"]) sum += area.get<double>();
    CHECK(sum == Approx(1).margin(4e-15));  // kAreaSumError
}

TEST_CASE("keikan areas: --outlines tells the visible outlines, whose areas are the areas", "[app][areas]") {
    const std::string hole = R"({"polygons": [[[0.25, 0.25], [0.75, 0.25], [0.75, 0.75], [0.25, 0.75]],
        [[0, 0], [1, 0], [1, 1], [0, 1]]]})";
    std::string line = hole;
    std::erase(line, '\n');
    const Run run = run_keikan("areas --engine traversal --outlines", line + "\n");
    REQUIRE(run.exit_code == 0);
    const auto answer = nlohmann::json::parse(run.out);
    CHECK(answer["areas"] == nlohmann::json::array({0.25, 0.75}));
    REQUIRE(answer["outlines"].size() == 3);  // the square; the pixel around it, and its hole
    CHECK(answer["outlines"][0]["face"] == 0);
    CHECK(answer["outlines"][1]["face"] == 1);
    CHECK(answer["outlines"][2]["face"] == 1);
    CHECK(answer["outlines"][1]["sign"].get<int>() * answer["outlines"][2]["sign"].get<int>() == -1);
    CHECK(run_keikan("areas --outlines", line).exit_code == 2);
}

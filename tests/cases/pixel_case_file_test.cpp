// SPDX-License-Identifier: Apache-2.0
#include "keikan/cases/pixel_case_file.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "keikan/support/input_error.hpp"

using namespace keikan;

namespace {

std::vector<PixelCase> cases_of(const std::string& text) {
    std::istringstream in(text);
    PixelCaseReader reader(in, "cases.jsonl");
    std::vector<PixelCase> cases;
    while (auto next = reader.next()) cases.push_back(std::move(*next));
    return cases;
}

/// The message that reading `text` ends with.
std::string complaint(const std::string& text) {
    try {
        cases_of(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no complaint";
}

/// The complaint about a case whose polygon is the one given.
std::string complaint_of_polygon(const std::string& polygon) {
    return complaint("{\"polygons\": [" + polygon + "]}");
}

const std::string kTriangle = "[[0, 0], [1, 0], [0, 1]]";

}  // namespace

TEST_CASE("PixelCaseReader: every key is read, others are ignored", "[cases]") {
    const auto cases = cases_of(
        R"({"id": "a", "why": {"x": [1]}, "pixel": [412, -3], "polygons": [[[412, -3], [413, -3], [412, -2]]],)"
        R"( "depth": [[1, 2.5, "-0x1p-3"]], "areas": ["1/2"], "background": "1/2"})");
    REQUIRE(cases.size() == 1);
    const PixelCase& a = cases[0];
    CHECK(a.id == "a");
    CHECK(a.pixel == PixelIndex{412, -3});
    CHECK(a.polygons == std::vector<Ring>{{{412, -3}, {413, -3}, {412, -2}}});
    CHECK(a.depth == std::vector<DepthPlane>{{1, 2.5, -0.125}});
    CHECK(a.areas == std::vector<std::string>{"1/2"});
    CHECK(a.background == "1/2");
    CHECK(a.nearness() == Nearness::ByDepth);
}

TEST_CASE("PixelCaseReader: what is left out has its documented value", "[cases]") {
    const auto cases = cases_of("\n  \r\n{\"polygons\": []}\r\n{\"polygons\": [" + kTriangle + "]}");
    REQUIRE(cases.size() == 2);
    CHECK(cases[0].id == "3");
    CHECK(cases[0].pixel == PixelIndex{0, 0});
    CHECK(cases[0].polygons.empty());
    CHECK_FALSE(cases[0].areas);
    CHECK(cases[1].id == "4");
    CHECK(cases[1].nearness() == Nearness::InOrder);
}

TEST_CASE("PixelCaseReader: a coordinate is exactly the double that it names", "[cases][exact]") {
    const auto cases = cases_of(
        R"({"polygons": [[[0.1, "0x1.999999999999ap-4"], ["0X1P-1074", 5e-324], [9007199254740993, -0.0]]]})"
        "\n"
        // 1 + 2^-53 exactly, which is a tie to even, and one digit more at its far end
        R"({"polygons": [[[1.00000000000000011102230246251565404236316680908203125, 18446744073709551617],)"
        R"( [1.00000000000000011102230246251565404236316680908203126, 123456789012345678901234567890]]]})");
    const Ring& ring = cases[0].polygons[0];
    CHECK(ring[0].x == ring[0].y);
    CHECK(ring[1].x == std::numeric_limits<double>::denorm_min());
    CHECK(ring[1].y == std::numeric_limits<double>::denorm_min());
    CHECK(ring[2].x == 9007199254740992.0);
    CHECK(cases[1].polygons[0][0].x == 1.0);
    CHECK(cases[1].polygons[0][0].y == 18446744073709551616.0);
    CHECK(cases[1].polygons[0][1].x == 1.0 + std::numeric_limits<double>::epsilon());
    CHECK(cases[1].polygons[0][1].y == 123456789012345678901234567890.0);
}

TEST_CASE("PixelCaseReader: bad input is said with file, line and reason", "[cases][errors]") {
    CHECK(complaint("{\"polygons\": []}\n\n{\"polygons\": [}") ==
          "cases.jsonl:3: broken JSON near column 15");
    CHECK(complaint("[]") == "cases.jsonl:1: a pixel case is a JSON object");
    CHECK(complaint("{}") == "cases.jsonl:1: has no \"polygons\"");
    CHECK(complaint("{\"polygons\": 3}") == "cases.jsonl:1: polygons is not an array");
    CHECK(complaint("{\"polygons\": [], \"id\": []}") == "cases.jsonl:1: id is not a string");
    CHECK(complaint_of_polygon("[[0, 0], [2, 0], [2, 2], [1, 0.5]]") ==
          "cases.jsonl:1: polygons[0] is not convex");
    CHECK(complaint_of_polygon(kTriangle + ", [[0, 0, 0]]") ==
          "cases.jsonl:1: polygons[1][0] is not an array of 2 coordinates");
    CHECK(complaint_of_polygon("[[null, 0]]") == "cases.jsonl:1: polygons[0][0][0] is not a number");
    CHECK(complaint_of_polygon("7") == "cases.jsonl:1: polygons[0] is not an array");
}

TEST_CASE("PixelCaseReader: a number that is not finite is bad input", "[cases][errors]") {
    CHECK(complaint_of_polygon("[[NaN, 0]]").starts_with("cases.jsonl:1: broken JSON"));
    CHECK(complaint_of_polygon("[[Infinity, 0]]").starts_with("cases.jsonl:1: broken JSON"));
    CHECK(complaint_of_polygon("[[1e999, 0]]") ==
          "cases.jsonl:1: a number is not finite: it lies beyond the range of a double");
    CHECK(complaint_of_polygon("[[\"0x1p1024\", 0]]") == "cases.jsonl:1: polygons[0][0][0] is not finite");
    for (const char* text :
         {"inf", "nan", "0.5", "", "0x", "0x1p", " 0x1p0", "0x1p0 ", "0x1g", "--0x1p0", "0x1p0\\u0000"})
        CHECK_THAT(complaint_of_polygon("[[\"" + std::string(text) + "\", 0]]"),
                   Catch::Contains("polygons[0][0][0] is a string, but not a hexadecimal float"));
}

TEST_CASE("PixelCaseReader: the pixel is two whole numbers within 2^30", "[cases][errors]") {
    CHECK(cases_of(R"({"pixel": [1073741824, -1073741824.0], "polygons": []})")[0].pixel ==
          PixelIndex{1 << 30, -(1 << 30)});
    CHECK(complaint(R"({"pixel": [1073741825, 0], "polygons": []})") ==
          "cases.jsonl:1: pixel[0] is beyond 2^30");
    CHECK(complaint(R"({"pixel": [0, 0.5], "polygons": []})") ==
          "cases.jsonl:1: pixel[1] is not a whole number");
    CHECK(complaint(R"({"pixel": ["0x1p0", 0], "polygons": []})") ==
          "cases.jsonl:1: pixel[0] is not a whole number");
    CHECK(complaint(R"({"pixel": [0], "polygons": []})") ==
          "cases.jsonl:1: pixel is not an array of 2 whole numbers");
}

TEST_CASE("PixelCaseReader: depth and areas run beside the polygons", "[cases][errors]") {
    const std::string one = "{\"polygons\": [" + kTriangle + "], ";
    CHECK(complaint(one + "\"depth\": []}") == "cases.jsonl:1: depth has 0 entries for 1 polygons");
    CHECK(complaint(one + "\"depth\": [[1, 2]]}") == "cases.jsonl:1: depth[0] is not an array of 3 numbers");
    CHECK(complaint(one + "\"areas\": [\"1\", \"0\"]}") ==
          "cases.jsonl:1: areas has 2 entries for 1 polygons");
    CHECK(complaint(one + "\"areas\": [0.5]}") == "cases.jsonl:1: areas[0] is not a string \"p/q\"");
    for (const char* text : {"", "-", "1/", "/2", "1.5", "1/-2", "a", "1/2/3"})
        CHECK(complaint(one + "\"areas\": [\"" + text + "\"]}") ==
              "cases.jsonl:1: areas[0] is not a fraction \"p/q\"");
    CHECK(complaint(one + "\"background\": \"1/00\"}") == "cases.jsonl:1: background has the denominator 0");
}

TEST_CASE("pixel_case_line: the line names the same case again", "[cases]") {
    PixelCase original;
    original.id = "quote \" and \\ and \n";
    original.pixel = {4095, 2159};
    original.polygons = {{{0.1, -0.0}, {1e6 + 1.0 / 3, 5e-324}, {1.0 / 3, 1e22}}, {}};
    original.depth = std::vector<DepthPlane>{{1e-300, 2, 3}, {0, 0, -1.7976931348623157e308}};
    original.areas = std::vector<std::string>{"1/3", "0"};
    original.background = "2/3";
    const std::string line = pixel_case_line(original);
    CHECK(line.find('\n') == line.npos);
    const PixelCase again = cases_of(line).at(0);
    CHECK(again.id == original.id);
    CHECK(again.pixel == original.pixel);
    CHECK(again.polygons == original.polygons);
    CHECK(std::signbit(again.polygons[0][0].y));
    CHECK(again.depth == original.depth);
    CHECK(again.areas == original.areas);
    CHECK(again.background == original.background);
}

TEST_CASE("PixelCaseReader: the whole collection of degenerate cases can be read", "[cases][degenerate]") {
    int cases = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(KEIKAN_SOURCE_DIR "/data/degenerate")) {
        if (entry.path().extension() != ".jsonl") continue;
        std::ifstream file(entry.path());
        PixelCaseReader reader(file, entry.path().filename().string());
        while (const auto next = reader.next()) {
            CHECK(next->areas);
            CHECK(next->background);
            ++cases;
        }
    }
    CHECK(cases >= 82);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The shared collection of hard pixels, with exact answers worked out elsewhere.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "keikan/model/pixel_case.hpp"
#include "oracle/exact_areas.hpp"

using namespace keikan;
using namespace keikan::oracle;

namespace {

std::filesystem::path shared_hard_cases() {
    if (const char* folder = std::getenv("KEIKAN_SHARED_DATA"))
        return std::filesystem::path(folder) / "hard_cases.jsonl";
    return std::filesystem::path(KEIKAN_SOURCE_DIR) / "../shared/data/hard_cases.jsonl";
}

double number(const nlohmann::json& value) {
    return value.is_string() ? std::strtod(value.get<std::string>().c_str(), nullptr) : value.get<double>();
}

mpq_class fraction(const nlohmann::json& text) {
    mpq_class number(text.get<std::string>());
    number.canonicalize();
    return number;
}

PixelCase pixel_case(const nlohmann::json& line) {
    PixelCase question;
    question.id = line.at("id");
    if (line.contains("pixel")) question.pixel = {line["pixel"][0], line["pixel"][1]};
    for (const auto& polygon : line.at("polygons")) {
        Ring& ring = question.polygons.emplace_back();
        for (const auto& point : polygon) ring.push_back({number(point[0]), number(point[1])});
    }
    if (line.contains("depth")) {
        question.depth.emplace();
        for (const auto& plane : line["depth"])
            question.depth->push_back({number(plane[0]), number(plane[1]), number(plane[2])});
    }
    return question;
}

}  // namespace

TEST_CASE("oracle: every rung gives the known answers of the shared hard cases", "[oracle]") {
    std::ifstream file(shared_hard_cases());
    if (!file) {
        WARN("skipped: no shared hard_cases.jsonl here");
        return;
    }
    CertifiedSplitting certified_areas;
    int count = 0;
    for (std::string text; std::getline(file, text); ++count) {
        const auto line = nlohmann::json::parse(text);
        const PixelCase question = pixel_case(line);
        const auto faces = question.faces();
        INFO(question.id);
        ExactAreas known;
        for (const auto& area : line.at("areas")) known.areas.push_back(fraction(area));
        known.background = fraction(line.at("background"));
        REQUIRE(areas_by_boolean_sets(question.pixel, faces, question.nearness()) == known);
        REQUIRE(areas_by_rational_splitting(question.pixel, faces, question.nearness()) == known);
        const auto certified = certified_areas(question.pixel, faces, question.nearness());
        REQUIRE(certified.certified);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const mpq_class difference = known.areas[i] - mpq_class(certified.areas[i].value);
            REQUIRE(difference <= mpq_class(certified.areas[i].error));
            REQUIRE(-difference <= mpq_class(certified.areas[i].error));
        }
    }
    CHECK(count > 0);
}

// SPDX-License-Identifier: Apache-2.0
#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "keikan/clip/visible_areas.hpp"

namespace {

using namespace keikan;
using Rational = boost::multiprecision::cpp_rational;
using nlohmann::json;

std::filesystem::path shared_data() {
    const char* const given = std::getenv("KEIKAN_SHARED_DATA");
    return given != nullptr ? std::filesystem::path(given)
                            : std::filesystem::path(KEIKAN_SOURCE_DIR) / ".." / "shared" / "data";
}

double number(const json& value) {
    return value.is_string() ? std::strtod(value.get<std::string>().c_str(), nullptr) : value.get<double>();
}

double distance(double a, const json& exact) {
    const Rational difference = Rational(a) - Rational(exact.get<std::string>());
    return std::abs(static_cast<double>(difference));
}

}  // namespace

TEST_CASE("visible_areas: the collected hard cases are right within 1e-15", "[clip][degenerate]") {
    std::ifstream file(shared_data() / "hard_cases.jsonl");
    if (!file) {
        WARN("skipped: no hard_cases.jsonl; set KEIKAN_SHARED_DATA to the folder that holds it");
        return;
    }
    constexpr double kBound = 1e-15;
    VisibleAreas visible_areas;
    int cases = 0;
    for (std::string line; std::getline(file, line); ++cases) {
        const json given = json::parse(line);
        std::vector<Ring> rings;
        for (const json& polygon : given["polygons"]) {
            Ring ring;
            for (const json& p : polygon) ring.push_back({number(p[0]), number(p[1])});
            rings.push_back(ring);
        }
        std::vector<FaceView> faces;
        for (const Ring& ring : rings) faces.push_back({static_cast<FaceId>(faces.size()), ring, {}});
        const PixelCoverage seen = visible_areas({0, 0}, faces, Nearness::InOrder);
        std::vector<double> areas(faces.size());
        for (const VisiblePart& part : seen.parts) areas[part.face] = part.area;
        INFO(given["id"].get<std::string>());
        for (std::size_t i = 0; i < faces.size(); ++i) CHECK(distance(areas[i], given["areas"][i]) <= kBound);
        CHECK(distance(seen.background, given["background"]) <= kBound);
    }
    CHECK(cases >= 140);
}

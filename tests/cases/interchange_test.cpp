// SPDX-License-Identifier: Apache-2.0
//
// Well-known text, GeoJSON and drawings.
#include <bit>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "keikan/cases/case_format.hpp"
#include "keikan/cases/geojson.hpp"
#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/cases/svg.hpp"
#include "keikan/cases/wkt.hpp"
#include "keikan/support/input_error.hpp"

using namespace keikan;

namespace {

template <typename Read>
std::string complaint_of(Read read) {
    try {
        read();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no complaint";
}

std::string wkt_complaint(const std::string& text) {
    return complaint_of([&] { polygons_from_wkt(text, "a.wkt"); });
}

std::string geojson_complaint(const std::string& text) {
    return complaint_of([&] { polygons_from_geojson(text, "a.geojson"); });
}

std::vector<PixelCase> cases_of(const std::string& text, CaseFormat format) {
    std::istringstream in(text);
    const auto next = case_reader(in, "cases", format);
    std::vector<PixelCase> cases;
    while (auto pixel_case = next()) cases.push_back(std::move(*pixel_case));
    return cases;
}

/// Every bit of the case, signs of zeros included.
std::vector<std::uint64_t> bits_of(const PixelCase& pixel_case) {
    std::vector<std::uint64_t> bits;
    for (const Ring& ring : pixel_case.polygons) {
        bits.push_back(ring.size());
        for (const Point p : ring)
            for (const double v : {p.x, p.y}) bits.push_back(std::bit_cast<std::uint64_t>(v));
    }
    if (pixel_case.depth)
        for (const DepthPlane& plane : *pixel_case.depth)
            for (const double v : {plane.a, plane.b, plane.c})
                bits.push_back(std::bit_cast<std::uint64_t>(v));
    return bits;
}

void check_same(const PixelCase& a, const PixelCase& b) {
    CHECK(a.id == b.id);
    CHECK(a.pixel == b.pixel);
    CHECK(bits_of(a) == bits_of(b));
    CHECK(a.depth.has_value() == b.depth.has_value());
    CHECK(a.areas == b.areas);
    CHECK(a.background == b.background);
}

PixelCase awkward_case() {
    PixelCase result;
    result.id = "quote \" and \\ and \n# {";
    result.pixel = {4095, -2159};
    result.polygons = {{{0.1, -0.0}, {1e6 + 1.0 / 3, 5e-324}, {1.0 / 3, 1e22}},
                       {},
                       {{0.5, 0.5}},
                       {{0, 0}, {0, 0}, {1, 0}, {1, 1}, {0, 0}}};
    result.depth = std::vector<DepthPlane>{{1e-300, 2, 3}, {0, 0, -1.7976931348623157e308}, {}, {-0.0, 1, 2}};
    result.areas = std::vector<std::string>{"1/3", "0", "0", "1/7"};
    result.background = "2/3";
    return result;
}

constexpr CaseFormat kReadable[] = {CaseFormat::PixelCases, CaseFormat::Wkt, CaseFormat::GeoJson};

}  // namespace

TEST_CASE("text_of_case: every format names the same case again, bit for bit", "[cases][interchange]") {
    const PixelCase bare{
        .id = "bare", .pixel = {}, .polygons = {}, .depth = {}, .areas = {}, .background = {}};
    for (const CaseFormat format : kReadable) {
        std::string text;
        for (int i = 0; i < 2; ++i) text += text_of_case(awkward_case(), format) + text_of_case(bare, format);
        const auto cases = cases_of(text, format);
        REQUIRE(cases.size() == 4);
        check_same(cases[0], awkward_case());
        check_same(cases[1], bare);
        check_same(cases[2], awkward_case());
    }
}

TEST_CASE("text_of_case: the whole collection goes through every format and comes back",
          "[cases][interchange]") {
    int count = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(KEIKAN_SOURCE_DIR "/data/degenerate")) {
        if (entry.path().extension() != ".jsonl") continue;
        std::ifstream file(entry.path());
        const auto next = case_reader(file, entry.path().string(), CaseFormat::PixelCases);
        while (const auto original = next()) {
            ++count;
            for (const CaseFormat format : kReadable)
                check_same(cases_of(text_of_case(*original, format), format).at(0), *original);
        }
    }
    CHECK(count >= 82);
}

TEST_CASE("polygons_from_wkt: polygons, holes, and collections however nested", "[cases][wkt]") {
    const auto polygons = polygons_from_wkt(
        "# a comment\n"
        "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 1 2, 1 1));\n"
        "multipolygon(((0 0,1 0,0 1,0 0)),((5 5,0x1.8p2 5,5 6,5 5)))\n"
        "GEOMETRYCOLLECTION(GEOMETRYCOLLECTION EMPTY, GEOMETRYCOLLECTION(POLYGON EMPTY), MULTIPOLYGON "
        "EMPTY)\n",
        "a.wkt");
    REQUIRE(polygons.size() == 4);
    CHECK(polygons[0].outline == Ring{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    CHECK(polygons[0].holes == std::vector<Ring>{{{1, 1}, {2, 1}, {1, 2}}});
    CHECK(polygons[2].outline == Ring{{5, 5}, {6, 5}, {5, 6}});
    CHECK(polygons[3] == Polygon{});
    CHECK(polygons_from_wkt("  \n", "a.wkt").empty());
}

TEST_CASE("polygons_from_wkt: bad text is said with line, column and reason", "[cases][wkt][errors]") {
    CHECK(wkt_complaint("POINT (1 2)") == "a.wkt:1:1: expected POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION");
    CHECK(wkt_complaint("POLYGON ((0 0, 1 0, 0 1, 0 0))\nPOLYGON ((0 0, 1 x") ==
          "a.wkt:2:18: expected a number");
    CHECK(wkt_complaint("POLYGON ((0 0, 1 0, 0 1))") == "a.wkt:1:24: the ring does not end where it begins");
    CHECK(wkt_complaint("POLYGON Z ((0 0 1, 1 0 1, 0 0 1))") == "a.wkt:1:9: expected '('");
    CHECK(wkt_complaint("POLYGON ((0 0 1, 1 0 1, 0 0 1))") == "a.wkt:1:15: expected ',' or ')'");
    CHECK(wkt_complaint("POLYGON ((0 0, 1 0") == "a.wkt:1:19: expected ',' or ')'");
    CHECK(wkt_complaint("POLYGON ((0 0, nan 1, 0 0))") == "a.wkt:1:16: the number is not finite");
    CHECK(wkt_complaint("GEOMETRYCOLLECTION (POLYGON EMPTY").ends_with("expected ','"));
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "GEOMETRYCOLLECTION(";
    CHECK_THAT(wkt_complaint(deep), Catch::Contains("expected POLYGON"));
}

TEST_CASE("polygons_from_geojson: every kind that holds polygons", "[cases][geojson]") {
    const auto polygons = polygons_from_geojson(
        R"({"type": "FeatureCollection", "features": [
            {"type": "Feature", "properties": {"note": "} \" ]"}, "geometry": null},
            {"type": "Feature", "properties": null, "geometry": {"type": "GeometryCollection", "geometries": [
                {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [0, 4], [0, 0]], [[1, 1, 9], [2, 1], [1, 1]]]}]}}]}
           {"type": "MultiPolygon", "coordinates": [[[[5, 5], [6, 5], [5, 5]]], []]})",
        "a.geojson");
    REQUIRE(polygons.size() == 3);
    CHECK(polygons[0].outline == Ring{{0, 0}, {4, 0}, {0, 4}});
    CHECK(polygons[0].holes == std::vector<Ring>{{{1, 1}, {2, 1}}});
    CHECK(polygons[1].outline == Ring{{5, 5}, {6, 5}});
    CHECK(polygons[2] == Polygon{});
}

TEST_CASE("polygons_from_geojson: bad documents are said with line, place and reason",
          "[cases][geojson][errors]") {
    CHECK(geojson_complaint("\n{\"type\": \"Polygon\"}") == "a.geojson:2: document has no \"coordinates\"");
    CHECK(geojson_complaint("[]") == "a.geojson:1: document is not a GeoJSON object");
    CHECK(geojson_complaint("{} x") == "a.geojson:1: document has no \"type\"");
    CHECK(geojson_complaint(R"({"type": "Point", "coordinates": [0, 0]})") ==
          "a.geojson:1: document is neither a polygon nor a collection of polygons");
    CHECK(geojson_complaint(R"({"type": "Polygon", "coordinates": [[[0, 0], [1, null], [0, 0]]]})") ==
          "a.geojson:1: coordinates[0][1][1] is not a number");
    CHECK(geojson_complaint(R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 1]]]})") ==
          "a.geojson:1: coordinates[0] does not end where it begins");
    CHECK(
        geojson_complaint(
            R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": {"type": "X"}}]})") ==
        "a.geojson:1: features[0].geometry is neither a polygon nor a collection of polygons");
    CHECK_THAT(geojson_complaint("{\"type\": \"Polygon\", \"coordinates\": [[[0, 0"),
               Catch::Contains("a.geojson:1: broken JSON near column"));
    CHECK_THAT(geojson_complaint(R"({"type": "Polygon", "coordinates": [[[1e999, 0]]]})"),
               Catch::Contains("not finite"));
    std::string deep;
    for (int i = 0; i < 20; ++i) deep += R"({"type": "GeometryCollection", "geometries": [)";
    for (int i = 0; i < 20; ++i) deep += "]}";
    CHECK_THAT(geojson_complaint(deep), Catch::Contains("nested too deeply"));
}

TEST_CASE("case_reader: a case is a geometry or a document; what is left out has its documented value",
          "[cases][interchange]") {
    const auto wkt = cases_of(
        "POLYGON ((0 0, 1 0, 0 1, 0 0))\n\n# a remark\nMULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((2 2, 3 2, 2 "
        "3, 2 2)))",
        CaseFormat::Wkt);
    REQUIRE(wkt.size() == 2);
    CHECK(wkt[0].id == "1");
    CHECK(wkt[1].id == "4");
    CHECK(wkt[1].polygons.size() == 2);
    CHECK(wkt[1].pixel == PixelIndex{0, 0});
    const auto geojson = cases_of(
        "{\"type\": \"Polygon\", \"coordinates\": []}\n"
        "{\"type\": \"Polygon\", \"coordinates\": [], \"pixel\": [3, 4],\n \"areas\": [\"0\"]}",
        CaseFormat::GeoJson);
    REQUIRE(geojson.size() == 2);
    CHECK(geojson[1].id == "2");
    CHECK(geojson[1].pixel == PixelIndex{3, 4});
    CHECK(geojson[1].areas == std::vector<std::string>{"0"});
}

TEST_CASE("case_reader: what no pixel case can be is refused with its line", "[cases][interchange][errors]") {
    const auto refused = [](const std::string& text, CaseFormat format) {
        return complaint_of([&] { cases_of(text, format); });
    };
    CHECK(refused("\nPOLYGON ((0 0, 2 0, 2 2, 1 0.5, 0 0))", CaseFormat::Wkt) ==
          "cases:2: polygon 0 is not convex");
    CHECK(refused("POLYGON ((0 0, 4 0, 0 4, 0 0), (1 1, 2 1, 1 2, 1 1))", CaseFormat::Wkt) ==
          "cases:1: polygon 0 has a hole");
    CHECK(refused("# {\"depth\": []}\nPOLYGON ((0 0, 4 0, 0 4, 0 0))", CaseFormat::Wkt) ==
          "cases:2: depth has 0 entries for 1 polygons");
    CHECK_THAT(refused("# {\"depth\"\nPOLYGON EMPTY", CaseFormat::Wkt), Catch::Contains("broken JSON"));
    CHECK(refused(R"({"type": "Polygon", "coordinates": [[[0,0],[2,0],[2,2],[1,0.5],[0,0]]]})",
                  CaseFormat::GeoJson) == "cases:1: polygon 0 is not convex");
}

TEST_CASE("case_format_of: by the ending", "[cases][interchange]") {
    CHECK(case_format_of("a/b.jsonl") == CaseFormat::PixelCases);
    CHECK(case_format_of("b.wkt") == CaseFormat::Wkt);
    CHECK(case_format_of("b.geojson") == CaseFormat::GeoJson);
    CHECK(case_format_of("b.json") == CaseFormat::GeoJson);
    CHECK(case_format_of("b.svg") == CaseFormat::Svg);
    CHECK_FALSE(case_format_of("b.txt"));
    CHECK_FALSE(case_format_of("-"));
}

TEST_CASE("svg_from_cases: a drawing of its own for each case, cut off around the pixel", "[cases][svg]") {
    const PixelCase far{.id = "<far> & wide",
                        .pixel = {3, 4},
                        .polygons = {{{3, 4}, {4, 4}, {3, 5}}, {{-1e300, 4}, {1e300, 4}, {3, 1e300}}},
                        .depth = {},
                        .areas = {},
                        .background = {}};
    const std::string svg = svg_from_cases(std::vector{far, far});
    CHECK_THAT(svg, Catch::StartsWith("<svg xmlns"));
    CHECK_THAT(svg, Catch::Contains("&lt;far> &amp; wide"));
    CHECK_THAT(svg, Catch::Contains("points=\"0,0 1,0 0,1\""));
    CHECK_THAT(svg, !Catch::Contains("e+") && !Catch::Contains("nan") && !Catch::Contains("inf"));
    CHECK(svg.find("<polygon") < svg.find("<polygon", svg.find("<polygon") + 1));
}

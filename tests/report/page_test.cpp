// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "keikan/support/input_error.hpp"
#include "report/case_report.hpp"
#include "report/junit.hpp"

using namespace keikan;
using namespace keikan::report;

namespace {

const std::string kHostile = "</script><img src=x onerror=alert(1)>";

/// The JSON of an element of the page.
nlohmann::json element_of(const std::string& html, const std::string& id) {
    const std::string begin = "id=\"" + id + "\">";
    const std::size_t from = html.find(begin) + begin.size();
    REQUIRE(from != std::string::npos + begin.size());
    return nlohmann::json::parse(html.substr(from, html.find("</script>", from) - from));
}

Page small_page() {
    Page page;
    page.kind = "areas";
    page.subject = kHostile;
    page.summary = crosscheck::summary_json({});
    PixelCase asked;
    asked.id = kHostile;
    asked.polygons = {{{0, 0}, {1, 0}, {1, 1}}};
    page.pixels.push_back(case_to_show(asked, Engine::Splitting));
    page.pixels.back().reasons = {Reason::Sample};
    return page;
}

}  // namespace

TEST_CASE("html_of: no text ends the element that it stands in, and it comes out as it was", "[report]") {
    const std::string html = html_of(small_page());
    CHECK(html.find("<img") == std::string::npos);
    const nlohmann::json head = element_of(html, "report-head");
    CHECK(head["subject"] == kHostile);
    CHECK(head["summary"]["verdict"] == "pass");
    CHECK(head["versions"].contains("CGAL"));
}

TEST_CASE("html_of: a page names no other file and no place of the network", "[report]") {
    const std::string html = html_of(small_page());
    for (const char* word : {"src=\"", "href=\"http", "@import", "url(http", "fetch("})
        CHECK(html.find(word) == std::string::npos);
    CHECK(html == html_of(small_page()));
}

TEST_CASE("pixel_detail_json: question, claims and exact areas", "[report]") {
    PixelCase asked;
    asked.id = "third";
    asked.polygons = {{{0, 0}, {3, 0}, {0, 1}}};  // a right triangle, cut by the pixel: 1/3 + 1/2 * 1/3
    const nlohmann::json pixel =
        nlohmann::json::parse(pixel_detail_json(case_to_show(asked, Engine::Splitting)));
    CHECK(pixel["exact"]["areas"][0] == "5/6");
    CHECK(pixel["exact"]["background"] == "1/6");
    REQUIRE(pixel["claims"].size() == 2);
    CHECK(pixel["claims"][0]["by"] == "splitting");
    CHECK(pixel["claims"][0]["areas"][0].get<double>() == Approx(5.0 / 6).epsilon(1e-15));
    CHECK(pixel["whole"] == true);
    REQUIRE(pixel["steps"].size() == 1);               // the background
    CHECK_FALSE(pixel["steps"][0].contains("exact"));  // the oracle agrees
}

TEST_CASE("pixel_details_json: where there is no room for all, the worst and what disagrees stay",
          "[report]") {
    PixelCase asked;
    asked.polygons.assign(1,
                          Ring(40000, {0.123456789012345, 0.987654321098765}));  // 1.5 MB of text, of no area
    std::vector<PixelToShow> pixels(30, case_to_show(asked, Engine::Splitting));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i].asked.id = std::to_string(i);
        pixels[i].error = static_cast<double>(i) * 1e-17;
        pixels[i].reasons = {i == 3 ? Reason::Disagrees : i < 8 ? Reason::Sample : Reason::Worst};
    }
    const PixelDetails details = pixel_details_json(pixels);
    const nlohmann::json kept = nlohmann::json::parse(details.json);
    CHECK(details.json.size() <= kMostDetailBytes + 100);
    CHECK(kept.size() + details.left_out == 30);
    CHECK(details.left_out > 0);
    std::vector<std::string> ids;
    for (const nlohmann::json& pixel : kept) ids.push_back(pixel["id"]);
    for (const char* id : {"3", "29", "7"}) CHECK(std::count(ids.begin(), ids.end(), id) == 1);
}

TEST_CASE("junit: a failure for each kind of disagreement, with what it says", "[report]") {
    crosscheck::CheckSummary summary;
    CHECK(junit_xml("s", junit_cases(summary), 1.5).find("failures=\"0\"") != std::string::npos);
    crosscheck::Disagreement wrong{.kind = crosscheck::Disagreement::Kind::Area, .pixel = {1, 2}};
    wrong.case_id = kHostile;
    summary.add(wrong);
    const std::string xml = junit_xml("a \"suite\"", junit_cases(summary), 1.5);
    CHECK(xml.find("tests=\"9\" failures=\"1\"") != std::string::npos);
    CHECK(xml.find("time=\"1.500\"") != std::string::npos);
    CHECK(xml.find("<img") == std::string::npos);
    CHECK(xml.find("&lt;img src=x") != std::string::npos);
    CHECK(xml.find("a &quot;suite&quot;") != std::string::npos);
}

TEST_CASE("CaseChoice: the worst, whatever disagrees, and the first of each kind", "[report]") {
    CaseChoice choice(Engine::Splitting);
    PixelCase asked;
    asked.polygons = {{{0, 0}, {1, 0}, {1, 1}}};
    for (int i = 0; i < 8000; ++i) {
        asked.id = std::to_string(i);
        crosscheck::PixelVerdict verdict;
        verdict.faces = 1;
        verdict.area_error = i * 1e-20;
        if (i == 17) verdict.disagreements.push_back({.pixel = {}, .case_id = "17"});
        if (i == 18) verdict.kinds = crosscheck::bit_of(crosscheck::PixelKind::Hole);
        choice.add(asked, verdict);
    }
    Page page;
    choice.fill(page);
    REQUIRE(page.pixels.size() == 502);
    CHECK(page.pixels[0].asked.id == "17");
    CHECK(page.pixels[1].asked.id == "18");
    CHECK(page.pixels[2].asked.id == "7500");
    CHECK(page.pixels.back().asked.id == "7999");
    CHECK(page.disagreeing_left_out == 0);
    CHECK(page.errors.none == 1);
}

TEST_CASE("make_report_folder: what is no folder is bad input", "[report]") {
    CHECK_THROWS_AS(make_report_folder("/dev/null/report"), InputError);
}

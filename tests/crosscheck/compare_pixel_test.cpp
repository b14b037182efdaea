// SPDX-License-Identifier: GPL-3.0-or-later
// Planted faults: a claim that is right passes, and each way of being wrong is reported.
#include "crosscheck/compare_pixel.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "crosscheck/error_bounds.hpp"
#include "keikan/clip/visible_areas.hpp"

using namespace keikan;
using namespace keikan::crosscheck;
using Kind = Disagreement::Kind;

namespace {

/// A triangle in front of a wall that fills three quarters of the pixel: areas 9/32, 15/32, background 1/4.
struct Example {
    std::vector<Ring> outlines = {{{0, 0}, {0.75, 0}, {0, 0.75}}, {{0, 0}, {0.75, 0}, {0.75, 1}, {0, 1}}};
    std::vector<FaceView> faces = {{7, outlines[0], {0, 0, 2}}, {9, outlines[1], {0, 0, 1}}};
    Question question{{0, 0}, faces, Nearness::ByDepth};
    Claim claim{{9.0 / 32, 15.0 / 32}, 0.25};

    PixelVerdict verdict(const Proofs& proofs = {}) { return PixelComparison()(question, claim, proofs); }
};

std::vector<Kind> kinds(const PixelVerdict& verdict) {
    std::vector<Kind> found;
    for (const Disagreement& d : verdict.disagreements) found.push_back(d.kind);
    return found;
}

}  // namespace

TEST_CASE("compare_pixel: a right answer holds, by the certified rung alone", "[crosscheck]") {
    Example example;
    const PixelVerdict verdict = example.verdict();
    CHECK(verdict.disagreements.empty());
    CHECK(verdict.area_error <= kVisibleAreaError);
    CHECK(verdict.sum_error == 0);
    CHECK(verdict.faces == 2);
    CHECK(verdict.rungs == RungCounts{.quad = 1, .certified = 1, .rational = 0, .cgal = 0});
}

TEST_CASE("compare_pixel: every rung can be asked for, and they agree", "[crosscheck]") {
    Example example;
    const PixelVerdict verdict = example.verdict({.rational = true, .boolean_sets = true});
    CHECK(verdict.disagreements.empty());
    CHECK(verdict.area_error == 0);
    CHECK(verdict.rungs == RungCounts{.quad = 1, .certified = 1, .rational = 1, .cgal = 1});
}

TEST_CASE("compare_pixel: a face dropped from the pixel is reported", "[crosscheck][planted]") {
    Example example;
    example.claim = {{0, 0.75}, 0.25};  // as if the triangle were not there
    const PixelVerdict verdict = example.verdict();
    CHECK(kinds(verdict) == std::vector{Kind::Area, Kind::Area});
    CHECK(verdict.disagreements[0].face == 7u);
    CHECK(verdict.disagreements[0].exact == 9.0 / 32);
    CHECK(verdict.disagreements[0].error == 9.0 / 32);
    CHECK(verdict.rungs.rational == 1);
    CHECK(verdict.rungs.cgal == 1);  // the last word
}

TEST_CASE("compare_pixel: two faces swapped in depth are reported", "[crosscheck][planted]") {
    Example example;
    std::swap(example.faces[0].depth, example.faces[1].depth);
    VisibleAreas visible_areas;
    std::vector<Disagreement> faults;
    example.claim = claim_of(visible_areas({0, 0}, example.faces, Nearness::ByDepth), 2, {0, 0}, faults);
    std::swap(example.faces[0].depth, example.faces[1].depth);
    CHECK(faults.empty());
    CHECK(kinds(example.verdict()) == std::vector{Kind::Area, Kind::Area});
}

TEST_CASE("compare_pixel: an area off by 1e-9 is reported", "[crosscheck][planted]") {
    Example example;
    example.claim.areas[0] += 1e-9;
    const PixelVerdict verdict = example.verdict();
    CHECK(kinds(verdict) == std::vector{Kind::Area, Kind::Sum});
    CHECK(verdict.area_error == Approx(1e-9));
    CHECK(verdict.sum_error == Approx(1e-9));
    CHECK(verdict.disagreements[0].bound == kVisibleAreaError);
}

TEST_CASE("compare_pixel: errors that cancel in the sum are reported", "[crosscheck][planted]") {
    Example example;
    example.claim.areas[0] += 1e-9;
    example.claim.areas[1] -= 1e-9;
    CHECK(kinds(example.verdict()) == std::vector{Kind::Area, Kind::Area});
}

TEST_CASE("compare_pixel: a missing background is reported", "[crosscheck][planted]") {
    Example example;
    example.claim.background = 0;
    CHECK(kinds(example.verdict()) == std::vector{Kind::Background, Kind::Sum});
}

TEST_CASE("compare_pixel: the bound decides, to either side of it", "[crosscheck][planted]") {
    Example example;
    example.claim.areas[0] += 0.9 * kVisibleAreaError;
    CHECK(example.verdict().disagreements.empty());
    example.claim = Example().claim;
    example.claim.areas[0] += 1.1 * kVisibleAreaError;
    CHECK(kinds(example.verdict()) == std::vector{Kind::Area, Kind::Sum});
}

TEST_CASE("compare_pixel: an answer that is no number is reported", "[crosscheck][planted]") {
    Example example;
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        example.claim.areas[0] = value;
        CHECK(kinds(example.verdict()) == std::vector{Kind::Area, Kind::Sum});
    }
}

TEST_CASE("compare_pixel: a stated answer that is not exact is reported", "[crosscheck][planted]") {
    Example example;
    const std::vector<std::string> right = {"9/32", "30/64"},
                                   wrong = {"9/32", "4503599627370497/9607679205057194"};
    const std::string quarter = "1/4", third = "1/3";
    const GivenAnswer sound{right, &quarter}, off{wrong, &third};
    CHECK(PixelComparison()(example.question, example.claim, {}, &sound).disagreements.empty());
    CHECK(kinds(PixelComparison()(example.question, example.claim, {}, &off)) ==
          std::vector{Kind::Given, Kind::Given});
}

TEST_CASE("claim_of: an answer that breaks its own contract is reported", "[crosscheck][planted]") {
    const auto faults_of = [](std::vector<VisiblePart> parts, double background) {
        std::vector<Disagreement> faults;
        claim_of({parts, background}, 2, {0, 0}, faults);
        return faults.size();
    };
    CHECK(faults_of({{0, 0.5, {}}, {1, 0.5, {}}}, 0) == 0);
    CHECK(faults_of({{1, 0.5, {}}, {0, 0.5, {}}}, 0) == 1);  // not rising
    CHECK(faults_of({{0, 0.5, {}}, {0, 0.5, {}}}, 0) == 1);  // twice
    CHECK(faults_of({{0, 0.0, {}}, {1, 1.0, {}}}, 0) == 1);  // listed without area
    CHECK(faults_of({{0, 1.5, {}}}, -0.5) == 2);
    CHECK(faults_of({{2, 1, {}}}, 0) == 1);  // nobody asked about it
}

TEST_CASE("excess_of_sum: many small areas add up without rounding errors of its own", "[crosscheck]") {
    Claim claim{std::vector<double>(100, 0x1p-60), 1};
    CHECK(excess_of_sum(claim) == 100 * 0x1p-60);
}

TEST_CASE("area_bound: the promise up to 8 faces, more in crowded pixels", "[crosscheck]") {
    CHECK(area_bound(8) == kVisibleAreaError);
    CHECK(area_bound(9) == kCrowdedPixelError);
    CHECK(sum_bound(8) == kVisibleAreaError);
    CHECK(sum_bound(32) == kAreaSumError);
    CHECK(sum_bound(33) == kCrowdedPixelError);
}

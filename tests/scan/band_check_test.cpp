// SPDX-License-Identifier: Apache-2.0
#include "../../src/scan/band_check.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <limits>

using namespace keikan;

namespace {

constexpr int kWidth = 5;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Two rows of five pixels: the first a span, a divided pixel, a span; the second one span of background.
ScanBand sound_band() {
    ScanBand band;
    band.first_row = 8;
    band.rows = 2;
    band.faces.resize(2);
    band.spans = {{0, 2, 0}, {3, 5, 1}, {0, 5, Span::kBackground}};
    band.span_begin = {0, 2, 3};
    band.divided = {{2, Division::ExactAreas, 0, 2, 0.25}};
    band.divided_begin = {0, 1, 1};
    band.parts = {{0, 0.5f, 0.25f, 0.5}, {1, 0, 1, 0.25}};
    return band;
}

/// What is said of the band once `damage` is done to it.
std::string said_after(const std::function<void(ScanBand&)>& damage) {
    ScanBand band = sound_band();
    damage(band);
    return what_is_wrong(band, kWidth).value_or("nothing");
}

}  // namespace

TEST_CASE("what_is_wrong: nothing, with a band that shares out every pixel once", "[scan_file]") {
    CHECK(said_after([](ScanBand&) {}) == "nothing");
}

TEST_CASE("what_is_wrong: rows that do not share out the spans and divided pixels", "[scan_file][hostile]") {
    const std::string words = "the rows do not share out the spans and divided pixels";
    CHECK(said_after([](ScanBand& b) { b.span_begin = {1, 2, 3}; }) == words);
    CHECK(said_after([](ScanBand& b) { b.span_begin = {0, 2, 2}; }) == words);
    CHECK(said_after([](ScanBand& b) { b.span_begin = {0, 4, 3}; }) == words);
    CHECK(said_after([](ScanBand& b) { b.divided_begin = {1, 1, 1}; }) == words);
    CHECK(said_after([](ScanBand& b) { b.divided_begin = {0, 1, 2}; }) == words);
}

TEST_CASE("what_is_wrong: a pixel without an answer, or with two", "[scan_file][hostile]") {
    const std::string first = "row 8 is not covered once by its spans and divided pixels";
    CHECK(said_after([](ScanBand& b) { b.spans[0].x_begin = 1; }) == first);
    CHECK(said_after([](ScanBand& b) { b.spans[0].x_end = 3; }) == first);
    CHECK(said_after([](ScanBand& b) { b.spans[0].x_end = 0; }) == first);
    CHECK(said_after([](ScanBand& b) { b.spans[1].x_end = 6; }) == first);
    CHECK(said_after([](ScanBand& b) { b.spans[1].x_end = 4; }) == first);
    CHECK(said_after([](ScanBand& b) { b.divided[0].x = 3; }) == first);
    CHECK(said_after([](ScanBand& b) { b.divided_begin = {0, 0, 1}; }) == first);
    CHECK(said_after([](ScanBand& b) {
              b.spans.insert(b.spans.begin() + 2, {5, 5, 0}), b.span_begin = {0, 3, 4};
          }) == first);
    CHECK(said_after([](ScanBand& b) { b.spans[2].x_end = 4; }) ==
          "row 9 is not covered once by its spans and divided pixels");
}

TEST_CASE("what_is_wrong: faces that are not there", "[scan_file][hostile]") {
    CHECK(said_after([](ScanBand& b) { b.spans[1].face = 2; }) == "a span names a face that is not there");
    CHECK(said_after([](ScanBand& b) { b.parts[1].face = 2; }) == "a part names a face that is not there");
}

TEST_CASE("what_is_wrong: parts that are another pixel's, or nobody's", "[scan_file][hostile]") {
    const std::string words = "a divided pixel names parts that are not its own";
    CHECK(said_after([](ScanBand& b) { b.divided[0].part_begin = 1; }) == words);
    CHECK(said_after([](ScanBand& b) { b.divided[0].part_end = 0; }) == words);
    CHECK(said_after([](ScanBand& b) { b.divided[0].part_end = 3; }) == words);
    CHECK(said_after([](ScanBand& b) {
              b.parts.push_back({0, 0, 0, 0.25});
          }) == "there are parts without a pixel");
}

TEST_CASE("what_is_wrong: weights and places that no pixel has", "[scan_file][hostile]") {
    for (const double background : {-0.25, 1.25, kNan})
        CHECK(said_after([&](ScanBand& b) { b.divided[0].background = background; }) ==
              "a background is no fraction of the pixel");
    for (const double weight : {0.0, -0.5, 1.5, kNan})
        CHECK(said_after([&](ScanBand& b) { b.parts[0].weight = weight; }) ==
              "a weight is no fraction of the pixel");
    for (const double place : {-0.25, 1.25, kNan}) {
        const auto p = static_cast<float>(place);
        CHECK(said_after([&](ScanBand& b) { b.parts[0].x = p; }) == "a centroid lies outside its pixel");
        CHECK(said_after([&](ScanBand& b) { b.parts[1].y = p; }) == "a centroid lies outside its pixel");
    }
    const std::string sum = "the weights of a pixel do not add up to 1";
    CHECK(said_after([](ScanBand& b) { b.parts[0].weight = 0.5 + 2 * kWeightSumSlack; }) == sum);
    CHECK(said_after([](ScanBand& b) { b.parts[0].weight = 0.5 - 2 * kWeightSumSlack; }) == sum);
    CHECK(said_after([](ScanBand& b) { b.divided[0].background = 0; }) == sum);
    CHECK(said_after([](ScanBand& b) { b.parts[0].weight = 0.5 + 0.5 * kWeightSumSlack; }) == "nothing");
}

TEST_CASE("what_is_wrong: numbers of a face that are not finite", "[scan_file][hostile]") {
    const std::string words = "a face holds a number that is not finite";
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        const auto b32 = static_cast<float>(bad);
        CHECK(said_after([&](ScanBand& b) { b.faces[0].plane.a = bad; }) == words);
        CHECK(said_after([&](ScanBand& b) { b.faces[0].plane.b = bad; }) == words);
        CHECK(said_after([&](ScanBand& b) { b.faces[1].plane.c = bad; }) == words);
        CHECK(said_after([&](ScanBand& b) { b.faces[0].normal_at.x = bad; }) == words);
        CHECK(said_after([&](ScanBand& b) { b.faces[0].normal_at.y = bad; }) == words);
        CHECK(said_after([&](ScanBand& b) { b.faces[1].normal[2][1] = b32; }) == words);
        CHECK(said_after([&](ScanBand& b) { b.faces[1].flat_normal[0] = b32; }) == words);
    }
    // Large, but finite: no sum of them overflows.
    const double most = std::numeric_limits<double>::max();
    CHECK(said_after([&](ScanBand& b) { b.faces[0].plane = {most, most, most}; }) == "nothing");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <limits>

#include "oracle/exact_areas.hpp"
#include "sample_pixels.hpp"

using namespace keikan;
using namespace keikan::oracle;

namespace {

/// `--rng-seed` asks for other pixels than those of every run.
std::uint64_t seed() {
    return Catch::rngSeed() != 0 ? Catch::rngSeed() : 20240711;
}

/// |exact - value| <= error, in rational arithmetic.
bool encloses(const CertifiedArea& certified, const mpq_class& exact) {
    const mpq_class difference = exact - mpq_class(certified.value);
    const mpq_class error(certified.error);
    return difference <= error && -difference <= error;
}

bool encloses(const CertifiedAreas& certified, const ExactAreas& exact) {
    if (!certified.certified || certified.areas.size() != exact.areas.size()) return false;
    for (std::size_t i = 0; i < exact.areas.size(); ++i)
        if (!encloses(certified.areas[i], exact.areas[i])) return false;
    return encloses(certified.background, exact.background);
}

double user_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Asks `check(question, faces)` of `count` pixels of each family.
template <typename Check>
void sample(int count, Check&& check) {
    for (const std::string_view family : sample_families()) {
        std::mt19937_64 random(seed());
        for (int n = 0; n < count; ++n) {
            const PixelCase question = sample_pixel(family, random);
            INFO("seed " << seed() << ", " << family << ", pixel " << n);
            check(question, question.faces());
        }
    }
}

void check_proofs(const PixelCase& question, std::span<const FaceView> faces) {
    const auto exact = areas_by_rational_splitting(question.pixel, faces, question.nearness());
    REQUIRE(areas_by_boolean_sets(question.pixel, faces, question.nearness()) == exact);
    REQUIRE(areas_by_arrangement(question.pixel, faces, question.nearness()) == exact);
}

/// Rounding to a double included: half a unit in the last place below 1, and some 1e-17 for the corners.
constexpr double kClose = 1.5e-16;

void check_certified(CertifiedSplitting& certified_areas, const PixelCase& question,
                     std::span<const FaceView> faces) {
    const auto exact = areas_by_rational_splitting(question.pixel, faces, question.nearness());
    const auto certified = certified_areas(question.pixel, faces, question.nearness());
    REQUIRE(encloses(certified, exact));
    for (const CertifiedArea& area : certified.areas) REQUIRE(area.error <= kClose);
}

}  // namespace

TEST_CASE("oracle: Boolean sets, arrangements and rational splitting give the same rational numbers",
          "[oracle]") {
    sample(5, check_proofs);
}

TEST_CASE("oracle: so they do where corners are any power of two away", "[oracle]") {
    std::mt19937_64 random(seed());
    const auto coordinate = [&random]() -> double {
        const double usual = static_cast<double>(random() % 13) / 8 - 0.25;
        if (random() % 2 == 0) return usual;
        const int power = static_cast<int>(random() % 2097) - 1074;
        return (random() % 2 == 0 ? -1 : 1) * std::ldexp(1 + usual / 2, power);
    };
    for (int n = 0; n < 100; ++n) {
        PixelCase question;
        for (int i = 0; i < 2; ++i) {
            question.polygons.emplace_back();
            for (int corner = 0; corner < 3; ++corner) {
                const double x = coordinate();
                question.polygons.back().push_back({x, coordinate()});
            }
        }
        INFO("seed " << seed() << ", pixel " << n);
        check_proofs(question, question.faces());
    }
}

TEST_CASE("oracle: certified areas enclose the exact ones, and are close", "[oracle]") {
    CertifiedSplitting certified_areas;
    sample(120, [&](const PixelCase& question, std::span<const FaceView> faces) {
        check_certified(certified_areas, question, faces);
    });
}

TEST_CASE("oracle: the proofs agree on many more pixels", "[.long]") {
    sample(300, check_proofs);
}

TEST_CASE("oracle: certified areas enclose the exact ones on many more pixels", "[.long]") {
    CertifiedSplitting certified_areas;
    sample(4000, [&](const PixelCase& question, std::span<const FaceView> faces) {
        if (question.id != "denormal") check_certified(certified_areas, question, faces);
    });
}

TEST_CASE("oracle: terrain pixels agree", "[oracle]") {
    std::mt19937_64 random(seed());
    CertifiedSplitting certified_areas;
    for (int n = 0; n < 200; ++n) {
        const PixelCase question = terrain_pixel(random);
        INFO("seed " << seed() << ", pixel " << n);
        const auto faces = question.faces();
        check_certified(certified_areas, question, faces);
        if (n % 100 == 0) check_proofs(question, faces);
    }
}

TEST_CASE("oracle: by depth, the order of the list does not matter", "[oracle]") {
    CertifiedSplitting certified_areas;
    std::mt19937_64 random(seed());
    for (const std::string_view family : {"cyclic", "through", "coplanar", "near-coplanar"})
        for (int n = 0; n < 30; ++n) {
            const PixelCase question = sample_pixel(family, random);
            INFO("seed " << seed() << ", " << family << ", pixel " << n);
            auto faces = question.faces();
            const auto exact = areas_by_rational_splitting(question.pixel, faces, Nearness::ByDepth);
            std::ranges::shuffle(faces, random);
            const auto shuffled = areas_by_rational_splitting(question.pixel, faces, Nearness::ByDepth);
            for (std::size_t i = 0; i < faces.size(); ++i)
                REQUIRE(shuffled.areas[i] == exact.areas[faces[i].id]);  // here an id is the first position
            REQUIRE(encloses(certified_areas(question.pixel, faces, Nearness::ByDepth), shuffled));
        }
}

TEST_CASE("oracle: a change in the last bits of an answer is not enclosed", "[oracle]") {
    // Enclosing is only worth something if the enclosure is narrow: 1e-15 of one area moved to another falls
    // out.
    CertifiedSplitting certified_areas;
    std::mt19937_64 random(seed());
    int noticed = 0;
    for (int n = 0; n < 50; ++n) {
        const PixelCase question = sample_pixel("fan", random);
        const auto faces = question.faces();
        auto wrong = areas_by_rational_splitting(question.pixel, faces, question.nearness());
        wrong.areas[0] += mpq_class(1e-15);
        wrong.background -= mpq_class(1e-15);
        noticed += !encloses(certified_areas(question.pixel, faces, question.nearness()), wrong);
    }
    CHECK(noticed == 50);
}

TEST_CASE("oracle: a crowd of crossing bars is certified too", "[oracle]") {
    CertifiedSplitting certified_areas;
    const PixelCase question = crowded_pixel(60);
    check_certified(certified_areas, question, question.faces());
}

TEST_CASE("oracle: numbers that are not finite are not certified", "[oracle]") {
    CertifiedSplitting certified_areas;
    const Ring ring = {{0, 0}, {1, 0}, {1, std::numeric_limits<double>::infinity()}};
    const FaceView face = {0, ring, {}};
    CHECK_FALSE(certified_areas({}, {&face, 1}, Nearness::InOrder).certified);
}

TEST_CASE("oracle: pixels a second of each rung", "[.rate]") {
    const auto rate = [](const char* what, int count, auto make, auto&& answer) {
        std::mt19937_64 random(seed());
        std::vector<PixelCase> questions;
        for (int n = 0; n < count; ++n) questions.push_back(make(random, n));
        const double start = user_seconds();
        for (const PixelCase& question : questions)
            answer(question.pixel, question.faces(), question.nearness());
        std::cout << what << ": " << count / (user_seconds() - start) << " pixels/s\n";
    };
    const auto mixed = [](std::mt19937_64& random, int n) {
        const auto families = sample_families();
        return sample_pixel(families[static_cast<std::size_t>(n) % families.size()], random);
    };
    const auto usual = [](std::mt19937_64& random, int n) {  // denormal numbers are rare outside of tests
        const auto families = sample_families();
        const auto family = families[static_cast<std::size_t>(n) % families.size()];
        return sample_pixel(family == "denormal" ? "random" : family, random);
    };
    const auto crowd = [](std::mt19937_64&, int) { return crowded_pixel(100); };
    const auto terrain = [](std::mt19937_64& random, int) { return terrain_pixel(random); };
    CertifiedSplitting certified_areas;
    rate("certified, mixed", 21000, mixed, certified_areas);
    rate("certified, without denormal", 21000, usual, certified_areas);
    rate("certified, 100 bars", 20, crowd, certified_areas);
    rate("certified, terrain", 20000, terrain, certified_areas);
    const auto by_rationals = [](PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness) {
        return areas_by_rational_splitting(pixel, faces, nearness);
    };
    rate("rational, mixed", 1050, mixed, by_rationals);
    rate("rational, without denormal", 1050, usual, by_rationals);
    rate("rational, terrain", 500, terrain, by_rationals);
    rate("boolean sets, mixed", 105, mixed, areas_by_boolean_sets);
    rate("arrangement, mixed", 105, mixed, areas_by_arrangement);
    rate("arrangement, terrain", 20, terrain, areas_by_arrangement);
    rate("boolean sets, terrain", 20, terrain, areas_by_boolean_sets);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include <ctime>
#include <iostream>

#include "oracle/exact_areas.hpp"
#include "sample_pixels.hpp"

using namespace keikan;
using namespace keikan::oracle;

namespace {

constexpr std::uint64_t kSeed = 20240711;

/// |exact - value| <= error, in rational arithmetic.
bool encloses(const CertifiedArea& certified, const CGAL::Gmpq& exact) {
    const CGAL::Gmpq difference = exact - CGAL::Gmpq(certified.value);
    const CGAL::Gmpq error(certified.error);
    return difference <= error && -difference <= error;
}

bool encloses(const CertifiedAreas& certified, const ExactAreas& exact) {
    if (!certified.certified || certified.areas.size() != exact.areas.size()) return false;
    for (std::size_t i = 0; i < exact.areas.size(); ++i)
        if (!encloses(certified.areas[i], exact.areas[i])) return false;
    return encloses(certified.background, exact.background);
}

double user_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

TEST_CASE("oracle: Boolean sets and rational splitting give the same rational numbers", "[oracle]") {
    std::mt19937_64 random(kSeed);
    UNSCOPED_INFO("seed " << kSeed);
    for (const std::string_view family : sample_families())
        for (int n = 0; n < 12; ++n) {
            const PixelCase question = sample_pixel(family, random);
            const auto faces = question.faces();
            INFO(family << " " << n);
            REQUIRE(areas_by_boolean_sets(question.pixel, faces, question.nearness()) ==
                    areas_by_rational_splitting(question.pixel, faces, question.nearness()));
        }
}

TEST_CASE("oracle: certified areas enclose the exact ones, and are close", "[oracle]") {
    std::mt19937_64 random(kSeed);
    CertifiedSplitting certified_areas;
    for (const std::string_view family : sample_families())
        for (int n = 0; n < 150; ++n) {
            const PixelCase question = sample_pixel(family, random);
            const auto faces = question.faces();
            const auto exact = areas_by_rational_splitting(question.pixel, faces, question.nearness());
            const auto certified = certified_areas(question.pixel, faces, question.nearness());
            INFO("seed " << kSeed << ", " << family << " " << n);
            REQUIRE(encloses(certified, exact));
            for (const CertifiedArea& area : certified.areas) REQUIRE(area.error <= 1.5e-16);
        }
}

TEST_CASE("oracle: pixels a second of each rung", "[.rate]") {
    const auto rate = [](const char* what, int count, auto make, auto&& answer) {
        std::mt19937_64 random(kSeed);
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
    const auto terrain = [](std::mt19937_64& random, int) { return terrain_pixel(random); };
    CertifiedSplitting certified_areas;
    rate("certified, mixed", 21000, mixed, certified_areas);
    rate("certified, terrain", 20000, terrain, certified_areas);
    rate("rational, mixed", 1050, mixed, areas_by_rational_splitting);
    rate("rational, terrain", 500, terrain, areas_by_rational_splitting);
    rate("boolean sets, mixed", 105, mixed, areas_by_boolean_sets);
    rate("boolean sets, terrain", 20, terrain, areas_by_boolean_sets);
}

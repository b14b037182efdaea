// SPDX-License-Identifier: Apache-2.0
#include "keikan/water/fresnel.hpp"

#include <catch2/catch.hpp>
#include <numbers>

using namespace keikan;

TEST_CASE("fresnel_reflectance: head on, at Brewster's angle and at grazing", "[water][fresnel]") {
    // ((n - 1) / (n + 1))^2 = (0.333 / 2.333)^2
    CHECK(fresnel_reflectance(1) == Approx(0.02037319).epsilon(1e-6));
    CHECK(fresnel_reflectance(0) == Approx(1).epsilon(1e-14));
    // tan(angle) = n: no light of one polarisation, ((n^2 - 1) / (n^2 + 1))^2 of the other; n^2 = 1.776889.
    const double brewster = 1 / std::sqrt(1 + kWaterIndex * kWaterIndex);
    CHECK(fresnel_reflectance(brewster) == Approx(std::pow(0.776889 / 2.776889, 2) / 2).epsilon(1e-9));
    double last = fresnel_reflectance(1);
    for (int i = 99; i >= 0; --i) {
        CHECK(fresnel_reflectance(i / 100.0) >= last);
        last = fresnel_reflectance(i / 100.0);
    }
}

TEST_CASE("fresnel_reflectance: Schlick's approximation errs by 0.059 at 84 degrees", "[water][fresnel]") {
    const double cosine = std::cos(84 * std::numbers::pi / 180);
    const double f0 = fresnel_reflectance(1), schlick = f0 + (1 - f0) * std::pow(1 - cosine, 5);
    CHECK(std::abs(fresnel_reflectance(cosine) - schlick) == Approx(0.059).margin(0.001));
}

TEST_CASE("refracted_cosine: Snell's law", "[water][fresnel]") {
    for (const double degrees : {0.0, 20.0, 60.0, 89.0}) {
        const double outside = degrees * std::numbers::pi / 180;
        const double inside = std::acos(refracted_cosine(std::cos(outside)));
        CHECK(std::sin(outside) == Approx(kWaterIndex * std::sin(inside)).margin(1e-12));
    }
}

// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/catenary.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "keikan/support/input_error.hpp"

using namespace keikan;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Length by adding up a fine polyline: another road to the arc length than the formula.
double polyline_length(const Catenary& wire, int pieces) {
    double length = 0;
    for (int i = 0; i < pieces; ++i) {
        const double from = wire.span_m * i / pieces, to = wire.span_m * (i + 1) / pieces;
        length += std::hypot(to - from, wire.height_at(to) - wire.height_at(from));
    }
    return length;
}

double largest_distance_under_chord(const Catenary& wire, double from, double to) {
    const double slope = (wire.height_at(to) - wire.height_at(from)) / (to - from);
    double largest = 0;
    for (int i = 1; i < 1000; ++i) {
        const double s = from + (to - from) * i / 1000;
        largest = std::max(largest, wire.height_at(from) + slope * (s - from) - wire.height_at(s));
    }
    return largest;
}

}  // namespace

TEST_CASE("catenary: 350 m of wire at 16.4 N/m and 30 kN sags by 8.38 m, 7 mm more than the parabola",
          "[scene][catenary]") {
    const Catenary wire = catenary_from_tension(350, 0, 30'000, 16.4);
    CHECK_THAT(wire.parameter_m, WithinRel(30'000 / 16.4, 1e-15));
    CHECK_THAT(wire.sag_m(), WithinAbs(8.38, 0.005));
    const double a = wire.parameter_m;
    CHECK_THAT(wire.sag_m(), WithinRel(a * (std::cosh(350 / (2 * a)) - 1), 1e-10));  // cosh - 1 cancels
    const double parabola = 16.4 * 350 * 350 / (8 * 30'000.0);
    CHECK_THAT(wire.sag_m() - parabola, WithinAbs(0.007, 0.001));
    CHECK_THAT(wire.low_m, WithinAbs(175, 1e-12));
    CHECK_THAT(-wire.height_at(175), WithinRel(wire.sag_m(), 1e-13));
}

TEST_CASE("catenary: it meets both supports exactly, whatever their heights", "[scene][catenary]") {
    for (const double rise : {0.0, 0.1, -37.0, 120.0, -400.0}) {
        const Catenary wire = catenary_from_tension(312.5, rise, 28'000, 16.4);
        CHECK(wire.height_at(0) == 0);
        CHECK(wire.height_at(wire.span_m) == rise);
        const double before = wire.height_at(std::nextafter(wire.span_m, 0.0));
        CHECK_THAT(before, WithinAbs(rise, 1e-12 * (1 + std::abs(rise))));  // and without a jump
    }
}

TEST_CASE("catenary: the wire's length obeys sqrt(L^2 - h^2) = 2 a sinh(S / 2a)", "[scene][catenary]") {
    for (const double rise : {0.0, 60.0, -150.0}) {
        const Catenary wire = catenary_from_sag(350, rise, 12);
        const double length = wire.length_m();
        const double a = wire.parameter_m;
        CHECK_THAT(std::sqrt(length * length - rise * rise),
                   WithinRel(2 * a * std::sinh(350 / (2 * a)), 1e-14));
        // 20,000 chords of 17 mm each miss s^3 / 24 a^2 of their arc, together under 1e-7 m.
        CHECK_THAT(polyline_length(wire, 20'000), WithinAbs(length, 1e-7));
    }
}

TEST_CASE("catenary: on a steep span the lowest point lies beyond the lower support", "[scene][catenary]") {
    const Catenary wire = catenary_from_tension(300, 200, 30'000, 16.4);
    CHECK(wire.low_m < 0);
    CHECK(wire.slope_at(0) > 0);
    const Catenary mirrored = catenary_from_tension(300, -200, 30'000, 16.4);
    CHECK_THAT(mirrored.low_m, WithinRel(300 - wire.low_m, 1e-14));
    const Catenary gentle = catenary_from_tension(300, 5, 30'000, 16.4);
    CHECK(gentle.low_m > 0);
    CHECK(gentle.low_m < 150);
    CHECK(std::abs(gentle.slope_at(gentle.low_m)) == 0);
}

TEST_CASE("catenary: the sag asked for is the sag that hangs", "[scene][catenary]") {
    for (const double span : {1.0, 60.0, 350.0, 1500.0})
        for (const double slope : {0.0, 0.02, -0.4, 1.5, -3.0})
            for (const double sag_share : {1e-7, 1e-4, 0.024, 0.1, 0.6, 5.0}) {
                const double sag = sag_share * span;
                const Catenary wire = catenary_from_sag(span, slope * span, sag);
                INFO("span " << span << " slope " << slope << " sag " << sag);
                CHECK_THAT(wire.sag_m(), WithinRel(sag, kSagError));
                CHECK(wire.height_at(span) == slope * span);
            }
}

TEST_CASE("catenary: sag and tension say the same", "[scene][catenary]") {
    const Catenary by_tension = catenary_from_tension(350, 42, 30'000, 16.4);
    const Catenary by_sag = catenary_from_sag(350, 42, by_tension.sag_m());
    CHECK_THAT(by_sag.parameter_m, WithinRel(by_tension.parameter_m, 1e-11));
}

TEST_CASE("catenary: the chord error in closed form is the one found by looking", "[scene][catenary]") {
    const Catenary wire = catenary_from_sag(350, 70, 14);
    for (const auto& [from, to] : {std::pair{0.0, 350.0}, {0.0, 20.0}, {170.0, 181.0}, {345.0, 350.0}}) {
        // Looking at 999 places misses the largest by at most (1/1000)^2 of it, and by rounding of heights.
        CHECK_THAT(largest_distance_under_chord(wire, from, to),
                   WithinAbs(wire.chord_error_m(from, to), 1e-6 * wire.chord_error_m(from, to) + 1e-12));
    }
}

TEST_CASE("catenary_stations: no chord leaves the wire by more than was allowed", "[scene][catenary]") {
    for (const double rise : {0.0, 90.0, -220.0})
        for (const double error : {1.0, 0.01, 1e-4}) {
            const Catenary wire = catenary_from_sag(400, rise, 15);
            const std::vector<double> stations = catenary_stations(wire, error);
            CHECK(stations.front() == 0);
            CHECK(stations.back() == 400);
            double worst = 0;
            for (std::size_t i = 1; i < stations.size(); ++i) {
                REQUIRE(stations[i - 1] < stations[i]);
                worst = std::max(worst, wire.chord_error_m(stations[i - 1], stations[i]));
            }
            CHECK(worst <= error * (1 + 1e-12));
            // And no wasteful number of them: fewer by a third would not do on level ground.
            if (rise == 0 && stations.size() > 10) CHECK(worst > error * 0.75);
        }
}

TEST_CASE("catenary_stations: segments grow with the distance of the camera", "[scene][catenary]") {
    const Catenary wire = catenary_from_sag(350, 0, 8.4);
    const auto allowed = [](double from_s, double) { return 1e-5 * (20 + from_s); };
    const std::vector<double> stations = catenary_stations(wire, allowed);
    REQUIRE(stations.size() > 20);
    for (std::size_t i = 1; i < stations.size(); ++i)
        CHECK(wire.chord_error_m(stations[i - 1], stations[i]) <= allowed(stations[i - 1], stations[i]));
    CHECK(stations[1] - stations[0] < stations[stations.size() - 1] - stations[stations.size() - 2]);
}

TEST_CASE("catenary: what cannot hang is bad input", "[scene][catenary]") {
    CHECK_THROWS_AS(catenary_from_tension(0, 1, 30'000, 16.4), InputError);
    CHECK_THROWS_AS(catenary_from_tension(350, 1, -1, 16.4), InputError);
    CHECK_THROWS_AS(catenary_from_tension(350, 1, 30'000, 0), InputError);
    CHECK_THROWS_AS(catenary_from_tension(350, 1, 10, 16.4), InputError);
    CHECK_THROWS_AS(catenary_from_tension(350, std::nan(""), 30'000, 16.4), InputError);
    CHECK_THROWS_AS(catenary_from_sag(350, 0, 0), InputError);
    CHECK_THROWS_AS(catenary_from_sag(350, 0, 1e6), InputError);
    CHECK_THROWS_AS(catenary_from_sag(350, 0, INFINITY), InputError);
}

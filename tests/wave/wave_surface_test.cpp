// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/wave_surface.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "../../src/wave/sine_of_turns.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/wave/counter_random.hpp"

using namespace keikan;

namespace {

const std::vector<StokesWave> kWaves{
    {0.8, 40, 0.3, 1.0}, {0.1, 3, -0.8, 2.0}, {0.02, 0.7, 2.5, 0.5}, {0.3, 11, 1.9, -1.0}};

/// The sum of the series in long double, straight from the definition.
long double height_by_definition(double x, double y, int order, double time_s) {
    long double sum = 0;
    for (const StokesWave& wave : kWaves) {
        const StokesSeries series = stokes_series(wave, order);
        const long double k = 2 * std::numbers::pi_v<long double> / wave.length_m;
        const long double theta = k * (x * std::cos(static_cast<long double>(wave.direction_rad)) +
                                       y * std::sin(static_cast<long double>(wave.direction_rad))) -
                                  static_cast<long double>(series.angular_frequency) * time_s +
                                  wave.phase_rad;
        for (int n = 1; n <= kStokesOrders; ++n)
            sum += series.harmonic_m[static_cast<std::size_t>(n - 1)] * std::cos(n * theta);
    }
    return sum;
}

}  // namespace

TEST_CASE("sine_of_turns: within 2e-12 of the true sine and cosine", "[wave]") {
    CounterRandom random(1);
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double turns = (random.uniform() - 0.5) * (i % 2 == 0 ? 2 : 1000);
        const auto found = sine_of_turns(turns);
        const long double angle =
            2 * std::numbers::pi_v<long double> * (static_cast<long double>(turns) - std::round(turns));
        worst = std::max(worst, static_cast<double>(std::abs(found.sine - std::sin(angle))));
        worst = std::max(worst, static_cast<double>(std::abs(found.cosine - std::cos(angle))));
    }
    CHECK(worst < kSineError);
    CHECK(sine_of_turns(0.0).sine == 0);
    CHECK(sine_of_turns(17.0).cosine == 1);
}

TEST_CASE("WaveSurface: heights are the sum of the series", "[wave][surface]") {
    CounterRandom random(2);
    for (const int order : {1, 3, 5}) {
        const WaveSurface water(kWaves, order, kDeepWater, 12.5);
        for (int i = 0; i < 2000; ++i) {
            const double reach = i % 2 == 0 ? 100 : 50'000;
            const double x = reach * (random.uniform() - 0.5), y = reach * (random.uniform() - 0.5);
            const double error = std::abs(
                static_cast<double>(water.point(x, y).height_m - height_by_definition(x, y, order, 12.5)));
            REQUIRE(error < kWaveHeightError);
        }
    }
}

TEST_CASE("WaveSurface: the slope is the derivative of the height", "[wave][surface]") {
    const WaveSurface water(kWaves);
    CounterRandom random(3);
    for (int i = 0; i < 2000; ++i) {
        const double x = 200 * random.uniform(), y = 200 * random.uniform();
        // Central differences: remainder h^2/6 times the third derivative, which is below 200 for these
        // waves, and heights rounded to 1e-15.
        const double h = 1e-5, bound = h * h / 6 * 200 + 1e-9;
        const double by_x = (water.point(x + h, y).height_m - water.point(x - h, y).height_m) / (2 * h);
        const double by_y = (water.point(x, y + h).height_m - water.point(x, y - h).height_m) / (2 * h);
        const WavePoint p = water.point(x, y);
        REQUIRE(std::abs(p.slope.x - by_x) < bound);
        REQUIRE(std::abs(p.slope.y - by_y) < bound);
        // The normal is upright to both tangents and has unit length.
        const glm::dvec3 n = p.normal();
        REQUIRE(std::abs(glm::dot(n, glm::dvec3(1, 0, p.slope.x))) < 1e-15);
        REQUIRE(std::abs(glm::dot(n, glm::dvec3(0, 1, p.slope.y))) < 1e-15);
        REQUIRE(std::abs(glm::length(n) - 1) < 1e-15);
        REQUIRE(n.z > 0);
    }
}

TEST_CASE("WaveSurface: no wave goes beyond its bounds, nor their sum beyond the crests'",
          "[wave][surface]") {
    for (const StokesWave& wave : kWaves) {
        const WaveSurface water(std::span(&wave, 1));
        const WaveBounds bounds = water.bounds(0);
        const glm::dvec2 d = water.direction(0);
        const double k = 2 * std::numbers::pi / wave.length_m;
        CHECK(glm::length(d) == Approx(1).epsilon(1e-15));
        double mean_square = 0, highest = 0;
        const int steps = 5000;
        std::vector<double> slopes;
        for (int i = 0; i <= steps; ++i) {
            const double s = wave.length_m * i / steps;
            const WavePoint p = water.point(s * d.x, s * d.y);
            const double slope = p.slope.x * d.x + p.slope.y * d.y;
            slopes.push_back(slope);
            highest = std::max(highest, std::abs(p.height_m));
            REQUIRE(std::abs(p.height_m) <= bounds.height_m);
            REQUIRE(std::abs(slope) <= k * bounds.first_m);
            if (i > 0) {
                mean_square += slope * slope / steps;
                const double curvature =
                    (slopes[slopes.size() - 1] - slopes[slopes.size() - 2]) * steps / wave.length_m;
                REQUIRE(std::abs(curvature) <= k * k * bounds.second_m * (1 + 1e-9));
            }
        }
        CHECK(highest > 0.9 * bounds.height_m);
        CHECK(mean_square == Approx(water.slope_variance(0)).epsilon(1e-9));
    }
    const WaveSurface all(kWaves);
    CounterRandom random(4);
    for (int i = 0; i < 5000; ++i)
        REQUIRE(std::abs(all.point(500 * random.uniform(), 500 * random.uniform()).height_m) <=
                all.crest_bound_m());
}

TEST_CASE("WaveSurface: the order in which waves are given does not matter", "[wave][surface]") {
    const WaveSurface water(kWaves);
    const std::vector<StokesWave> reversed(kWaves.rbegin(), kWaves.rend());
    const WaveSurface other(reversed);
    CHECK(water.point(3, 4).height_m == other.point(3, 4).height_m);
    for (std::size_t i = 1; i < water.size(); ++i) CHECK(water.length_m(i - 1) >= water.length_m(i));
}

TEST_CASE("WaveSurface: crests travel in the wave's direction at its speed", "[wave][surface]") {
    const StokesWave wave{0.5, 20, 0.7, 0};
    const double speed = stokes_series(wave, 5).angular_frequency * wave.length_m / (2 * std::numbers::pi);
    const WaveSurface later(std::span(&wave, 1), 5, kDeepWater, 3);
    const double s = speed * 3;
    const WavePoint crest = later.point(s * std::cos(0.7), s * std::sin(0.7));
    CHECK(std::abs(crest.slope.x) < 1e-12);
    CHECK(crest.height_m == Approx(WaveSurface(std::span(&wave, 1)).point(0, 0).height_m).epsilon(1e-12));
    CHECK(crest.height_m > 0.5);  // a Stokes crest is higher than half of the height
}

TEST_CASE("WaveSurface: shares scale their waves, and a share of 0 leaves the wave out", "[wave][surface]") {
    const WaveSurface water(kWaves);
    WaveSurface some;
    some.set_shares(water, std::vector<double>{1, 0.25, 0, 0.5});
    REQUIRE(some.size() == 3);
    double height = 0, slope_x = 0;
    for (const auto& [i, share] : {std::pair(0u, 1.0), std::pair(1u, 0.25), std::pair(3u, 0.5)}) {
        std::vector<double> one(4, 0);
        one[i] = 1;
        WaveSurface single;
        single.set_shares(water, one);
        height += share * single.point(9, 2).height_m;
        slope_x += share * single.point(9, 2).slope.x;
    }
    CHECK(some.point(9, 2).height_m == Approx(height).epsilon(1e-13));
    CHECK(some.point(9, 2).slope.x == Approx(slope_x).epsilon(1e-13));
    CHECK(some.slope_variance(1) == Approx(water.slope_variance(1) / 16).epsilon(1e-15));
    CHECK_THROWS_AS(some.set_shares(water, std::vector<double>{1}), CheckFailure);
}

TEST_CASE("WaveSurface: too many waves are refused", "[wave][surface][input]") {
    CHECK_THROWS_AS(WaveSurface(std::vector<StokesWave>(257, {0.001, 1, 0, 0})), InputError);
    CHECK_NOTHROW(WaveSurface(std::vector<StokesWave>(256, {0.001, 1, 0, 0})));
}

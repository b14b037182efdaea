// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/wind_sea.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "keikan/support/input_error.hpp"
#include "keikan/wave/wave_surface.hpp"

using namespace keikan;

namespace {

double height_variance(const std::vector<StokesWave>& waves) {
    double sum = 0;
    for (const StokesWave& wave : waves) sum += wave.amplitude_m * wave.amplitude_m / 2;
    return sum;
}

}  // namespace

TEST_CASE("wind_sea: a sea that has stopped growing has Pierson and Moskowitz' height", "[wave][spectrum]") {
    // Integral of 0.0081 g^2 w^-5 exp(-5/4 (w_p/w)^4): 0.0081 g^2 / (5 w_p^4), w_p = 0.855 g / U. Below 0.6
    // w_p there is exp(-9.6) of it, above the shortest wave (0.5 m: w = 11) less than 1e-4.
    WindSea sea;
    sea.wind_speed_m_s = 10;
    sea.fetch_m = 5e6;
    sea.shortest_m = 0.5;
    const double peak = 0.855 * kGravity / 10;
    const double expected = 0.0081 * kGravity * kGravity / (5 * std::pow(peak, 4));
    CHECK(height_variance(wind_sea(sea)) == Approx(expected).epsilon(2e-3));
    // Their significant wave height is 0.21 U^2 / g for the wind at 19.5 m, which is 1.026 times that at 10
    // m.
    CHECK(4 * std::sqrt(expected) == Approx(0.21 * 10.26 * 10.26 / kGravity).epsilon(0.01));
}

TEST_CASE("wind_sea: a growing sea has the variance of JONSWAP's spectrum", "[wave][spectrum]") {
    // alpha, w_p and the integral over equal steps of w, written down again.
    WindSea sea;
    sea.wind_speed_m_s = 12;
    sea.fetch_m = 20'000;
    sea.shortest_m = 0.2;
    const double alpha = 0.076 * std::pow(144 / (20'000 * kGravity), 0.22);
    const double peak = 22 * std::cbrt(kGravity * kGravity / (12 * 20'000));
    const double last = std::sqrt(kGravity * 2 * std::numbers::pi / 0.2);
    double variance = 0;
    for (double w = 0.6 * peak + 0.0005; w < last; w += 0.001) {
        const double sigma = w <= peak ? 0.07 : 0.09;
        const double r = std::exp(-std::pow((w - peak) / (sigma * peak), 2) / 2);
        variance += 0.001 * alpha * kGravity * kGravity * std::pow(w, -5) *
                    std::exp(-1.25 * std::pow(peak / w, 4)) * std::pow(3.3, r);
    }
    CHECK(height_variance(wind_sea(sea)) == Approx(variance).epsilon(1e-3));
}

TEST_CASE("wind_sea: the number of waves does not change the sea's height", "[wave][spectrum]") {
    WindSea sea;
    sea.count = 5;
    const double few = height_variance(wind_sea(sea));
    sea.count = 200;
    CHECK(height_variance(wind_sea(sea)) == Approx(few).epsilon(1e-9));
}

TEST_CASE("wind_sea: the waves of every sea are below the breaking limit", "[wave][spectrum]") {
    for (const double wind : {0.5, 2.0, 5.0, 12.0, 30.0})
        for (const double fetch : {100.0, 5'000.0, 1e6})
            for (const int count : {8, 40, 256}) {
                WindSea sea;
                sea.wind_speed_m_s = wind;
                sea.fetch_m = fetch;
                sea.count = count;
                sea.shortest_m = 0.02;
                INFO(wind << " m/s over " << fetch << " m in " << count << " waves");
                REQUIRE_NOTHROW(WaveSurface(wind_sea(sea), 5));
            }
}

TEST_CASE("wind_sea: waves go downwind, within a quarter turn", "[wave][spectrum]") {
    WindSea sea;
    sea.wind_direction_rad = 2;
    sea.count = 200;
    double along = 0;
    for (const StokesWave& wave : wind_sea(sea)) {
        CHECK(std::abs(wave.direction_rad - 2) <= std::numbers::pi / 2);
        along += std::pow(std::cos(wave.direction_rad - 2), 2) / 200;
    }
    // The mean of cos^2 under 2/pi cos^2 is 3/4; its standard deviation is 1/4, here divided by sqrt(200).
    CHECK(along == Approx(0.75).margin(4 * 0.25 / std::sqrt(200)));
}

TEST_CASE("wind_sea: the same seed gives the same waves, another one others", "[wave][spectrum]") {
    WindSea sea;
    CHECK(wind_sea(sea) == wind_sea(sea));
    WindSea other = sea;
    other.seed = 2;
    CHECK_FALSE(wind_sea(sea) == wind_sea(other));
}

TEST_CASE("wind_sea: numbers out of range are refused", "[wave][spectrum][input]") {
    const auto refused = [](auto change) {
        WindSea sea;
        change(sea);
        CHECK_THROWS_AS(wind_sea(sea), InputError);
    };
    refused([](WindSea& s) { s.wind_speed_m_s = 0; });
    refused([](WindSea& s) { s.wind_speed_m_s = std::nan(""); });
    refused([](WindSea& s) { s.fetch_m = 0; });
    refused([](WindSea& s) { s.depth_m = -1; });
    refused([](WindSea& s) { s.count = 0; });
    refused([](WindSea& s) { s.count = 257; });
    refused([](WindSea& s) { s.shortest_m = 0; });
    refused([](WindSea& s) { s.shortest_m = 5000; });
}

TEST_CASE("cox_munk_slope_variance: the clean sea of 1954", "[wave][spectrum]") {
    CHECK(cox_munk_slope_variance(10) == Approx(0.0542));
}

// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/stokes_wave.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "exact_wave.hpp"
#include "keikan/support/input_error.hpp"

using namespace keikan;

namespace {

constexpr double kLength = 2 * std::numbers::pi;  // k = 1

double eta(const StokesSeries& series, double theta) {
    double sum = 0;
    for (int n = 1; n <= kStokesOrders; ++n)
        sum += series.harmonic_m[static_cast<std::size_t>(n - 1)] * std::cos(n * theta);
    return sum;
}

struct SeriesError {
    double elevation, speed;
};

/// Largest error of k eta, and that of the speed, against the numerically exact wave.
SeriesError series_error(double e, double kd, int order) {
    const test::ExactWave exact = test::exact_wave(e, kd, 14);
    const StokesSeries series = stokes_series({e, kLength, 0, 0}, order, kd);
    SeriesError error{0, std::abs(series.angular_frequency / std::sqrt(kGravity) - exact.speed)};
    const std::size_t last = exact.elevation.size() - 1;
    for (std::size_t m = 0; m <= last; ++m) {
        const double theta = static_cast<double>(m) * std::numbers::pi / static_cast<double>(last);
        error.elevation = std::max(error.elevation, std::abs(eta(series, theta) - exact.elevation[m]));
    }
    return error;
}

/// Amplitude of cos(n x) in a wave given from crest to trough.
double exact_harmonic(const test::ExactWave& wave, int n) {
    const std::size_t last = wave.elevation.size() - 1;
    double sum = 0;
    for (std::size_t m = 0; m <= last; ++m)
        sum += (m == 0 || m == last ? 1 : 2) / static_cast<double>(last) * wave.elevation[m] *
               std::cos(n * static_cast<double>(m) * std::numbers::pi / static_cast<double>(last));
    return sum;
}

}  // namespace

TEST_CASE("stokes_series: deep water has the coefficients of Fenton's series", "[wave][stokes]") {
    const double e = 0.2;
    const auto h = stokes_series({e, kLength, 0, 0}, 5).harmonic_m;
    CHECK(h[0] == Approx(e - 3.0 / 8 * std::pow(e, 3) - 422.0 / 384 * std::pow(e, 5)).epsilon(1e-14));
    CHECK(h[1] == Approx(1.0 / 2 * e * e + 1.0 / 3 * std::pow(e, 4)).epsilon(1e-14));
    CHECK(h[2] == Approx(3.0 / 8 * std::pow(e, 3) + 297.0 / 384 * std::pow(e, 5)).epsilon(1e-14));
    CHECK(h[3] == Approx(1.0 / 3 * std::pow(e, 4)).epsilon(1e-14));
    CHECK(h[4] == Approx(125.0 / 384 * std::pow(e, 5)).epsilon(1e-14));
    const double omega = stokes_series({e, kLength, 0, 0}, 5).angular_frequency;
    CHECK(omega / std::sqrt(kGravity) == Approx(1 + e * e / 2 + std::pow(e, 4) / 8).epsilon(1e-14));
}

TEST_CASE("stokes_series: a lower order keeps the lower powers of e", "[wave][stokes]") {
    const double e = 0.2;
    const auto series = [&](int order) { return stokes_series({e, kLength, 0, 0}, order); };
    CHECK(series(1).harmonic_m == std::array<double, 5>{e, 0, 0, 0, 0});
    CHECK(series(2).harmonic_m[1] == Approx(e * e / 2).epsilon(1e-14));
    CHECK(series(3).harmonic_m[0] == Approx(e * (1 - 3.0 / 8 * e * e)).epsilon(1e-14));
    CHECK(series(3).harmonic_m[2] == Approx(3.0 / 8 * std::pow(e, 3)).epsilon(1e-14));
    CHECK(series(4).harmonic_m[3] == Approx(std::pow(e, 4) / 3).epsilon(1e-14));
    CHECK(series(4).harmonic_m[4] == 0);
    CHECK(series(2).angular_frequency == series(1).angular_frequency);
    CHECK(series(4).angular_frequency == series(3).angular_frequency);
}

TEST_CASE("stokes_series: crest and trough are a height apart at every order", "[wave][stokes]") {
    for (int order = 1; order <= 5; ++order)
        for (const double kd : {1.0, 2.0, 40.0}) {
            const StokesSeries series = stokes_series({0.12, kLength, 0, 0}, order, kd);
            CHECK(eta(series, 0) - eta(series, std::numbers::pi) == Approx(0.24).epsilon(1e-13));
        }
}

TEST_CASE("stokes_series: errors in deep water against a numerically exact wave", "[wave][stokes]") {
    // Rounded up in the last digit; kd = 12 is deep to 1e-10.
    CHECK(series_error(0.1, 12, 1).elevation == Approx(5.1e-3).epsilon(0.02));
    CHECK(series_error(0.1, 12, 3).elevation == Approx(6.8e-5).epsilon(0.02));
    CHECK(series_error(0.1, 12, 5).elevation == Approx(1.8e-6).epsilon(0.03));
    CHECK(series_error(0.3, 12, 1).elevation == Approx(5.2e-2).epsilon(0.02));
    CHECK(series_error(0.3, 12, 3).elevation == Approx(8.0e-3).epsilon(0.02));
    CHECK(series_error(0.3, 12, 5).elevation == Approx(2.5e-3).epsilon(0.02));
}

TEST_CASE("stokes_series: at any depth, what order n leaves out falls as e^(n+1)", "[wave][stokes]") {
    for (const double kd : {1.0, 1.5, 3.0, 12.0})
        for (int order = 1; order <= 5; ++order) {
            const double e = kd < 1.5 ? 0.02 : 0.04;
            const SeriesError large = series_error(e, kd, order), small = series_error(e / 2, kd, order);
            INFO("kd " << kd << ", order " << order);
            CHECK(large.elevation / small.elevation == Approx(std::pow(2, order + 1)).epsilon(0.2));
            // The speed has even powers only.
            if (order == 3) CHECK(large.speed / small.speed == Approx(16).epsilon(0.2));
            CHECK(large.speed < (order < 3   ? 10
                                 : order < 5 ? 500
                                             : 5000) *
                                    std::pow(e, order < 3   ? 2
                                                : order < 5 ? 4
                                                            : 6));
        }
}

TEST_CASE("stokes_series: every coefficient is that of numerically exact waves", "[wave][stokes]") {
    // What the series leaves out of harmonic n, divided by the highest power of e that it should hold,
    // vanishes with e^2: extrapolated to e = 0 from three waves, it must be nothing beside the coefficient
    // itself.
    for (const double kd : {0.5, 0.75, 1.0, 1.6, 12.0}) {
        // In shallow water the series goes by e / kd^3.
        const double unit = kd < 0.6 ? 0.0015 : 0.004;
        const double es[] = {4 * unit, 5 * unit, 6 * unit};
        for (int n = 0; n <= kStokesOrders; ++n) {  // 0: the speed
            const int power = n % 2 == 1 ? 5 : 4;
            double left[3], size = 0;
            for (int i = 0; i < 3; ++i) {
                const test::ExactWave exact = test::exact_wave(es[i], kd, 14);
                const StokesSeries series = stokes_series({es[i], kLength, 0, 0}, 5, kd);
                const StokesSeries lower =
                    stokes_series({es[i], kLength, 0, 0}, power == 5 || n == 0 ? 4 : 3, kd);
                const auto in_units = [](const StokesSeries& s) {
                    return s.angular_frequency / std::sqrt(kGravity);
                };
                const auto h = [n](const StokesSeries& s) {
                    return s.harmonic_m[static_cast<std::size_t>(n - 1)];
                };
                const double e_power = std::pow(es[i], power);
                left[i] = (n == 0 ? exact.speed - in_units(series) : exact_harmonic(exact, n) - h(series)) /
                          e_power;
                size = std::abs(n == 0 ? in_units(series) - in_units(lower) : h(series) - h(lower)) / e_power;
            }
            double limit = 0;  // Lagrange, in e^2
            for (int i = 0; i < 3; ++i) {
                double weight = 1;
                for (int j = 0; j < 3; ++j)
                    if (j != i) weight *= es[j] * es[j] / (es[j] * es[j] - es[i] * es[i]);
                limit += weight * left[i];
            }
            INFO("kd " << kd << ", harmonic " << n << ": " << limit << " of " << size);
            CHECK(std::abs(limit) < 5e-4 * size + 2e-4);
        }
    }
}

TEST_CASE("stokes_series: waves beyond the breaking limit are refused", "[wave][stokes][input]") {
    // Deep: H / lambda = 0.142.
    CHECK_NOTHROW(stokes_series({0.0709, 1, 0, 0}, 5));
    CHECK_THROWS_WITH(stokes_series({0.0711, 1, 0, 0}, 5), Catch::Contains("breaks"));
    // Shallow: the limit falls with tanh(k d); kd = 0.5 gives 0.142 tanh 0.5 = 0.0656.
    const double depth = 0.5 / (2 * std::numbers::pi);
    CHECK_NOTHROW(stokes_series({0.0327, 1, 0, 0}, 1, depth));
    CHECK_THROWS_WITH(stokes_series({0.0329, 1, 0, 0}, 1, depth), Catch::Contains("breaks"));
}

TEST_CASE("stokes_series: water too shallow for the series is refused above order 1",
          "[wave][stokes][input]") {
    // H = 0.4, lambda = 20, d = 1.5: Ursell number 47.4.
    CHECK_NOTHROW(stokes_series({0.2, 20, 0, 0}, 1, 1.5));
    CHECK_THROWS_WITH(stokes_series({0.2, 20, 0, 0}, 2, 1.5), Catch::Contains("Ursell"));
}

TEST_CASE("stokes_series: numbers out of range are refused", "[wave][stokes][input]") {
    const double nan = std::nan("");
    CHECK_THROWS_AS(stokes_series({0.1, 0, 0, 0}, 3), InputError);
    CHECK_THROWS_AS(stokes_series({0.1, nan, 0, 0}, 3), InputError);
    CHECK_THROWS_AS(stokes_series({-0.1, 10, 0, 0}, 3), InputError);
    CHECK_THROWS_AS(stokes_series({nan, 10, 0, 0}, 3), InputError);
    CHECK_THROWS_AS(stokes_series({0.1, 10, nan, 0}, 3), InputError);
    CHECK_THROWS_AS(stokes_series({0.1, 10, 0, 0}, 0), InputError);
    CHECK_THROWS_AS(stokes_series({0.1, 10, 0, 0}, 6), InputError);
    CHECK_THROWS_AS(stokes_series({0.1, 10, 0, 0}, 3, 0), InputError);
    CHECK_THROWS_AS(stokes_series({0.1, 10, 0, 0}, 3, nan), InputError);
}

TEST_CASE("stokes_series: still water stays still", "[wave][stokes]") {
    CHECK(stokes_series({0, 10, 0, 0}, 5).harmonic_m == std::array<double, 5>{});
}

TEST_CASE("wave_number: solves the dispersion relation at any depth", "[wave][stokes]") {
    for (const double depth : {0.01, 0.3, 2.0, 50.0, 5000.0})
        for (const double omega : {0.01, 0.3, 1.0, 8.0, 40.0}) {
            const double k = wave_number(omega, depth);
            CHECK(kGravity * k * std::tanh(k * depth) == Approx(omega * omega).epsilon(1e-13));
        }
    CHECK(wave_number(2, kDeepWater) == 4 / kGravity);
}

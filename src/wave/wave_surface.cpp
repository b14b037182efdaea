// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/wave_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"
#include "sine_of_turns.hpp"

namespace keikan {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// A wave's height and d height / d theta.
struct Elevation {
    double height_m, by_theta_m;
};

/// The series at one phase. cos(n t) and sin(n t) by Chebyshev's recurrence: five terms lose two bits.
inline Elevation elevation(double turns, double h1, double h2, double h3, double h4, double h5) {
    const auto [s1, c1] = sine_of_turns(turns);
    const double d = 2 * c1;
    const double c2 = d * c1 - 1, s2 = d * s1;
    const double c3 = d * c2 - c1, s3 = d * s2 - s1;
    const double c4 = d * c3 - c2, s4 = d * s3 - s2;
    const double c5 = d * c4 - c3, s5 = d * s4 - s3;
    return {h1 * c1 + h2 * c2 + h3 * c3 + h4 * c4 + h5 * c5,
            -(h1 * s1 + 2 * h2 * s2 + 3 * h3 * s3 + 4 * h4 * s4 + 5 * h5 * s5)};
}

WaveBounds bounds_of(const std::array<double, kStokesOrders>& harmonic_m) {
    WaveBounds bounds;
    for (int n = 1; n <= kStokesOrders; ++n) {
        const double h = std::abs(harmonic_m[static_cast<std::size_t>(n - 1)]);
        bounds.height_m += h;
        bounds.first_m += n * h;
        bounds.second_m += n * n * h;
    }
    return bounds;
}

}  // namespace

glm::dvec3 WavePoint::normal() const {
    const double length = std::sqrt(1 + slope.x * slope.x + slope.y * slope.y);
    return {-slope.x / length, -slope.y / length, 1 / length};
}

WaveSurface::WaveSurface(std::span<const StokesWave> waves, int order, double depth_m, double time_s) {
    if (waves.size() > kMostWaves)
        throw InputError("there can be " + std::to_string(kMostWaves) + " waves at most, not " +
                         std::to_string(waves.size()));
    if (!std::isfinite(time_s)) throw InputError("the time of waves must be finite");
    std::vector<StokesWave> sorted(waves.begin(), waves.end());
    const auto key = [](const StokesWave& w) {
        return std::tuple(-w.length_m, w.direction_rad, w.phase_rad, w.amplitude_m);
    };
    std::sort(sorted.begin(), sorted.end(),
              [&](const StokesWave& p, const StokesWave& q) { return key(p) < key(q); });
    for (const StokesWave& wave : sorted) {
        const StokesSeries series = stokes_series(wave, order, depth_m);
        length_m_.push_back(wave.length_m);
        amplitude_m_.push_back(wave.amplitude_m);
        turns_x_.push_back(std::cos(wave.direction_rad) / wave.length_m);
        turns_y_.push_back(std::sin(wave.direction_rad) / wave.length_m);
        const double turns = (wave.phase_rad - series.angular_frequency * time_s) / kTurn;
        turns_0_.push_back(turns - std::floor(turns));
        for (std::size_t n = 0; n < series.harmonic_m.size(); ++n)
            harmonic_m_[n].push_back(series.harmonic_m[n]);
        bounds_.push_back(bounds_of(series.harmonic_m));
        // The mean of (sum of n k h_n sin n theta)^2.
        double variance = 0;
        for (std::size_t n = 0; n < series.harmonic_m.size(); ++n) {
            const double slope = static_cast<double>(n + 1) * kTurn / wave.length_m * series.harmonic_m[n];
            variance += slope * slope / 2;
        }
        slope_variance_.push_back(variance);
    }
    sum_up();
}

void WaveSurface::set_shares(const WaveSurface& all, std::span<const double> shares) {
    KEIKAN_CHECK(shares.size() == all.size(), shares.size() << " shares of " << all.size() << " waves");
    const auto clear = [](auto&... lists) { (lists.clear(), ...); };
    clear(length_m_, amplitude_m_, turns_x_, turns_y_, turns_0_, slope_variance_, bounds_);
    for (auto& list : harmonic_m_) list.clear();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double share = shares[i];
        if (!(share > 0)) continue;
        length_m_.push_back(all.length_m_[i]);
        amplitude_m_.push_back(share * all.amplitude_m_[i]);
        turns_x_.push_back(all.turns_x_[i]);
        turns_y_.push_back(all.turns_y_[i]);
        turns_0_.push_back(all.turns_0_[i]);
        for (std::size_t n = 0; n < harmonic_m_.size(); ++n)
            harmonic_m_[n].push_back(share * all.harmonic_m_[n][i]);
        const WaveBounds& b = all.bounds_[i];
        bounds_.push_back({share * b.height_m, share * b.first_m, share * b.second_m});
        slope_variance_.push_back(share * share * all.slope_variance_[i]);
    }
    sum_up();
}

void WaveSurface::sum_up() {
    crest_bound_m_ = 0;
    for (const WaveBounds& bounds : bounds_) crest_bound_m_ += bounds.height_m;
}

WavePoint WaveSurface::point(double x, double y) const {
    WavePoint sum;
    for (std::size_t i = 0; i < size(); ++i) {
        const Elevation e =
            elevation(turns_x_[i] * x + turns_y_[i] * y + turns_0_[i], harmonic_m_[0][i], harmonic_m_[1][i],
                      harmonic_m_[2][i], harmonic_m_[3][i], harmonic_m_[4][i]);
        sum.height_m += e.height_m;
        sum.slope.x += kTurn * turns_x_[i] * e.by_theta_m;
        sum.slope.y += kTurn * turns_y_[i] * e.by_theta_m;
    }
    return sum;
}

void WaveSurface::along(double x, double y, glm::dvec2 speed, std::span<double> height_m,
                        std::span<double> rate) const {
    // Plain pointers, so that the compiler sees one loop without aliasing checks it gives up on.
    const double *const tx = turns_x_.data(), *const ty = turns_y_.data(), *const t0 = turns_0_.data();
    const double *const h1 = harmonic_m_[0].data(), *const h2 = harmonic_m_[1].data();
    const double *const h3 = harmonic_m_[2].data(), *const h4 = harmonic_m_[3].data();
    const double* const h5 = harmonic_m_[4].data();
    double* const __restrict height = height_m.data(), * const __restrict change = rate.data();
    const std::size_t count = size();
    for (std::size_t i = 0; i < count; ++i) {
        const Elevation e = elevation(tx[i] * x + ty[i] * y + t0[i], h1[i], h2[i], h3[i], h4[i], h5[i]);
        height[i] = e.height_m;
        change[i] = kTurn * (tx[i] * speed.x + ty[i] * speed.y) * e.by_theta_m;
    }
}

}  // namespace keikan

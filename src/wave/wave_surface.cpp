// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/wave_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <tuple>

#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"
#include "sine_of_turns.hpp"
#include "trace_lanes.hpp"

namespace keikan {

namespace {

/// The series as polynomials in the cosine: cos n theta = T_n(c), sin n theta = sin theta U_(n-1)(c).
WaveSeries series_of(const std::array<double, kStokesOrders>& h, const WaveBounds& bounds) {
    WaveSeries w;
    const double heights[] = {
        -h[1] + h[3], h[0] - 3 * h[2] + 5 * h[4], 2 * h[1] - 8 * h[3], 4 * h[2] - 20 * h[4], 8 * h[3],
        16 * h[4]};
    std::copy(std::begin(heights), std::end(heights), w.height);
    // By theta: - sin theta d height / d c.
    for (int n = 0; n < kStokesOrders; ++n) w.by_theta[n] = -(n + 1) * heights[n + 1];
    w.crest_m = bounds.height_m;
    w.second_m = bounds.second_m;
    return w;
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
        const double turns = (wave.phase_rad - series.angular_frequency * time_s) / kTurn;
        length_m_.push_back(wave.length_m);
        amplitude_m_.push_back(wave.amplitude_m);
        bounds_.push_back(bounds_of(series.harmonic_m));
        series_.push_back(series_of(series.harmonic_m, bounds_.back()));
        series_.back().turns_x = std::cos(wave.direction_rad) / wave.length_m;
        series_.back().turns_y = std::sin(wave.direction_rad) / wave.length_m;
        series_.back().turns_0 = turns - std::floor(turns);
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
    clear(series_, length_m_, amplitude_m_, slope_variance_, bounds_);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double share = shares[i];
        if (!(share > 0)) continue;
        WaveSeries& series = series_.emplace_back(all.series_[i]);
        for (double& coefficient : series.height) coefficient *= share;
        for (double& coefficient : series.by_theta) coefficient *= share;
        series.crest_m *= share;
        series.second_m *= share;
        length_m_.push_back(all.length_m_[i]);
        amplitude_m_.push_back(share * all.amplitude_m_[i]);
        const WaveBounds& b = all.bounds_[i];
        bounds_.push_back({share * b.height_m, share * b.first_m, share * b.second_m});
        slope_variance_.push_back(share * share * all.slope_variance_[i]);
    }
    sum_up();
}

void WaveSurface::sum_up() {
    crest_bound_m_ = 0;
    for (const WaveBounds& bounds : bounds_) crest_bound_m_ += bounds.height_m;
    double variance = 0;
    for (const double v : slope_variance_) variance += v;
    slope_deviation_ = std::sqrt(variance);
}

WavePoint WaveSurface::point(double x, double y) const {
    const lanes::Sums sums = lanes::sums_at(series_.data(), series_.size(), x, y);
    return {sums.height, {sums.slope[0], sums.slope[1]}};
}

}  // namespace keikan

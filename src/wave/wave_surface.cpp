// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/wave_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>
#include <tuple>

#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"
#include "sine_of_turns.hpp"

namespace keikan {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// A wave's height and d height / d theta, or those of two.
template <typename Real>
struct Elevation {
    Real height_m, by_theta_m;
};

/// The series at one phase. cos(n t) and sin(n t) by Chebyshev's recurrence: five terms lose two bits.
template <typename Real>
inline Elevation<Real> elevation(Real turns, const std::array<Real, kStokesOrders>& h) {
    const SineCosine<Real> t = sine_of_turns(turns);
    const Real c1 = t.cosine, s1 = t.sine, d = c1 + c1;
    const Real c2 = d * c1 - 1, s2 = d * s1;
    const Real c3 = d * c2 - c1, s3 = d * s2 - s1;
    const Real c4 = d * c3 - c2, s4 = d * s3 - s2;
    const Real c5 = d * c4 - c3, s5 = d * s4 - s3;
    return {h[0] * c1 + h[1] * c2 + h[2] * c3 + h[3] * c4 + h[4] * c5,
            -(h[0] * s1 + 2 * h[1] * s2 + 3 * h[2] * s3 + 4 * h[3] * s4 + 5 * h[4] * s5)};
}

TwoDoubles two(const double* from) {
    TwoDoubles values;
    std::memcpy(&values, from, sizeof values);
    return values;
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
        std::array<double, kFields> fields{std::cos(wave.direction_rad) / wave.length_m,
                                           std::sin(wave.direction_rad) / wave.length_m,
                                           turns - std::floor(turns)};
        std::copy(series.harmonic_m.begin(), series.harmonic_m.end(), fields.begin() + kHarmonics);
        add_series(fields);
        length_m_.push_back(wave.length_m);
        amplitude_m_.push_back(wave.amplitude_m);
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
    clear(series_, length_m_, amplitude_m_, slope_variance_, bounds_);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double share = shares[i];
        if (!(share > 0)) continue;
        std::array<double, kFields> fields;
        for (std::size_t field = 0; field < kFields; ++field)
            fields[field] = (field < kHarmonics ? 1 : share) * all.series(i, field);
        add_series(fields);
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

void WaveSurface::add_series(const std::array<double, kFields>& fields) {
    const std::size_t i = size();
    if (i % kTogether == 0) series_.resize(series_.size() + kFields * kTogether, 0);
    for (std::size_t field = 0; field < kFields; ++field) series_[place(i, field)] = fields[field];
}

WavePoint WaveSurface::point(double x, double y) const {
    WavePoint sum;
    for (std::size_t i = 0; i < size(); ++i) {
        std::array<double, kStokesOrders> harmonics;
        for (std::size_t n = 0; n < harmonics.size(); ++n) harmonics[n] = series(i, kHarmonics + n);
        const auto e =
            elevation(series(i, kTurnsX) * x + series(i, kTurnsY) * y + series(i, kTurns0), harmonics);
        sum.height_m += e.height_m;
        sum.slope.x += kTurn * series(i, kTurnsX) * e.by_theta_m;
        sum.slope.y += kTurn * series(i, kTurnsY) * e.by_theta_m;
    }
    return sum;
}

void WaveSurface::along(double x, double y, glm::dvec2 speed, std::span<double> height_m,
                        std::span<double> rate) const {
    KEIKAN_DCHECK(height_m.size() * kFields >= series_.size() && rate.size() * kFields >= series_.size(),
                  "no room for " << size() << " waves");
    const double speed_x = kTurn * speed.x, speed_y = kTurn * speed.y;
    const std::size_t fours = series_.size() / (kFields * kTogether);
    for (std::size_t four = 0; four < fours; ++four) {
        for (std::size_t half = 0; half < kTogether; half += 2) {
            const double* const first = series_.data() + four * kFields * kTogether + half;
            const auto field = [first](std::size_t f) { return two(first + f * kTogether); };
            const TwoDoubles tx = field(kTurnsX), ty = field(kTurnsY);
            const std::array<TwoDoubles, kStokesOrders> harmonics{
                field(kHarmonics), field(kHarmonics + 1), field(kHarmonics + 2), field(kHarmonics + 3),
                field(kHarmonics + 4)};
            const auto e = elevation(tx * x + ty * y + field(kTurns0), harmonics);
            const TwoDoubles change = (tx * speed_x + ty * speed_y) * e.by_theta_m;
            std::memcpy(&height_m[four * kTogether + half], &e.height_m, sizeof change);
            std::memcpy(&rate[four * kTogether + half], &change, sizeof change);
        }
    }
}

}  // namespace keikan

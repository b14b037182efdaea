// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/wind_sea.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "keikan/support/input_error.hpp"
#include "keikan/wave/counter_random.hpp"
#include "keikan/wave/wave_surface.hpp"

namespace keikan {

namespace {

/// The spectrum of elevations over angular frequencies [m2 s].
class Jonswap {
  public:
    explicit Jonswap(const WindSea& sea) {
        const double u = sea.wind_speed_m_s, f = sea.fetch_m, g = kGravity;
        const double grown = 0.855 * g / u;
        peak_ = 22 * std::cbrt(g * g / (u * f));
        alpha_ = 0.076 * std::pow(u * u / (f * g), 0.22);
        if (peak_ <= grown) {
            peak_ = grown;
            alpha_ = 0.0081;
            gamma_ = 1;
        }
    }
    double peak() const { return peak_; }
    double operator()(double w) const {
        const double ratio = peak_ / w, sigma = w <= peak_ ? 0.07 : 0.09;
        const double off = (w - peak_) / (sigma * peak_);
        return alpha_ * kGravity * kGravity / std::pow(w, 5) *
               std::exp(-1.25 * ratio * ratio * ratio * ratio) * std::pow(gamma_, std::exp(-off * off / 2));
    }

  private:
    double peak_, alpha_, gamma_ = 3.3;
};

void require_sea(const WindSea& sea) {
    const auto require = [](bool good, const char* what, double value, const char* range) {
        if (good) return;
        std::ostringstream reason;
        reason << what << " must be " << range << ", not " << value;
        throw InputError(reason.str());
    };
    require(sea.wind_speed_m_s >= 0.5 && sea.wind_speed_m_s <= 60, "the wind's speed", sea.wind_speed_m_s,
            "0.5 to 60 m/s");
    require(std::isfinite(sea.wind_direction_rad), "the wind's direction", sea.wind_direction_rad, "finite");
    require(sea.fetch_m >= 1 && sea.fetch_m <= 1e7, "the fetch", sea.fetch_m, "1 m to 10,000 km");
    require(sea.depth_m > 0, "the depth", sea.depth_m, "greater than 0");
    require(sea.count >= 1 && sea.count <= static_cast<int>(WaveSurface::kMostWaves), "the number of waves",
            sea.count, "1 to 256");
    require(sea.shortest_m >= 0.005 && sea.shortest_m <= 1e4, "the shortest wave", sea.shortest_m,
            "5 mm to 10 km");
}

/// Integral of the spectrum up to each of many frequencies, and of what bands share out.
struct Running {
    std::vector<double> frequency, height, share;
};

Running running_integrals(const Jonswap& spectrum, double from, double to) {
    constexpr int kSteps = 4096;
    Running running;
    double height = 0, slope = 0;
    std::vector<double> slopes;
    const double ratio = std::pow(to / from, 1.0 / kSteps);
    double w = from;
    running.frequency.push_back(w);
    running.height.push_back(0);
    slopes.push_back(0);
    for (int i = 0; i < kSteps; ++i, w *= ratio) {
        const double middle = w * std::sqrt(ratio), width = w * (ratio - 1);
        const double s = spectrum(middle) * width;
        height += s;
        slope += s * std::pow(middle, 4);
        running.frequency.push_back(w * ratio);
        running.height.push_back(height);
        slopes.push_back(slope);
    }
    for (std::size_t i = 0; i < slopes.size(); ++i)
        running.share.push_back((running.height[i] / height + slopes[i] / slope) / 2);
    return running;
}

/// y where x is met, between the entries of two rising lists.
double at(const std::vector<double>& x, const std::vector<double>& y, double where) {
    const auto above = std::lower_bound(x.begin() + 1, x.end() - 1, where);
    const auto i = static_cast<std::size_t>(above - x.begin());
    const double width = x[i] - x[i - 1];
    return width > 0 ? y[i - 1] + (where - x[i - 1]) / width * (y[i] - y[i - 1]) : y[i];
}

/// An angle with density 2/pi cos^2 over (-pi/2, pi/2).
double cosine_squared_angle(double uniform) {
    // The distribution is 1/2 + (a + sin a cos a) / pi; bisected, since it is flat at both ends.
    double low = -std::numbers::pi / 2, high = -low;
    for (int i = 0; i < 52; ++i) {
        const double middle = (low + high) / 2;
        const double below = 0.5 + (middle + std::sin(middle) * std::cos(middle)) / std::numbers::pi;
        (below < uniform ? low : high) = middle;
    }
    return (low + high) / 2;
}

}  // namespace

std::vector<StokesWave> wind_sea(const WindSea& sea) {
    require_sea(sea);
    const Jonswap spectrum(sea);
    const double k_last = 2 * std::numbers::pi / sea.shortest_m;
    const double from = 0.6 * spectrum.peak();
    const double to = std::sqrt(kGravity * k_last * std::tanh(k_last * sea.depth_m));
    if (!(to > spectrum.peak()))
        throw InputError("the wind's longest waves are shorter than the shortest that are asked for");
    const Running running = running_integrals(spectrum, from, to);
    CounterRandom random(random_key(0, 0, 0x77617665u, sea.seed));
    std::vector<StokesWave> waves;
    for (int i = 0; i < sea.count; ++i) {
        const double begin = at(running.share, running.frequency, i / double(sea.count));
        const double end = at(running.share, running.frequency, (i + 1) / double(sea.count));
        const double m0 =
            at(running.frequency, running.height, end) - at(running.frequency, running.height, begin);
        const double w = begin + random.uniform() * (end - begin);
        StokesWave wave;
        wave.length_m = 2 * std::numbers::pi / wave_number(w, sea.depth_m);
        const double depths = 2 * std::numbers::pi * sea.depth_m / wave.length_m;
        wave.amplitude_m =
            std::min(std::sqrt(2 * m0), kSteepestWindWave * std::tanh(depths) * wave.length_m / 2);
        wave.direction_rad = sea.wind_direction_rad + cosine_squared_angle(random.uniform());
        wave.phase_rad = 2 * std::numbers::pi * random.uniform();
        waves.push_back(wave);
    }
    return waves;
}

double cox_munk_slope_variance(double wind_speed_m_s) {
    return 0.003 + 0.00512 * wind_speed_m_s;
}

}  // namespace keikan

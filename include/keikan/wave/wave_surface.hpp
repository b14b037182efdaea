// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "keikan/wave/stokes_wave.hpp"
#include "keikan/wave/wave_series.hpp"

namespace keikan {

/// The water at one place.
struct WavePoint {
    double height_m = 0;     ///< above the mean level
    glm::dvec2 slope{0, 0};  ///< (d height / dx, d height / dy)

    /// Unit normal, upwards.
    glm::dvec3 normal() const;
};

/// What one wave may reach, in its own phase theta: |eta|, |d eta/d theta|, |d2 eta/d theta2| are at most
/// these [m].
struct WaveBounds {
    double height_m = 0;
    double first_m = 0;
    double second_m = 0;
};

/// Elevation of the water above its mean level at one moment: the sum of Stokes waves that do not act on one
/// another, so that elevations and slopes add up.
///
/// Properties:
///   (1) point() is the sum over the waves of their series; slope is its exact derivative.
///   (2) |height| <= crest_bound_m() everywhere.
///   (3) The order in which waves are given changes nothing: they are kept from the longest to the shortest
///       (equal ones by direction, phase, amplitude).
///
/// Requires: coordinates within kFarthestWave_m of the origin.
/// Error:    phases are rounded to 2^-53 of their size in turns: at 10 km from the origin, a wave 0.1 m long
/// is
///           displaced by at most 2e-12 m. Sines are computed with + - * only, the same bits everywhere,
///           within 2e-12. kWaveHeightError bounds all of it for sums of amplitudes up to 100 m.
/// Cost:     about 15 ns a wave (trace_waves: 2 to 6); no allocation but by set_shares().
/// Paper:    section 4.1.
class WaveSurface {
  public:
    WaveSurface() = default;

    /// Errors: InputError (reason only) as stokes_series, and for more than kMostWaves waves.
    explicit WaveSurface(std::span<const StokesWave> waves, int order = kStokesOrders,
                         double depth_m = kDeepWater, double time_s = 0);

    /// Of each wave of `all` the given share, 0 to 1: what it leaves out is not there. Does not allocate when
    /// this object held as many waves before.
    void set_shares(const WaveSurface& all, std::span<const double> shares);

    std::size_t size() const { return length_m_.size(); }
    bool empty() const { return length_m_.empty(); }
    double length_m(std::size_t i) const { return length_m_[i]; }
    double amplitude_m(std::size_t i) const { return amplitude_m_[i]; }
    glm::dvec2 direction(std::size_t i) const {  ///< unit vector
        return {series_[i].turns_x * length_m_[i], series_[i].turns_y * length_m_[i]};
    }
    WaveBounds bounds(std::size_t i) const { return bounds_[i]; }
    /// Mean square slope of wave i along its direction.
    double slope_variance(std::size_t i) const { return slope_variance_[i]; }
    double crest_bound_m() const { return crest_bound_m_; }
    /// Root of the mean square slope of all waves together.
    double slope_deviation() const { return slope_deviation_; }

    WavePoint point(double x, double y) const;

    /// What tracing reads, from the longest wave to the shortest.
    std::span<const WaveSeries> series() const { return series_; }

    static constexpr std::size_t kMostWaves = 256;

  private:
    void sum_up();

    // One entry for each wave.
    std::vector<WaveSeries> series_;
    std::vector<double> length_m_, amplitude_m_;
    std::vector<double> slope_variance_;
    std::vector<WaveBounds> bounds_;
    double crest_bound_m_ = 0, slope_deviation_ = 0;
};

/// Coordinates that waves are made for.
inline constexpr double kFarthestWave_m = 1e6;
/// How far a height may be from the exact sum of the series [m].
inline constexpr double kWaveHeightError = 1e-9;

}  // namespace keikan

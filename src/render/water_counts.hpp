// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <atomic>
#include <cstdint>

#include "keikan/render/water_options.hpp"

namespace keikan {

/// Adds up what the threads counted: whole numbers, so that the order does not matter.
class WaterCounts {
  public:
    void add(const WaterStatistics& s) {
        pixels_ += s.pixels;
        mixed_ += s.mixed_pixels;
        samples_ += s.samples;
        measuring_ += s.measuring_samples;
        rays_ += s.face_rays;
        missed_ += s.missed;
        wave_rays_ += s.wave_rays;
        wave_steps_ += s.wave_steps;
        for (std::size_t i = 0; i < s.histogram.size(); ++i) histogram_[i] += s.histogram[i];
        std::uint64_t most = most_.load();
        while (most < s.most_samples && !most_.compare_exchange_weak(most, s.most_samples)) {
        }
    }
    WaterStatistics sums() const {
        WaterStatistics s{.pixels = pixels_,
                          .mixed_pixels = mixed_,
                          .samples = samples_,
                          .measuring_samples = measuring_,
                          .most_samples = most_,
                          .face_rays = rays_,
                          .wave_rays = wave_rays_,
                          .wave_steps = wave_steps_,
                          .missed = missed_};
        for (std::size_t i = 0; i < s.histogram.size(); ++i) s.histogram[i] = histogram_[i];
        return s;
    }

  private:
    std::atomic<std::uint64_t> pixels_{0}, mixed_{0}, samples_{0}, most_{0}, rays_{0}, missed_{0},
        wave_rays_{0}, wave_steps_{0}, measuring_{0};
    std::array<std::atomic<std::uint64_t>, 17> histogram_{};
};

}  // namespace keikan

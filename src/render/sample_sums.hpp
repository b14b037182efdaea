// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "keikan/image/image.hpp"
#include "keikan/image/srgb.hpp"

namespace keikan {

/// Sums of samples and of their squares, channel by channel.
class SampleSums {
  public:
    void add(double r, double g, double b) {
        const double values[] = {r, g, b};
        for (int i = 0; i < 3; ++i) {
            sum_[i] += values[i];
            squares_[i] += values[i] * values[i];
        }
        ++count_;
    }
    void add(Rgb c) { add(static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)); }
    std::size_t count() const { return count_; }
    double mean(int i) const { return sum_[i] / static_cast<double>(count_); }
    Rgb mean() const {
        return {static_cast<float>(mean(0)), static_cast<float>(mean(1)), static_cast<float>(mean(2))};
    }
    double variance(int i) const {
        if (count_ < 2) return 0;
        const double n = static_cast<double>(count_), m = mean(i);
        return std::max(0.0, (squares_[i] - n * m * m) / (n - 1));
    }

  private:
    double sum_[3] = {0, 0, 0}, squares_[3] = {0, 0, 0};
    std::size_t count_ = 0;
};

/// Linear light as codes of 8 bits, not rounded.
inline double code_of(double linear) {
    return 255 * srgb_from_linear(std::clamp(linear, 0.0, 1.0));
}

/// By how many codes of 8 bits sRGB rises for each unit of linear light.
inline double codes_per_light(double linear) {
    if (linear >= 1) return 0;
    if (linear <= 0.0031308) return 255 * 12.92;
    return 255 * 1.055 / 2.4 * std::pow(linear, 1 / 2.4 - 1);
}

}  // namespace keikan

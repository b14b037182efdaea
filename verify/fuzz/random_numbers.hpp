// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

namespace keikan::fuzz {

/// A sequence of random numbers that is a function of its key alone (SplitMix64, Steele et al. 2014): pixel
/// number n has its own, whatever was drawn for others.
class RandomNumbers {
  public:
    RandomNumbers(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
        : state_(mixed(mixed(mixed(seed) ^ (stream * 0x9E3779B97F4A7C15U)) + index)) {}

    std::uint64_t bits() { return mixed(state_ += 0x9E3779B97F4A7C15U); }
    /// Uniform in [0, 1), a multiple of 2^-53.
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    /// Uniform in low ... high, both included.
    int whole(int low, int high) {
        return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(double probability) { return unit() < probability; }

  private:
    static std::uint64_t mixed(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};

}  // namespace keikan::fuzz

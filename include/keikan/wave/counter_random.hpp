// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

namespace keikan {

/// A 64-bit number mixed so that every bit depends on every bit (the finaliser of SplitMix64: Steele, Lea,
/// Flood 2014, constants of Stafford's variant 13). A bijection.
constexpr std::uint64_t mixed(std::uint64_t v) {
    v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9u;
    v = (v ^ (v >> 27)) * 0x94d049bb133111ebu;
    return v ^ (v >> 31);
}

/// Key of a pixel's random numbers for one purpose. Different pixels, purposes or seeds share no numbers.
constexpr std::uint64_t random_key(int x, int y, std::uint32_t purpose, std::uint32_t seed = 0) {
    const std::uint64_t place =
        std::uint64_t{static_cast<std::uint32_t>(x)} << 32 | static_cast<std::uint32_t>(y);
    return mixed(mixed(place + 0x9e3779b97f4a7c15u) + (std::uint64_t{purpose} << 32 | seed));
}

/// Random numbers that are a function of key and counter, and of nothing else: the same for any order of
/// asking, any tiling and any number of threads.
class CounterRandom {
  public:
    explicit constexpr CounterRandom(std::uint64_t key, std::uint64_t counter = 0)
        : key_(key), counter_(counter) {}

    constexpr std::uint64_t bits() { return mixed(key_ + 0x9e3779b97f4a7c15u * ++counter_); }
    /// Uniform in [0, 1): a multiple of 2^-53.
    constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  private:
    std::uint64_t key_, counter_;
};

}  // namespace keikan

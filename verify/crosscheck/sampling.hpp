// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

#include "keikan/model/pixel.hpp"

namespace keikan::crosscheck {

/// 64 random bits that depend on `seed` and `index` only (the finaliser of SplitMix64, Steele et al. 2014).
constexpr std::uint64_t draw_of(std::uint64_t seed, std::uint64_t index) {
    std::uint64_t z = (seed + 1) * 0x9E3779B97F4A7C15u ^ index * 0xD1B54A32D192ED03u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

constexpr std::uint64_t draw_of(std::uint64_t seed, PixelIndex pixel) {
    return draw_of(seed, static_cast<std::uint64_t>(static_cast<std::uint32_t>(pixel.y)) << 32 |
                             static_cast<std::uint32_t>(pixel.x));
}

}  // namespace keikan::crosscheck

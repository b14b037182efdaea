// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <random>
#include <span>
#include <string_view>

#include "keikan/model/pixel_case.hpp"

namespace keikan::test {

/// Random numbers that are the same on every platform.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  ///< in [0, 1)
    double between(double low, double high) { return low + (high - low) * unit(); }
    int number(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
    }
    bool one_in(int n) { return number(1, n) == 1; }

  private:
    std::mt19937_64 engine_;
};

/// A way of being degenerate. `faces` appends polygons in pixel-local coordinates.
struct Family {
    std::string_view name;
    void (*faces)(Dice&, std::vector<Ring>&);
};

std::span<const Family> families();

/// A pixel of the family: up to 8 faces (32 in "crowd"), moved to a pixel near or far, and with depth planes
/// if asked for: unrelated, equal, crossing, cyclic or nearly coplanar.
PixelCase random_pixel(const Family& family, Dice& dice, bool with_depth);

}  // namespace keikan::test

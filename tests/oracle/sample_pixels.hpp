// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <random>
#include <span>
#include <string_view>

#include "keikan/model/pixel_case.hpp"

namespace keikan::oracle {

/// What is hard about a pixel. Each family lies in the unit square before it is moved to its pixel.
std::span<const std::string_view> sample_families();

/// A question of the named family, a function of the family and the state of `random` alone. Coordinates are
/// image coordinates of the case's pixel, which is (0,0), (4095,2159) or one between.
PixelCase sample_pixel(std::string_view family, std::mt19937_64& random);

/// A pixel as mountains give it: three visible faces of one mesh in front of twenty hidden ones.
PixelCase terrain_pixel(std::mt19937_64& random);

/// `bars` thin bars that cross each other in and out of depth, as the far members of a tower do. Always the
/// same.
PixelCase crowded_pixel(int bars);

}  // namespace keikan::oracle

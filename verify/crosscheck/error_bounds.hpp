// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>

#include "keikan/clip/visible_areas.hpp"

namespace keikan::crosscheck {

/// How far an area may be from the exact one in a pixel of more than 8 faces, and the sum of all areas and
/// the background from 1 in one of more than 32.
///
/// A border of length l whose ends are off by d changes an area by at most l d. The ends of a cut are rounded
/// to multiples of 2^-52, so d <= sqrt(2) 2^-53, and a convex outline has at most 4 of length in a pixel: at
/// most 4 sqrt(2) 2^-53 = 6.3e-16 for each face whose outline borders on the region. 16 of them reach 1e-14
/// if all err to the same side, 250 if their signs are independent. Pixels of real pictures hold up to about
/// 200 faces.
inline constexpr double kCrowdedPixelError = 1e-14;

/// The bound of each area, background included, when `faces` faces can be in the pixel.
constexpr double area_bound(std::size_t faces) {
    return faces <= 8 ? kVisibleAreaError : kCrowdedPixelError;
}

/// The bound of |areas + background - 1|.
constexpr double sum_bound(std::size_t faces) {
    return faces <= 8 ? kVisibleAreaError : faces <= 32 ? kAreaSumError : kCrowdedPixelError;
}

}  // namespace keikan::crosscheck

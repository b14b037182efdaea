// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

namespace keikan {

// What the random numbers of a pixel of water are for; the second ones are those of equation (3)'s samples.
inline constexpr std::uint32_t kPositionNumbers = 1, kSlopeNumbers = 2, kSecondPositionNumbers = 3,
                               kSecondSlopeNumbers = 4, kSunNumbers = 5, kSecondSunNumbers = 6;
/// Of the sun's disc, for shadows on faces.
inline constexpr std::uint32_t kShadowNumbers = 7;
/// Where samples may be, in pixels that hold strips of MirroredWires; which of those places are taken.
inline constexpr std::uint32_t kPlaceNumbers = 8, kChoiceNumbers = 9;

}  // namespace keikan

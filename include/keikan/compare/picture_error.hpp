// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "keikan/image/image.hpp"

namespace keikan::compare {

/// Half a code of 8 bits: what a display of 8 bits need not show, were it linear.
inline constexpr double kVisible = 1.0 / 512;

/// How far a picture is from the truth.
struct PictureError {
    std::uint64_t pixels = 0;  ///< that were looked at
    double rmse = 0;           ///< root of the mean square over pixels and channels, in linear light
    double largest = 0;        ///< of any channel, in linear light
    double off_share = 0;      ///< of pixels with a channel off by more than kVisible, in linear light
    double rmse_codes = 0;  ///< root of the mean square in sRGB codes of 8 bits, not rounded to whole codes
};

/// Compares values as a display shows them: what lies outside of [0, 1] takes the nearer end. Where `only` is
/// not null, pixels with 0 are left out. Without pixels everything is 0.
///
/// Requires: equal sizes.
PictureError picture_error(const Image<Rgb>& picture, const Image<Rgb>& truth,
                           const Image<std::uint8_t>* only = nullptr);

}  // namespace keikan::compare

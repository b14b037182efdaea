// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "keikan/model/pixel_case.hpp"

namespace keikan::fuzzers {

/// A pixel case that any bytes name, so that changing a byte changes a coordinate and not the syntax. At most
/// 8 polygons of at most 7 corners each, convex by exact signs, which are the hulls of what the bytes say.
///
/// A coordinate is one byte: a multiple of 1/128 near the pixel, an earlier coordinate again or an ulp beside
/// it; or a byte and the eight of a double.
PixelCase decoded_case(std::span<const std::uint8_t> bytes);

/// Bytes that decoded_case reads as this case, as far as it fits.
std::string encoded_case(const PixelCase& pixel_case);

}  // namespace keikan::fuzzers

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace keikan::report {

/// `bytes`, deflated (zlib, RFC 1950), in base64 (RFC 4648): what a page carries, and what every browser
/// unpacks by itself. The same bytes give the same text.
std::string packed(std::span<const std::uint8_t> bytes);
inline std::string packed(const std::string& text) {
    return packed(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

/// The values' lowest bytes, then their second ones, and so on, packed: pictures of numbers deflate better
/// so.
std::string packed_planes(std::span<const std::uint16_t> values);
std::string packed_planes(std::span<const std::uint32_t> values);
std::string packed_planes(std::span<const float> values);

/// The 16-bit float of IEEE 754 nearest to `value`, ties to even.
/// Error: relative 2^-11 for 2^-14 <= |value| < 65520; absolute 2^-25 below; infinity above.
std::uint16_t half_float(float value);

}  // namespace keikan::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/packed_bytes.hpp"

#include <zlib.h>

#include <bit>
#include <cmath>
#include <vector>

#include "keikan/support/check.hpp"

namespace keikan::report {
namespace {

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<std::uint8_t> result(size);
    const int code = compress2(result.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), 9);
    KEIKAN_CHECK(code == Z_OK, "zlib could not deflate " << bytes.size() << " bytes: " << code);
    result.resize(size);
    return result;
}

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        const std::size_t there = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < there ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= there ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

template <class Unsigned>
std::string planes(std::span<const Unsigned> values) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(values.size() * sizeof(Unsigned));
    for (std::size_t plane = 0; plane < sizeof(Unsigned); ++plane)
        for (const Unsigned value : values) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * plane)));
    return packed(std::span<const std::uint8_t>(bytes));
}

}  // namespace

std::string packed(std::span<const std::uint8_t> bytes) {
    return base64(deflated(bytes));
}

std::string packed_planes(std::span<const std::uint16_t> values) {
    return planes(values);
}

std::string packed_planes(std::span<const std::uint32_t> values) {
    return planes(values);
}

std::string packed_planes(std::span<const float> values) {
    std::vector<std::uint32_t> bits;
    bits.reserve(values.size());
    for (const float value : values) bits.push_back(std::bit_cast<std::uint32_t>(value));
    return planes(std::span<const std::uint32_t>(bits));
}

std::uint16_t half_float(float value) {
    const auto sign = static_cast<std::uint16_t>(std::signbit(value) ? 0x8000u : 0u);
    const float size = std::abs(value);
    if (std::isnan(value)) return static_cast<std::uint16_t>(sign | 0x7e00u);
    if (size >= 65520.0f) return static_cast<std::uint16_t>(sign | 0x7c00u);
    // Below 2^-14 halves are multiples of 2^-24; above, of 2^-10 of the power of two.
    const int exponent = size < 0x1p-14f ? -14 : std::ilogb(size);
    const auto steps = static_cast<std::uint32_t>(std::nearbyint(std::ldexp(size, 10 - exponent)));
    // 1024 of the steps stand for the hidden bit; a carry into the next power comes out right by itself.
    return static_cast<std::uint16_t>(sign | (static_cast<std::uint32_t>(exponent + 14) * 1024u + steps));
}

}  // namespace keikan::report

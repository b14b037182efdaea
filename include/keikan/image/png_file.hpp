// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>

#include "keikan/image/image.hpp"

namespace keikan {

enum class PngBits { Eight = 8, Sixteen = 16 };  ///< for each of R, G and B

/// Writes a PNG in sRGB, marked as such. Each code is the transfer function's value at the colour, rounded
/// to nearest (keikan/image/srgb.hpp); what lies outside of [0, 1] takes the nearer end.
///
/// Property: (1) The same picture gives the same bytes for any number of threads.
/// Errors: InputError naming the file where it cannot be written (support/atomic_file.hpp: whole or not at
///         all); CheckFailure where a colour is NaN, or the picture has no pixel.
/// Cost:   1000 x 650 pixels of 8 bits take about 20 ms in one thread.
void write_png(const std::filesystem::path& file, const Image<Rgb>& linear, PngBits bits = PngBits::Eight);

/// Reads any PNG as sRGB into linear light; grey and palette are expanded, transparency is ignored.
/// What write_png wrote comes back as the same codes when it is written again.
///
/// Errors: InputError naming the file: missing, broken or cut short, of more than kMaxPngPixels.
Image<Rgb> read_png(const std::filesystem::path& file);

/// Reads a height grid: the values of a grey PNG of 16 bits, as they stand in the file.
///
/// Errors: as read_png, and where the picture is not grey of 16 bits without transparency.
Image<std::uint16_t> read_png_grey16(const std::filesystem::path& file);

/// The inverse of read_png_grey16. Errors: as write_png.
void write_png_grey16(const std::filesystem::path& file, const Image<std::uint16_t>& values);

/// A limit against files that would take all memory: 16384 x 16384.
inline constexpr std::uint64_t kMaxPngPixels = 1u << 28;

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "keikan/image/image.hpp"

namespace keikan {

/// A picture of named channels, as OpenEXR keeps it: "R", "G", "B" for colour, any other name for the rest
/// ("background", "coverage.tower-3").
struct ExrPicture {
    ImageSize size;
    std::map<std::string, Image<float>> channels;  ///< each of `size`
    std::map<std::string, std::string> metadata;   ///< string attributes beyond the standard ones
    friend bool operator==(const ExrPicture&, const ExrPicture&) = default;
};

/// R, G and B of a picture in linear light.
ExrPicture exr_picture(const Image<Rgb>& linear);
/// The inverse: channels R, G and B. Requires: they are there.
Image<Rgb> rgb_image(const ExrPicture& picture);

/// Writes a single-part scanline OpenEXR file of 32-bit floats with ZIP compression (lossless); the same
/// picture gives the same bytes. Colours are linear, sRGB primaries.
///
/// Errors: InputError naming the file where it cannot be written (whole or not at all).
void write_exr(const std::filesystem::path& file, const ExrPicture& picture);

/// A picture that is made while it is written, for more channels than should be in memory at once.
struct ExrRows {
    ImageSize size;
    std::vector<std::string> channels;            ///< names, each once
    std::map<std::string, std::string> metadata;  ///< as ExrPicture
    /// Fills in row `y` of every channel, in the order of `channels`. Called once for each row, from the top.
    std::function<void(int y, std::span<const std::span<float>> channels)> fill_row;
};

/// The same file as that of the ExrPicture with these channels, byte for byte.
///
/// Errors: as above; a name that comes twice, or is empty or longer than 255 bytes, is one, too.
void write_exr(const std::filesystem::path& file, const ExrRows& rows);

/// Reads every channel of a scanline or tiled OpenEXR file, half and integer channels as float. The data
/// window becomes the picture.
///
/// Errors: InputError naming the file: missing, broken or cut short, of more than 2^28 pixels, or with a
///         channel that is sampled more coarsely than the others.
ExrPicture read_exr(const std::filesystem::path& file);

}  // namespace keikan

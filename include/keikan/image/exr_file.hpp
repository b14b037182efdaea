// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

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

/// Reads every channel of a scanline or tiled OpenEXR file, half and integer channels as float. The data
/// window becomes the picture.
///
/// Errors: InputError naming the file: missing, broken or cut short, of more than 2^28 pixels, or with a
///         channel that is sampled more coarsely than the others.
ExrPicture read_exr(const std::filesystem::path& file);

}  // namespace keikan

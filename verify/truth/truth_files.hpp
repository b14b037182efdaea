// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "coverage_picture.hpp"

// Ground truth as files (docs/ground_truth.md). All values are 32-bit floats, compressed without loss.
namespace keikan::truth {

/// Above so many mattes a file of channels is no longer what one wants to open: 128.
inline constexpr std::size_t kMostChannels = 128;

/// Writes the picture as OpenEXR with one channel "coverage.<name>" for each matte, seen or not, and one
/// called "background". Errors: InputError as write_exr.
void write_coverage_channels(const std::filesystem::path& file, const CoveragePicture& picture,
                             std::map<std::string, std::string> metadata);

/// Writes the picture as a Cryptomatte of the layer "CryptoObject", with as many ranks as no coverage is lost
/// for. Where nothing is seen the ids and coverages are 0: that is the background. Errors: InputError as
/// write_exr, and where two names have the same id.
void write_cryptomatte(const std::filesystem::path& file, const CoveragePicture& picture,
                       std::map<std::string, std::string> metadata);

/// Writes one grey PNG of 16 bits for each matte that is seen, and for the background, into `folder`, which
/// is made where it is missing; "mattes.json" there says which is which. A code is 65535 times the exact
/// coverage, to the nearest. Returns how many pictures. Errors: InputError.
std::size_t write_coverage_pngs(const std::filesystem::path& folder, const CoveragePicture& picture);

}  // namespace keikan::truth

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coverage_picture.hpp"

// The Cryptomatte specification, version 1.2 (Psyop): ids from names, ranks of coverage, metadata.
namespace keikan::truth {

/// MurmurHash3_x86_32 with seed 0 (Appleby) of the bytes of `text`.
std::uint32_t murmur_hash(std::string_view text);

/// The bits of the float that stands for `name` in a Cryptomatte: its hash, with the exponent kept away from
/// 0 and 255, so that it is an ordinary number.
std::uint32_t matte_id(std::string_view name);

/// {"name": "01234567", ...}: the id of each name in eight hexadecimal digits.
std::string matte_manifest(std::span<const std::string> names);

/// The header's entries for the mattes called `layer` ("CryptoObject"): name, hash, conversion, manifest,
/// under "cryptomatte/<the first seven digits of the hash of the layer's name>/".
std::map<std::string, std::string> matte_metadata(const std::string& layer,
                                                  std::span<const std::string> names);

/// Two different names with one id, if there are: then a Cryptomatte cannot tell them apart.
struct MatteCollision {
    std::string first, second;
};
std::vector<MatteCollision> matte_collisions(std::span<const std::string> names);

/// The mattes of a pixel as a Cryptomatte ranks them: by falling coverage, of equal ones by rising position;
/// the background is none.
void rank_shares(std::span<const Share> seen, std::vector<Share>& ranked);

/// How many ranks the picture needs for no matte to be lost: at least 2, and even, since a layer holds two.
int ranks_needed(const CoveragePicture& picture);

}  // namespace keikan::truth

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cryptomatte.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

namespace keikan::truth {
namespace {

std::uint32_t scrambled(std::uint32_t block) {
    return std::rotl(block * 0xcc9e2d51u, 15) * 0x1b873593u;
}

/// Up to four bytes, the first lowest.
std::uint32_t little_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
    return value;
}

}  // namespace

std::uint32_t murmur_hash(std::string_view text) {
    std::uint32_t hash = 0;
    std::size_t at = 0;
    for (; at + 4 <= text.size(); at += 4)
        hash = std::rotl(hash ^ scrambled(little_endian(text.substr(at, 4))), 13) * 5 + 0xe6546b64u;
    if (at < text.size()) hash ^= scrambled(little_endian(text.substr(at)));
    hash ^= static_cast<std::uint32_t>(text.size());
    hash = (hash ^ (hash >> 16)) * 0x85ebca6bu;
    hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
    return hash ^ (hash >> 16);
}

std::uint32_t matte_id(std::string_view name) {
    const std::uint32_t hash = murmur_hash(name);
    const std::uint32_t exponent = hash >> 23 & 0xFF;
    return exponent == 0 || exponent == 0xFF ? hash ^ 1u << 23 : hash;
}

std::string matte_manifest(std::span<const std::string> names) {
    nlohmann::ordered_json manifest = nlohmann::ordered_json::object();
    for (const std::string& name : names) manifest[name] = fmt::format("{:08x}", matte_id(name));
    return manifest.dump();
}

std::map<std::string, std::string> matte_metadata(const std::string& layer,
                                                  std::span<const std::string> names) {
    const std::string prefix = "cryptomatte/" + fmt::format("{:08x}", murmur_hash(layer)).substr(0, 7) + "/";
    return {{prefix + "name", layer},
            {prefix + "hash", "MurmurHash3_32"},
            {prefix + "conversion", "uint32_to_float32"},
            {prefix + "manifest", matte_manifest(names)}};
}

std::vector<MatteCollision> matte_collisions(std::span<const std::string> names) {
    std::map<std::uint32_t, std::string> known;
    std::vector<MatteCollision> found;
    for (const std::string& name : names) {
        const auto [at, is_new] = known.emplace(matte_id(name), name);
        if (!is_new && at->second != name) found.push_back({at->second, name});
    }
    return found;
}

void rank_shares(std::span<const Share> seen, std::vector<Share>& ranked) {
    ranked.clear();
    for (const Share& share : seen)
        if (share.matte != Share::kBackground) ranked.push_back(share);
    std::ranges::stable_sort(ranked, std::ranges::greater{}, &Share::coverage);
}

int ranks_needed(const CoveragePicture& picture) {
    int most = 2;
    for (std::size_t pixel = 0; pixel + 1 < picture.begin.size(); ++pixel) {
        const auto seen = std::span(picture.shares)
                              .subspan(picture.begin[pixel], picture.begin[pixel + 1] - picture.begin[pixel]);
        most = std::max(most, static_cast<int>(std::ranges::count_if(
                                  seen, [](const Share& s) { return s.matte != Share::kBackground; })));
    }
    return most + most % 2;
}

}  // namespace keikan::truth

// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>
#include <vector>

#include "cryptomatte.hpp"
#include "keikan/image/exr_file.hpp"
#include "keikan/image/png_file.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan::truth {
namespace {

/// Which channel of a file of channels a share goes to.
std::size_t channel_of(const Share& share, const CoveragePicture& picture) {
    return share.matte == Share::kBackground ? picture.mattes.size() : share.matte;
}

/// The name of a matte as a part of a file's name.
std::string plain_name(const std::string& name) {
    std::string plain = name;
    for (char& c : plain) {
        const bool kept =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
        if (!kept) c = '_';
    }
    return plain;
}

}  // namespace

void write_coverage_channels(const std::filesystem::path& file, const CoveragePicture& picture,
                             std::map<std::string, std::string> metadata) {
    ExrRows rows{picture.size, {}, std::move(metadata), {}};
    for (const std::string& name : picture.mattes) rows.channels.push_back("coverage." + name);
    rows.channels.push_back("background");
    rows.fill_row = [&](int y, std::span<const std::span<float>> channels) {
        for (const std::span<float> channel : channels) std::ranges::fill(channel, 0.0f);
        for (int x = 0; x < picture.size.width; ++x)
            for (const Share& share : picture.at(x, y))
                channels[channel_of(share, picture)][static_cast<std::size_t>(x)] = share.coverage;
    };
    write_exr(file, rows);
}

void write_cryptomatte(const std::filesystem::path& file, const CoveragePicture& picture,
                       std::map<std::string, std::string> metadata) {
    const std::string layer = "CryptoObject";
    for (const MatteCollision& same : matte_collisions(picture.mattes))
        throw InputError(
            file.string(), "",
            fmt::format("a Cryptomatte cannot tell '{}' from '{}': their names have the same hash",
                        same.first, same.second));
    metadata.merge(matte_metadata(layer, picture.mattes));
    std::vector<float> ids;
    for (const std::string& name : picture.mattes) ids.push_back(std::bit_cast<float>(matte_id(name)));

    const int ranks = ranks_needed(picture);
    ExrRows rows{picture.size, {}, std::move(metadata), {}};
    for (int rank = 0; rank < ranks; rank += 2)
        for (const char* component : {"R", "G", "B", "A"})
            rows.channels.push_back(fmt::format("{}{:02}.{}", layer, rank / 2, component));
    std::vector<Share> ranked;
    rows.fill_row = [&](int y, std::span<const std::span<float>> channels) {
        for (const std::span<float> channel : channels) std::ranges::fill(channel, 0.0f);
        for (int x = 0; x < picture.size.width; ++x) {
            rank_shares(picture.at(x, y), ranked);
            for (std::size_t rank = 0; rank < ranked.size(); ++rank) {
                channels[2 * rank][static_cast<std::size_t>(x)] = ids[ranked[rank].matte];
                channels[2 * rank + 1][static_cast<std::size_t>(x)] = ranked[rank].coverage;
            }
        }
    };
    write_exr(file, rows);
}

std::size_t write_coverage_pngs(const std::filesystem::path& folder, const CoveragePicture& picture) {
    std::error_code trouble;
    std::filesystem::create_directories(folder, trouble);
    if (trouble) throw InputError(folder.string(), "", "cannot be made: " + trouble.message());
    std::vector<std::vector<std::size_t>> seen(picture.mattes.size() + 1);  // positions in `shares`
    for (std::size_t i = 0; i < picture.shares.size(); ++i)
        seen[channel_of(picture.shares[i], picture)].push_back(i);

    nlohmann::ordered_json names = nlohmann::ordered_json::object();
    for (std::size_t matte = 0; matte < seen.size(); ++matte) {
        if (seen[matte].empty()) continue;
        const bool background = matte == picture.mattes.size();
        const std::string name = background
                                     ? "background.png"
                                     : fmt::format("{:04}_{}.png", matte, plain_name(picture.mattes[matte]));
        Image<std::uint16_t> codes(picture.size);
        for (const std::size_t i : seen[matte]) {
            const auto pixel = std::ranges::upper_bound(picture.begin, i) - picture.begin.begin() - 1;
            codes.values()[static_cast<std::size_t>(pixel)] = picture.shares[i].code;
        }
        write_png_grey16(folder / name, codes);
        if (!background) names[picture.mattes[matte]] = name;
    }
    write_whole_file(folder / "mattes.json", names.dump(1) + "\n");
    return names.size() + !seen.back().empty();
}

}  // namespace keikan::truth

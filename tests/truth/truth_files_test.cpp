// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth/truth_files.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../support/scratch_folder.hpp"
#include "keikan/image/exr_file.hpp"
#include "keikan/image/png_file.hpp"
#include "keikan/support/input_error.hpp"
#include "truth/cryptomatte.hpp"

using namespace keikan;
using namespace keikan::truth;

namespace {

/// 3 x 2 pixels: all of b; a, c and sky; sky; three mattes; b and sky; all of a.
CoveragePicture example() {
    CoveragePicture picture{{3, 2}, {"a", "b/wire 1", "c", "unseen"}, {}, {}};
    constexpr std::uint32_t kSky = Share::kBackground;
    const std::vector<std::vector<Share>> pixels = {
        {{1, 1, 65535}},
        {{0, 0.25f, 16384}, {2, 0.5f, 32768}, {kSky, 0.25f, 16384}},
        {{kSky, 1, 65535}},
        {{0, 0.125f, 8192}, {1, 0.625f, 40959}, {2, 0.25f, 16384}},
        {{1, 0x1p-140f, 0}, {kSky, 1, 65535}},
        {{0, 1, 65535}}};
    for (const auto& pixel : pixels) picture.add_pixel(pixel);
    return picture;
}

}  // namespace

TEST_CASE("write_coverage_channels: a channel for each matte, and the background", "[truth][files]") {
    const ScratchFolder folder("truth");
    write_coverage_channels(folder / "a.exr", example(), {{"filter", "box"}});
    const ExrPicture back = read_exr(folder / "a.exr");
    REQUIRE(back.channels.size() == 5);
    CHECK(back.metadata.at("filter") == "box");
    const auto values = [&](const char* channel) {
        const auto all = back.channels.at(channel).values();
        return std::vector<float>(all.begin(), all.end());
    };
    CHECK(values("coverage.a") == std::vector<float>{0, 0.25f, 0, 0.125f, 0, 1});
    CHECK(values("coverage.b/wire 1") == std::vector<float>{1, 0, 0, 0.625f, 0x1p-140f, 0});
    CHECK(values("coverage.unseen") == std::vector<float>(6, 0.0f));
    CHECK(values("background") == std::vector<float>{0, 0.25f, 1, 0, 1, 0});
}

TEST_CASE("write_cryptomatte: ids and coverages in pairs, by rank; what a reader takes out is what went in",
          "[truth][files][cryptomatte]") {
    const ScratchFolder folder("truth");
    const CoveragePicture picture = example();
    write_cryptomatte(folder / "a.exr", picture, {});
    const ExrPicture back = read_exr(folder / "a.exr");
    REQUIRE(back.channels.size() == 8);  // 4 ranks: three mattes in a pixel, and an even number
    CHECK(back.metadata.at("cryptomatte/3ae39a5/name") == "CryptoObject");
    const auto manifest = nlohmann::json::parse(back.metadata.at("cryptomatte/3ae39a5/manifest"));

    // As a compositing program does it: for a name, the sum of the coverages of its id over all ranks.
    for (std::size_t matte = 0; matte < picture.mattes.size(); ++matte) {
        const auto id = static_cast<std::uint32_t>(
            std::stoul(manifest[picture.mattes[matte]].get<std::string>(), nullptr, 16));
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 3; ++x) {
                float found = 0, stated = 0;
                for (const std::string layer : {"CryptoObject00", "CryptoObject01"})
                    for (const auto& [id_of, coverage_of] : {std::pair(".R", ".G"), std::pair(".B", ".A")})
                        if (std::bit_cast<std::uint32_t>(back.channels.at(layer + id_of)[{x, y}]) == id)
                            found += back.channels.at(layer + coverage_of)[{x, y}];
                for (const Share& share : picture.at(x, y))
                    if (share.matte == matte) stated = share.coverage;
                CHECK(found == stated);
            }
    }
    CHECK(back.channels.at("CryptoObject00.G")[{0, 1}] == 0.625f);  // the largest first
    CHECK(back.channels.at("CryptoObject00.A")[{0, 1}] == 0.25f);
    CHECK(back.channels.at("CryptoObject01.G")[{0, 1}] == 0.125f);
    CHECK(back.channels.at("CryptoObject00.R")[{2, 0}] == 0);  // sky
    CHECK(back.channels.at("CryptoObject00.G")[{2, 0}] == 0);
}

TEST_CASE("write_cryptomatte: names that it could not tell apart are refused",
          "[truth][files][cryptomatte]") {
    std::vector<std::string> names;
    for (int n = 0; n < 200'000; ++n) names.push_back(std::to_string(n));
    const MatteCollision pair = matte_collisions(names).front();
    CoveragePicture picture{{1, 1}, {pair.first, pair.second}, {}, {}};
    picture.add_pixel({});
    const ScratchFolder folder("truth");
    CHECK_THROWS_AS(write_cryptomatte(folder / "a.exr", picture, {}), InputError);
    CHECK(folder.files() == 0);
}

TEST_CASE("write_coverage_pngs: a grey picture of 16 bits for each matte that is seen", "[truth][files]") {
    const ScratchFolder folder("truth");
    CHECK(write_coverage_pngs(folder / "mattes", example()) == 4);
    std::ifstream in(folder / "mattes/mattes.json");
    const auto names = nlohmann::json::parse(in);
    CHECK(names.size() == 3);
    const auto wire = read_png_grey16(folder / "mattes" / names["b/wire 1"].get<std::string>());
    CHECK(std::vector<std::uint16_t>(wire.values().begin(), wire.values().end()) ==
          std::vector<std::uint16_t>{65535, 0, 0, 40959, 0, 0});
    const auto sky = read_png_grey16(folder / "mattes/background.png");
    CHECK(sky[{1, 0}] == 16384);
}

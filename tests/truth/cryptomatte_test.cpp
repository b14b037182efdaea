// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth/cryptomatte.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

using namespace keikan::truth;

TEST_CASE("murmur_hash, matte_id: the values that the specification and other programs have",
          "[truth][cryptomatte]") {
    CHECK(murmur_hash("") == 0);
    CHECK(matte_id("bunny") == 0x13851a76);    // the specification's manifest
    CHECK(matte_id("default") == 0x42c9679f);  // likewise
    CHECK(murmur_hash("crypto_object") >> 4 ==
          0xf834d0a);  // the key that renderers give the layer of that name
    CHECK(std::bit_cast<float>(matte_id("hello")) == Approx(6.0705627102400005616e-17f).epsilon(1e-6));
    // A name of three tail bytes, letters beyond ASCII, a negative id.
    CHECK(std::bit_cast<float>(matte_id("\xd1\x80\xd0\xb0\xd0\xb2\xd0\xbd\xd0\xb8\xd0\xbd\xd0\xb0")) ==
          Approx(-1.3192631212399999468e-25f).epsilon(1e-6));
}

TEST_CASE("matte_id: always an ordinary number, whatever the hash", "[truth][cryptomatte]") {
    int mended = 0;
    for (int n = 0; n < 20'000; ++n) {
        const std::string name = "object " + std::to_string(n);
        const std::uint32_t hash = murmur_hash(name), exponent = matte_id(name) >> 23 & 0xFF;
        REQUIRE(exponent >= 1);
        REQUIRE(exponent <= 254);
        if (hash == matte_id(name)) continue;
        ++mended;
        CHECK((hash ^ matte_id(name)) == 1u << 23);
    }
    CHECK(mended > 50);  // 2 exponents of 256
}

TEST_CASE("matte_metadata: the four entries of a layer, the manifest as JSON", "[truth][cryptomatte]") {
    const std::vector<std::string> names = {"bunny", "default", "a \"quoted\" name/ä"};
    const auto metadata = matte_metadata("CryptoObject", names);
    REQUIRE(metadata.size() == 4);
    CHECK(metadata.at("cryptomatte/3ae39a5/name") == "CryptoObject");
    CHECK(metadata.at("cryptomatte/3ae39a5/hash") == "MurmurHash3_32");
    CHECK(metadata.at("cryptomatte/3ae39a5/conversion") == "uint32_to_float32");
    const auto manifest = nlohmann::json::parse(metadata.at("cryptomatte/3ae39a5/manifest"));
    REQUIRE(manifest.size() == 3);
    CHECK(manifest["bunny"] == "13851a76");
    CHECK(manifest["default"] == "42c9679f");
    CHECK(manifest[names[2]].get<std::string>().size() == 8);
}

TEST_CASE("rank_shares: by falling coverage, without the background", "[truth][cryptomatte]") {
    const std::vector<Share> seen = {
        {0, 0.125f, 0}, {1, 0.5f, 0}, {4, 0.125f, 0}, {Share::kBackground, 0.25f, 0}};
    std::vector<Share> ranked;
    rank_shares(seen, ranked);
    REQUIRE(ranked.size() == 3);
    CHECK(ranked[0].matte == 1);
    CHECK(ranked[1].matte == 0);
    CHECK(ranked[2].matte == 4);
    CoveragePicture picture{{2, 1}, {"a", "b", "c", "d", "e"}, {}, {}};
    picture.add_pixel(seen);
    picture.add_pixel({});
    CHECK(ranks_needed(picture) == 4);
}

TEST_CASE("matte_collisions: two names with one hash are found", "[truth][cryptomatte]") {
    // Found by hashing names until two met: among 200,000 of them some 5 pairs do.
    std::vector<std::string> names;
    for (int n = 0; n < 200'000; ++n) names.push_back(std::to_string(n));
    const auto found = matte_collisions(names);
    CHECK_FALSE(found.empty());
    for (const MatteCollision& pair : found) CHECK(matte_id(pair.first) == matte_id(pair.second));
}

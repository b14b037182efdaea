// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth/scene_truth.hpp"

#include <catch2/catch.hpp>
#include <map>

#include "../crosscheck/small_picture.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/parallel.hpp"
#include "truth/rounding.hpp"

using namespace keikan;
using namespace keikan::truth;

namespace {

SmallPicture named_picture() {
    SmallPicture picture;
    picture.geometry.objects[0].name = "wall";
    picture.geometry.objects[1].name = "roofs";
    return picture;
}

/// The exact coverage of one pixel by every matte, by CGAL's Boolean set operations on all faces.
std::map<std::uint32_t, mpq_class> by_boolean_sets(const SmallPicture& picture, PixelIndex pixel) {
    std::vector<FaceView> faces;
    for (std::size_t i = 0; i < picture.faces.size(); ++i) faces.push_back(picture.faces[i]);
    const oracle::ExactAreas exact = oracle::areas_by_boolean_sets(pixel, faces, Nearness::ByDepth);
    std::map<std::uint32_t, mpq_class> sums;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        std::uint32_t object = 0;
        while (picture.geometry.first_face[object + 1] <= faces[i].id) ++object;
        if (exact.areas[i] != 0) sums[object] += exact.areas[i];
    }
    if (exact.background != 0) sums[Share::kBackground] = exact.background;
    return sums;
}

SceneTruth truth_of(const SmallPicture& picture, std::uint64_t rational_one_in = 512) {
    SceneTruth truth(picture.faces, picture.geometry, SmallPicture::kSize, 1, rational_one_in);
    for (const ScanBand& band : picture.bands) truth.take(band);
    return truth;
}

}  // namespace

TEST_CASE("scene_truth: every share is the exact coverage of its object, rounded once", "[truth][scene]") {
    const SmallPicture picture = named_picture();
    const SceneTruth truth = truth_of(picture);
    for (int y = 0; y < SmallPicture::kSize.height; ++y)
        for (int x = 0; x < SmallPicture::kSize.width; ++x) {
            const auto exact = by_boolean_sets(picture, {x, y});
            const auto shares = truth.picture().at(x, y);
            CAPTURE(x, y);
            REQUIRE(shares.size() == exact.size());
            auto share = shares.begin();
            for (const auto& [matte, coverage] : exact) {
                CHECK(share->matte == matte);
                CHECK(share->coverage == nearest_float(coverage));
                CHECK(share->code == nearest_code(coverage));
                ++share;
            }
        }
    CHECK(truth.summary().pass());
    CHECK(truth.summary().pixels == 48);
    CHECK(truth.summary().differing_codes == 0);
    CHECK(truth.summary().max_error <= 2 * kVisibleAreaError);
}

TEST_CASE("scene_truth: all pixels by rational splitting give the same picture", "[truth][scene]") {
    const SmallPicture picture = named_picture();
    CHECK(truth_of(picture, 1).picture().shares == truth_of(picture).picture().shares);
    CHECK(truth_of(picture, 1).summary().rungs.rational >= 48);
}

TEST_CASE("scene_truth: the same for any number of threads", "[truth][scene]") {
    const SmallPicture picture = named_picture();
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        return truth_of(picture).picture().shares;
    };
    CHECK(with(1) == with(3));
}

TEST_CASE("scene_truth: a float path that is off by a code is found, and does not touch the truth",
          "[truth][scene][planted]") {
    SmallPicture picture = named_picture();
    const auto sound = truth_of(picture).picture().shares;
    constexpr PixelIndex kOnWire{3, 0};
    picture.part(kOnWire, SmallPicture::Wire).weight += 1.0 / 65535;
    const SceneTruth truth = truth_of(picture);
    CHECK_FALSE(truth.summary().pass());
    CHECK(truth.summary().differing_codes == 1);
    CHECK(truth.summary().differing_at_boundary == 0);
    REQUIRE(truth.summary().differing.size() == 1);
    CHECK(truth.summary().differing[0].pixel == kOnWire);
    CHECK(truth.summary().max_error == Approx(1.0 / 65535).epsilon(1e-6));
    CHECK(truth.picture().shares == sound);
}

TEST_CASE("scene_truth: an object that the float path does not have at all is found",
          "[truth][scene][planted]") {
    SmallPicture picture = named_picture();
    constexpr PixelIndex kOnWire{3, 0};
    DividedPixel& divided = picture.divided(kOnWire);
    divided.part_end = divided.part_begin;  // nothing of the wire
    const SceneTruth truth = truth_of(picture);
    CHECK(truth.summary().differing_codes >= 1);
    CHECK_FALSE(truth.summary().pass());
}

TEST_CASE("scene_truth: a row that never came is a mistake", "[truth][scene]") {
    const SmallPicture picture = named_picture();
    SceneTruth truth(picture.faces, picture.geometry, SmallPicture::kSize);
    truth.take(picture.bands[0]);
    CHECK_THROWS_AS(truth.picture(), CheckFailure);
}

TEST_CASE("scene_truth: objects of one name are one matte", "[truth][scene]") {
    SmallPicture picture = named_picture();
    picture.geometry.objects[1].name = "wall";
    const SceneTruth truth = truth_of(picture);
    REQUIRE(truth.picture().mattes == std::vector<std::string>{"wall"});
    CHECK(truth.picture().at(4, 1)[0] == Share{0, 1, 65535});  // 7/16 of one and 9/16 of the other
}

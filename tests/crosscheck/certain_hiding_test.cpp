// SPDX-License-Identifier: GPL-3.0-or-later
#include "crosscheck/certain_hiding.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "crosscheck/face_bins.hpp"
#include "oracle/exact_areas.hpp"
#include "small_picture.hpp"

using namespace keikan;
using namespace keikan::crosscheck;

namespace {

/// Triangles and quads of every size about the pixels near `origin`, some with corners on the pixels' grid,
/// and planes that are often equal or cross.
ProjectedFaces random_faces(std::mt19937_64& random, double origin) {
    ProjectedFaces faces;
    const auto draw = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    for (int i = 0; i < 12; ++i) {
        const double size = std::exp2(draw(-3, 6));
        const double x = origin + draw(-1, 3), y = origin + draw(-1, 3);
        const int corners = 3 + i % 2;
        const double turn = draw(0, 6.3);
        Ring ring;
        for (int k = 0; k < corners; ++k) {
            Point p{x + size * std::cos(turn + 6.2831853 * k / corners),
                    y + size * std::sin(turn + 6.2831853 * k / corners)};
            if (i % 3 == 0) p = {std::round(p.x), std::round(p.y)};
            ring.push_back(p);
        }
        const double level = std::round(draw(0, 4));
        add_face(faces, ring, {i % 4 == 0 ? draw(-1, 1) : 0, 0, level});
    }
    return faces;
}

}  // namespace

TEST_CASE("CertainHiding: what it drops shows nothing, and what it decides is so", "[crosscheck][exact]") {
    std::mt19937_64 random(1);
    int dropped = 0, decided = 0;
    for (int round = 0; round < 300; ++round) {
        const int origin = round % 2 == 0 ? 0 : 4094;
        const ProjectedFaces faces = random_faces(random, origin);
        const CertainHiding hiding(faces);
        std::vector<std::uint32_t> all(faces.size());
        std::iota(all.begin(), all.end(), 0u);
        std::vector<FaceView> views;
        for (const std::uint32_t i : all) views.push_back(faces[i]);
        for (const PixelIndex pixel : {PixelIndex{origin, origin}, PixelIndex{origin + 1, origin}}) {
            CertainHiding::Remaining remaining;
            hiding(pixel, all, remaining);
            const auto exact = oracle::areas_by_rational_splitting(pixel, views, Nearness::ByDepth);
            for (const std::uint32_t i : all) {
                if (std::ranges::find(remaining.faces, i) != remaining.faces.end()) continue;
                ++dropped;
                CHECK(exact.areas[i] == 0);
            }
            if (!remaining.decided()) continue;
            ++decided;
            CHECK(exact.background == (remaining.cover ? 0 : 1));
            if (remaining.cover) CHECK(exact.areas[*remaining.cover] == 1);
        }
    }
    CHECK(dropped > 1000);
    CHECK(decided > 20);
}

TEST_CASE("FaceBins: a pixel lists every face that has area in it", "[crosscheck][exact]") {
    constexpr ImageSize kSize{5, 4};
    std::mt19937_64 random(2);
    for (int round = 0; round < 30; ++round) {
        const ProjectedFaces faces = random_faces(random, 1);
        const FaceBins bins(faces, kSize);
        for (int y = 0; y < kSize.height; ++y) {
            const FaceBins::Row row = bins.row(y);
            for (int x = 0; x < kSize.width; ++x) {
                const auto listed = row.at(x);
                CHECK(std::ranges::is_sorted(listed));
                for (std::uint32_t i = 0; i < faces.size(); ++i) {
                    const FaceView alone[] = {faces[i]};
                    const auto exact = oracle::areas_by_rational_splitting({x, y}, alone, Nearness::ByDepth);
                    if (exact.areas[0] > 0) CHECK(std::ranges::binary_search(listed, i));
                }
            }
        }
    }
}

TEST_CASE("FaceBins: a face that only touches a pixel is not listed there", "[crosscheck]") {
    ProjectedFaces faces;
    add_face(faces, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {});
    add_face(faces, {{-5, -5}, {0, -5}, {0, 0}}, {});            // touches the picture's corner from outside
    add_face(faces, {{-1e6, -1e6}, {1e6, -1e6}, {0, 1e6}}, {});  // is everywhere
    const FaceBins bins(faces, {3, 3});
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            const FaceBins::Row row = bins.row(y);
            const auto at = row.at(x);
            CHECK(std::vector(at.begin(), at.end()) ==
                  (x == 1 && y == 1 ? std::vector<std::uint32_t>{0, 2} : std::vector<std::uint32_t>{2}));
        }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "keikan/support/check.hpp"
#include "peers/peer.hpp"
#include "planted.hpp"

using namespace keikan;
using namespace keikan::peers;
using namespace keikan::peers::test;

namespace {

Answer answer_of(const Peer& peer, const PixelCase& pixel_case) {
    Answer answer;
    peer.start()(prepared_pixel(pixel_case), answer);
    return answer;
}

struct Known {
    PixelCase pixel_case;
    Answer truth;
};

PixelCase case_of(PixelIndex pixel, std::vector<Ring> polygons) {
    PixelCase made;
    made.pixel = pixel;
    made.polygons = std::move(polygons);
    return made;
}

/// Worked out by hand.
std::vector<Known> known_cases() {
    return {
        // A box before a larger one before the whole pixel and more.
        {case_of({}, {box(0.25, 0.25, 0.5, 0.5), box(0, 0, 0.5, 0.75), box(-1, -1, 2, 2)}),
         {{1.0 / 16, 3.0 / 8 - 1.0 / 16, 1 - 3.0 / 8}, 0}},
        // A hole in the middle; nothing else.
        {case_of({}, {box(0.25, 0.25, 0.75, 0.75), box(0.125, 0.125, 0.875, 0.875)}),
         {{1.0 / 4, 9.0 / 16 - 1.0 / 4}, 7.0 / 16}},
        // One cuts another in two, one lies without area on its border, one is wholly hidden.
        {case_of({}, {box(0.375, 0, 0.625, 1), box(0.375, 0, 0.375, 1), box(0, 0.25, 1, 0.5),
                      box(0.4, 0.3, 0.6, 0.4)}),
         {{1.0 / 4, 0, 3.0 / 16, 0}, 9.0 / 16}},
        // Far away, larger than the pixel, two triangles that share the diagonal.
        {case_of({4095, 2159},
                 {{{4095, 2159}, {4096, 2160}, {4095, 2160}}, {{4090, 2154}, {4100, 2154}, {4100, 2164}}}),
         {{0.5, 0.5}, 0}},
        // No polygon, and one elsewhere.
        {case_of({}, {}), {{}, 1}},
        {case_of({}, {box(3, 3, 4, 4)}), {{0}, 1}},
    };
}

}  // namespace

TEST_CASE("peers: all of them agree with areas worked out by hand", "[peers]") {
    for (const Peer& peer : {splitting(), traversal(), clipper(), geos(), boost_geometry(), cgal_exact()}) {
        const std::vector<Known> all = known_cases();
        for (std::size_t i = 0; i < all.size(); ++i) {
            INFO(peer.name << ", case " << i);
            const Answer answer = answer_of(peer, all[i].pixel_case);
            REQUIRE(answer.areas.size() == all[i].truth.areas.size());
            for (std::size_t k = 0; k < answer.areas.size(); ++k)
                CHECK(answer.areas[k] == Approx(all[i].truth.areas[k]).margin(4e-16).epsilon(0));
            CHECK(answer.background == Approx(all[i].truth.background).margin(4e-16).epsilon(0));
        }
    }
}

TEST_CASE("peers: the paper's clipper to the letter is wrong where departure D2 says so", "[peers]") {
    // A = [0,1]^2 behind two overlapping boxes inside it; what they share is subtracted twice.
    const PixelCase holes =
        case_of({}, {box(0.25, 0.25, 0.625, 0.625), box(0.5, 0.5, 0.875, 0.875), box(0, 0, 1, 1)});
    const double truth = 1 - (9.0 / 64 + 9.0 / 64 - 1.0 / 64);
    CHECK(answer_of(splitting(), holes).areas[2] == Approx(truth).margin(4e-16).epsilon(0));
    CHECK(answer_of(published(), holes).areas[2] == Approx(truth - 1.0 / 64).margin(4e-16).epsilon(0));
}

TEST_CASE("sampling: counts the middles of the cells, the nearest face first", "[peers]") {
    // 4 x 4 samples at 1/8, 3/8, 5/8, 7/8. The first box holds x in {1/8, 3/8}, y = 1/8: 2 of them; the
    // second x <= 5/8 in all rows, 12, less those 2; 4 stay free.
    const PixelCase boxes = case_of({}, {box(0, 0, 0.5, 0.3), box(0, 0, 0.7, 1)});
    CHECK(answer_of(sampling(4), boxes) == Answer{{2.0 / 16, 10.0 / 16}, 4.0 / 16});
    // A sample on the left border counts, one on the right border does not: neighbours share none.
    const PixelCase neighbours = case_of({}, {box(0, 0, 0.375, 1), box(0.375, 0, 1, 1)});
    CHECK(answer_of(sampling(4), neighbours) == Answer{{4.0 / 16, 12.0 / 16}, 0});
    CHECK(answer_of(sampling(64), case_of({}, {box(0, 0, 1, 1)})) == Answer{{1}, 0});
    CHECK(answer_of(sampling(1), case_of({}, {box(0, 0, 0.4, 1)})) == Answer{{0}, 1});
    CHECK_THROWS_AS(sampling(65), CheckFailure);
    CHECK_THROWS_AS(sampling(0), CheckFailure);
}

TEST_CASE("peers: an object that has failed once answers the next pixel all the same", "[peers]") {
    const Ask ask = cgal_inexact().start();
    Answer answer;
    const PixelCase whole = case_of({}, {box(0, 0, 1, 1)});
    for (int i = 0; i < 3; ++i) {
        ask(prepared_pixel(whole), answer);
        CHECK(answer == Answer{{1}, 0});
    }
}

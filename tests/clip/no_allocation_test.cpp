// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <vector>

#include "../support/counted_allocations.hpp"
#include "degenerate_pixels.hpp"
#include "keikan/clip/visible_areas.hpp"

TEST_CASE("visible_areas: a pixel allocates nothing once one of its size has been seen", "[clip][memory]") {
    using namespace keikan;
    using namespace keikan::test;
    std::vector<PixelCase> cases;
    for (const Family& family : families())
        for (const bool with_depth : {false, true}) {
            Dice dice(21);
            for (int i = 0; i < 30; ++i) cases.push_back(random_pixel(family, dice, with_depth));
        }
    std::vector<std::vector<FaceView>> faces;
    for (const PixelCase& pixel_case : cases) faces.push_back(pixel_case.faces());
    const Engine engine = GENERATE(Engine::Splitting, Engine::Traversal);
    VisibleAreas visible_areas(engine);
    const auto see_all = [&] {
        for (std::size_t i = 0; i < cases.size(); ++i) {
            visible_areas(cases[i].pixel, faces[i], cases[i].nearness());
            visible_areas.pieces();
            visible_areas.outlines();
        }
    };
    see_all();
    const std::size_t before = allocations;
    see_all();
    const std::size_t after = allocations;
    CHECK(after == before);
    CHECK(before > 0);
}

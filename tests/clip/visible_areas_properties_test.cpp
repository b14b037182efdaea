// SPDX-License-Identifier: Apache-2.0
//
// The numbered properties of include/keikan/clip/visible_areas.hpp, for the engines that promise them.
#include <catch2/catch.hpp>
#include <cmath>

#include "answers.hpp"

using namespace keikan;
using namespace keikan::test;

namespace {

Engine any_engine() {
    return GENERATE(Engine::Splitting, Engine::Traversal);
}

/// A case whose numbers can be moved by whole pixels and mirrored without rounding: multiples of 2^-30 below
/// 2^20, and slopes of few bits.
PixelCase coarse(PixelCase pixel_case) {
    const auto coarse = [](double v) { return std::round(std::clamp(v, -1e6, 1e6) * 0x1p30) * 0x1p-30; };
    const auto few_bits = [](double v) { return static_cast<double>(static_cast<float>(v)); };
    for (Ring& ring : pixel_case.polygons)
        for (Point& p : ring) p = {coarse(p.x), coarse(p.y)};
    if (pixel_case.depth)
        for (DepthPlane& plane : *pixel_case.depth)
            plane = {coarse(few_bits(plane.a)), coarse(few_bits(plane.b)), coarse(few_bits(plane.c))};
    return pixel_case;
}

/// The largest difference between the areas of the first `faces` faces.
double largest_difference(const Answer& a, const Answer& b, std::size_t faces) {
    double largest = std::abs(a.background - b.background);
    for (std::uint32_t i = 0; i < faces; ++i) largest = std::max(largest, std::abs(a.area(i) - b.area(i)));
    return largest;
}

/// Of the faces of a case.
double area_bound(std::string_view family) {
    return family == "crowd" ? kAreaSumError : kVisibleAreaError;  // "crowd" has 32 faces
}

}  // namespace

TEST_CASE("visible_areas: property 1: areas are positive and at most 1, parts stand by rising face",
          "[clip][property]") {
    VisibleAreas visible_areas(any_engine());
    bool in_range = true;
    for_all_families(11, 60, [&](const PixelCase& pixel_case, Dice&, std::string_view) {
        const Answer seen = ask(visible_areas, pixel_case);
        for (const VisiblePart& part : seen.parts) {
            in_range = in_range && part.area > 0 && part.area <= 1;
            in_range = in_range && part.centroid.x >= 0 && part.centroid.x <= 1 && part.centroid.y >= 0 &&
                       part.centroid.y <= 1;
        }
        in_range = in_range && (seen.background == 0 || (seen.background > 0 && seen.background <= 1));
        in_range = in_range &&
                   std::is_sorted(seen.parts.begin(), seen.parts.end(),
                                  [](const VisiblePart& p, const VisiblePart& q) { return p.face < q.face; });
    });
    CHECK(in_range);
}

TEST_CASE("visible_areas: property 2: areas and background add up to 1", "[clip][property]") {
    VisibleAreas visible_areas(any_engine());
    double worst = 0;
    for_all_families(18, 60, [&](const PixelCase& pixel_case, Dice&, std::string_view) {
        worst = std::max(worst, std::abs(ask(visible_areas, pixel_case).sum() - 1));
    });
    CHECK(worst <= kAreaSumError);
}

TEST_CASE("visible_areas: property 3: the order of the faces does not change a bit", "[clip][property]") {
    VisibleAreas visible_areas(any_engine());
    for_all_families(12, 40, [&](const PixelCase& pixel_case, Dice& dice, std::string_view family) {
        if (!pixel_case.depth) return;
        const std::vector<FaceView> faces = pixel_case.faces();
        const Answer seen = ask(visible_areas, pixel_case.pixel, faces, Nearness::ByDepth);
        std::vector<std::uint32_t> order = same_names(faces.size());
        shuffle(dice, order);
        std::vector<FaceView> moved;
        for (const std::uint32_t face : order) moved.push_back(faces[face]);
        const Answer again = ask(visible_areas, pixel_case.pixel, moved, Nearness::ByDepth);
        INFO(family);
        REQUIRE(same_bits(again, seen, order));
    });
}

TEST_CASE("visible_areas: property 4: neither orientation nor start vertex changes a bit",
          "[clip][property]") {
    VisibleAreas visible_areas(any_engine());
    for_all_families(13, 40, [&](PixelCase pixel_case, Dice& dice, std::string_view family) {
        const Answer seen = ask(visible_areas, pixel_case);
        for (Ring& ring : pixel_case.polygons) {
            if (dice.one_in(2)) std::reverse(ring.begin(), ring.end());
            std::rotate(ring.begin(), ring.begin() + dice.number(0, static_cast<int>(ring.size()) - 1),
                        ring.end());
        }
        INFO(family);
        REQUIRE(same_bits(ask(visible_areas, pixel_case), seen, same_names(pixel_case.polygons.size())));
    });
}

TEST_CASE("visible_areas: property 5: moving faces and pixel by whole pixels does not change a bit",
          "[clip][property]") {
    VisibleAreas visible_areas(any_engine());
    for_all_families(14, 40, [&](const PixelCase& any_case, Dice& dice, std::string_view family) {
        PixelCase pixel_case = coarse(any_case);
        const Answer seen = ask(visible_areas, pixel_case);
        const int right = dice.number(-500, 500), down = dice.number(-500, 500);
        pixel_case.pixel = {pixel_case.pixel.x + right, pixel_case.pixel.y + down};
        for (Ring& ring : pixel_case.polygons)
            for (Point& p : ring) p = {p.x + right, p.y + down};
        if (pixel_case.depth)
            for (DepthPlane& plane : *pixel_case.depth) plane.c -= plane.a * right + plane.b * down;
        INFO(family);
        REQUIRE(same_bits(ask(visible_areas, pixel_case), seen, same_names(pixel_case.polygons.size())));
    });
}

TEST_CASE(
    "visible_areas: property 6: two faces that pass through each other share the pixel along their line",
    "[clip][depth][property]") {
    VisibleAreas visible_areas(any_engine());
    PixelCase pixel_case;
    pixel_case.polygons = {kPixel, kPixel};
    pixel_case.depth = {{1, 0, 0}, {0, 0, 0.25}};  // w: x against 1/4
    const Answer seen = ask(visible_areas, pixel_case);
    CHECK(seen.area(0) == 0.75);
    CHECK(seen.area(1) == 0.25);
    CHECK(seen.background == 0);
}

TEST_CASE(
    "visible_areas: property 6: three strips that overlap in a cycle are each seen where they are in front",
    "[clip][depth][property]") {
    VisibleAreas visible_areas(any_engine());
    PixelCase pixel_case;
    // Strips along the sides of a square; each lies over the next at their common corner.
    pixel_case.polygons = {{{0, 0}, {1, 0}, {1, 0.25}, {0, 0.25}},
                           {{0.75, 0}, {1, 0}, {1, 1}, {0.75, 1}},
                           {{0, 0}, {0.25, 0}, {1, 0.75}, {1, 1}}};
    // At (1, 0): first over second. At (1, 1): second over third. At (0, 0): third over first.
    pixel_case.depth = {{1, 0, 0}, {0, 1, 0.5}, {0, 0, 0.625}};
    const Answer seen = ask(visible_areas, pixel_case);
    CHECK(seen.sum() == Approx(1).margin(kAreaSumError).epsilon(0));
    for (std::uint32_t face = 0; face < 3; ++face) CHECK(seen.area(face) > 0);
}

TEST_CASE("visible_areas: property 7: a face that alone is seen all over the pixel has area 1 exactly",
          "[clip][property]") {
    VisibleAreas visible_areas(any_engine());
    for_all_families(19, 20, [&](PixelCase pixel_case, Dice&, std::string_view family) {
        const double x = pixel_case.pixel.x, y = pixel_case.pixel.y;
        pixel_case.polygons.insert(pixel_case.polygons.begin(),
                                   Ring{{x - 1, y - 1}, {x + 4, y - 1}, {x - 1, y + 4}});
        if (pixel_case.depth) return;
        const Answer seen = ask(visible_areas, pixel_case);
        INFO(family);
        REQUIRE(seen.parts.size() == 1);
        REQUIRE(seen.parts[0].area == 1);
        REQUIRE(seen.parts[0].centroid == Point{0.5, 0.5});
        REQUIRE(seen.background == 0);
    });
}

TEST_CASE("visible_areas: property 8: mirrored faces show the same areas, each within its error",
          "[clip][property]") {
    VisibleAreas visible_areas(any_engine());
    for_all_families(15, 40, [&](const PixelCase& any_case, Dice& dice, std::string_view family) {
        PixelCase pixel_case = coarse(any_case);
        const Answer seen = ask(visible_areas, pixel_case);
        // x -> -x, or x <-> y: pixel i becomes pixel -1 - i, or stands at the mirrored place.
        const bool swap_axes = dice.one_in(2);
        const PixelIndex pixel = pixel_case.pixel;
        pixel_case.pixel = swap_axes ? PixelIndex{pixel.y, pixel.x} : PixelIndex{-1 - pixel.x, pixel.y};
        for (Ring& ring : pixel_case.polygons)
            for (Point& p : ring) p = swap_axes ? Point{p.y, p.x} : Point{-p.x, p.y};
        if (pixel_case.depth)
            for (DepthPlane& plane : *pixel_case.depth)
                plane = swap_axes ? DepthPlane{plane.b, plane.a, plane.c}
                                  : DepthPlane{-plane.a, plane.b, plane.c};
        const Answer mirrored = ask(visible_areas, pixel_case);
        INFO(family);
        REQUIRE(largest_difference(seen, mirrored, pixel_case.polygons.size()) <= 2 * area_bound(family));
    });
}

TEST_CASE("visible_areas: property 9: a face asked about again shows nothing and hides nothing more",
          "[clip][property]") {
    VisibleAreas visible_areas(any_engine());
    for_all_families(16, 40, [&](PixelCase pixel_case, Dice&, std::string_view family) {
        const std::size_t n = pixel_case.polygons.size();
        const Answer seen = ask(visible_areas, pixel_case);
        for (std::size_t i = 0; i < n; ++i) pixel_case.polygons.push_back(pixel_case.polygons[i]);
        if (pixel_case.depth)
            pixel_case.depth->insert(pixel_case.depth->end(), pixel_case.depth->begin(),
                                     pixel_case.depth->begin() + static_cast<std::ptrdiff_t>(n));
        const Answer twice = ask(visible_areas, pixel_case);
        INFO(family);
        REQUIRE(largest_difference(seen, twice, n) <= 2 * area_bound(family));
        for (std::uint32_t i = 0; i < n; ++i)
            REQUIRE(twice.area(i + static_cast<std::uint32_t>(n)) <= 2 * area_bound(family));
    });
}

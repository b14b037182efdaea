// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/visible_areas.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <vector>

#include "degenerate_pixels.hpp"

namespace {

using namespace keikan;
using namespace keikan::test;

/// A coverage that outlives the next question.
struct Answer {
    std::vector<VisiblePart> parts;
    double background = 0;

    double area(std::uint32_t face) const {
        for (const VisiblePart& part : parts)
            if (part.face == face) return part.area;
        return 0;
    }
    double sum() const {
        double total = background;
        for (const VisiblePart& part : parts) total += part.area;
        return total;
    }
};

Answer ask(VisibleAreas& visible_areas, PixelIndex pixel, std::span<const FaceView> faces,
           Nearness nearness) {
    const PixelCoverage coverage = visible_areas(pixel, faces, nearness);
    return {{coverage.parts.begin(), coverage.parts.end()}, coverage.background};
}

Answer ask(const PixelCase& pixel_case) {
    VisibleAreas visible_areas;
    const std::vector<FaceView> faces = pixel_case.faces();
    return ask(visible_areas, pixel_case.pixel, faces, pixel_case.nearness());
}

Answer ask(std::vector<Ring> polygons, std::optional<std::vector<DepthPlane>> depth = {}) {
    PixelCase pixel_case;
    pixel_case.polygons = std::move(polygons);
    pixel_case.depth = std::move(depth);
    return ask(pixel_case);
}

bool same_bits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Bit for bit the same, where face i of `a` is called name[i] in `b`.
bool same_bits(const Answer& a, const Answer& b, const std::vector<std::uint32_t>& name) {
    if (!same_bits(a.background, b.background) || a.parts.size() != b.parts.size()) return false;
    return std::all_of(a.parts.begin(), a.parts.end(), [&](const VisiblePart& p) {
        return std::any_of(b.parts.begin(), b.parts.end(), [&](const VisiblePart& q) {
            return q.face == name[p.face] && same_bits(p.area, q.area) &&
                   same_bits(p.centroid.x, q.centroid.x) && same_bits(p.centroid.y, q.centroid.y);
        });
    });
}

std::vector<std::uint32_t> same_names(std::size_t n) {
    std::vector<std::uint32_t> names(n);
    for (std::size_t i = 0; i < n; ++i) names[i] = static_cast<std::uint32_t>(i);
    return names;
}

void shuffle(Dice& dice, std::vector<std::uint32_t>& order) {
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[static_cast<std::size_t>(dice.number(0, static_cast<int>(i) - 1))]);
}

const Ring kPixel{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// Calls check(case, family name) for pixels of every family, with and without depth.
template <class Check>
void for_all_families(std::uint64_t seed, int count, Check check) {
    for (const Family& family : families())
        for (const bool with_depth : {false, true}) {
            Dice dice(seed);
            for (int i = 0; i < count; ++i) check(random_pixel(family, dice, with_depth), dice, family.name);
        }
}

}  // namespace

TEST_CASE("visible_areas: without faces all is background", "[clip]") {
    const Answer seen = ask(std::vector<Ring>{});
    CHECK(seen.parts.empty());
    CHECK(seen.background == 1);
}

TEST_CASE("visible_areas: a face over the whole pixel has area 1 and its centre as centroid, exactly",
          "[clip]") {
    for (const Ring& ring : {kPixel, Ring{{-3, -8}, {9, 0.5}, {-2, 8}},
                             Ring{{1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}, {-1e6, -1e6}}}) {
        const Answer seen = ask({ring});
        REQUIRE(seen.parts.size() == 1);
        CHECK(seen.parts[0].area == 1);
        CHECK(seen.parts[0].centroid == Point{0.5, 0.5});
        CHECK(seen.background == 0);
    }
}

TEST_CASE("visible_areas: a face hidden behind one over the whole pixel takes nothing from it, exactly",
          "[clip][depth]") {
    // The triangle's plane reaches nearer than the square's, but not where the triangle is.
    const Answer seen =
        ask({Ring{{0.1, 0.1}, {0.9, 0.2}, {0.3, 0.7}}, Ring{{-1, -1}, {3, -1}, {-1, 3}}, kPixel},
            {{{0, 0, 1}, {1, 1, 1.5}, {0, 0, 1}}});
    REQUIRE(seen.parts.size() == 1);
    CHECK(seen.parts[0].face == 1);
    CHECK(seen.parts[0].area == 1);
    CHECK(seen.parts[0].centroid == Point{0.5, 0.5});
    CHECK(seen.background == 0);
}

TEST_CASE("visible_areas: a wire a sixteenth of a pixel thick covers a sixteenth", "[clip][wire]") {
    const Answer seen = ask({Ring{{-100, 0.25}, {100, 0.25}, {100, 0.3125}, {-100, 0.3125}}});
    REQUIRE(seen.parts.size() == 1);
    CHECK(seen.parts[0].area == Approx(1.0 / 16).margin(kVisibleAreaError).epsilon(0));
    CHECK(seen.parts[0].centroid.x == Approx(0.5).margin(1e-15).epsilon(0));
    CHECK(seen.parts[0].centroid.y == Approx(0.28125).margin(1e-15).epsilon(0));
}

TEST_CASE("visible_areas: two faces that share an edge leave no gap between them", "[clip][degenerate]") {
    const Point a{-0.3, 0.1}, b{1.7, 0.9};
    const Answer seen = ask({Ring{a, b, {3, -5}, {-3, -5}}, Ring{a, b, {3, 6}, {-3, 6}}});
    CHECK(seen.background == 0);
    CHECK(seen.sum() == Approx(1).margin(kAreaSumError).epsilon(0));
}

TEST_CASE("visible_areas: faces without area show nothing", "[clip][degenerate]") {
    const Answer seen = ask({Ring{}, Ring{{0.5, 0.5}}, Ring{{0, 0}, {1, 1}}, Ring{{0, 0}, {0.5, 0.5}, {1, 1}},
                             Ring{{0.2, 0.2}, {0.2, 0.2}, {0.2, 0.2}}, Ring{{-1, -1}, {0, 3}, {0, 0}},
                             Ring{{1, 0}, {2, 0}, {2, 1}, {1, 1}}});
    CHECK(seen.parts.empty());
    CHECK(seen.background == 1);
}

TEST_CASE("visible_areas: an outline that rounding folded is taken as its convex hull",
          "[clip][degenerate]") {
    const Answer seen = ask({Ring{{0, 0}, {1, 1}, {1, 0}, {0, 1}}});
    CHECK(seen.area(0) == 1);
}

TEST_CASE("visible_areas: in order, the earlier face is seen, whatever the depth planes say", "[clip]") {
    PixelCase pixel_case;
    pixel_case.polygons = {{{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}, kPixel};
    const std::vector<FaceView> faces = pixel_case.faces();
    VisibleAreas visible_areas;
    const Answer seen = ask(visible_areas, {0, 0}, faces, Nearness::InOrder);
    CHECK(seen.area(0) == 0.5);
    CHECK(seen.area(1) == 0.5);
}

TEST_CASE("visible_areas: where w is equal everywhere the smaller id is seen", "[clip][depth]") {
    const DepthPlane plane{0.125, -3, 7};
    for (const FaceId first : {FaceId{3}, FaceId{8}}) {
        const FaceView faces[] = {{first, kPixel, plane}, {5, kPixel, plane}};
        VisibleAreas visible_areas;
        const Answer seen = ask(visible_areas, {0, 0}, faces, Nearness::ByDepth);
        CHECK(seen.area(0) == (first < 5 ? 1 : 0));
        CHECK(seen.area(1) == (first < 5 ? 0 : 1));
    }
}

TEST_CASE("visible_areas: (6) two faces that pass through each other share the pixel along their line",
          "[clip][depth]") {
    const Answer seen = ask({kPixel, kPixel}, {{{1, 0, 0}, {0, 0, 0.25}}});  // w: x against 1/4
    CHECK(seen.area(0) == 0.75);
    CHECK(seen.area(1) == 0.25);
    CHECK(seen.background == 0);
}

TEST_CASE("visible_areas: (6) three strips that overlap in a cycle are each seen where they are in front",
          "[clip][depth]") {
    // Strips along the sides of a square; each lies over the next at their common corner.
    const std::vector<Ring> strips{{{0, 0}, {1, 0}, {1, 0.25}, {0, 0.25}},
                                   {{0.75, 0}, {1, 0}, {1, 1}, {0.75, 1}},
                                   {{0, 0}, {0.25, 0}, {1, 0.75}, {1, 1}}};
    // At (1, 0): first over second. At (1, 1): second over third. At (0, 0): third over first.
    const Answer seen = ask(strips, {{{1, 0, 0}, {0, 1, 0.5}, {0, 0, 0.625}}});
    CHECK(seen.sum() == Approx(1).margin(kAreaSumError).epsilon(0));
    for (std::uint32_t face = 0; face < 3; ++face) CHECK(seen.area(face) > 0);
}

TEST_CASE("visible_areas: (1) areas are positive and at most 1, (2) they and the background add up to 1",
          "[clip][property]") {
    double worst = 0;
    bool in_range = true;
    for_all_families(11, 60, [&](const PixelCase& pixel_case, Dice&, std::string_view) {
        const Answer seen = ask(pixel_case);
        for (const VisiblePart& part : seen.parts) {
            in_range = in_range && part.area > 0 && part.area <= 1;
            in_range = in_range && part.centroid.x >= 0 && part.centroid.x <= 1 && part.centroid.y >= 0 &&
                       part.centroid.y <= 1;
        }
        in_range = in_range && (seen.background == 0 || (seen.background > 0 && seen.background <= 1));
        in_range = in_range &&
                   std::is_sorted(seen.parts.begin(), seen.parts.end(),
                                  [](const VisiblePart& p, const VisiblePart& q) { return p.face < q.face; });
        worst = std::max(worst, std::abs(seen.sum() - 1));
    });
    CHECK(in_range);
    CHECK(worst <= kAreaSumError);
}

TEST_CASE("visible_areas: (3) the order of the faces does not change a bit", "[clip][property]") {
    VisibleAreas visible_areas;
    for_all_families(12, 40, [&](PixelCase pixel_case, Dice& dice, std::string_view family) {
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

TEST_CASE("visible_areas: (4) neither orientation nor start vertex changes a bit", "[clip][property]") {
    for_all_families(13, 40, [](PixelCase pixel_case, Dice& dice, std::string_view family) {
        const Answer seen = ask(pixel_case);
        for (Ring& ring : pixel_case.polygons) {
            if (dice.one_in(2)) std::reverse(ring.begin(), ring.end());
            std::rotate(ring.begin(), ring.begin() + dice.number(0, static_cast<int>(ring.size()) - 1),
                        ring.end());
        }
        INFO(family);
        REQUIRE(same_bits(ask(pixel_case), seen, same_names(pixel_case.polygons.size())));
    });
}

TEST_CASE("visible_areas: (5) moving faces and pixel by whole pixels does not change a bit",
          "[clip][property]") {
    for_all_families(14, 40, [](PixelCase pixel_case, Dice& dice, std::string_view family) {
        // Multiples of 2^-30 below 2^22 and depth slopes of few bits can be moved exactly.
        const auto coarse = [](double v) { return std::round(std::clamp(v, -1e6, 1e6) * 0x1p30) * 0x1p-30; };
        const auto few_bits = [](double v) { return static_cast<double>(static_cast<float>(v)); };
        for (Ring& ring : pixel_case.polygons)
            for (Point& p : ring) p = {coarse(p.x), coarse(p.y)};
        if (pixel_case.depth)
            for (DepthPlane& plane : *pixel_case.depth)
                plane = {coarse(few_bits(plane.a)), coarse(few_bits(plane.b)), coarse(few_bits(plane.c))};
        const Answer seen = ask(pixel_case);
        const int right = dice.number(-500, 500), down = dice.number(-500, 500);
        pixel_case.pixel = {pixel_case.pixel.x + right, pixel_case.pixel.y + down};
        for (Ring& ring : pixel_case.polygons)
            for (Point& p : ring) p = {p.x + right, p.y + down};
        if (pixel_case.depth)
            for (DepthPlane& plane : *pixel_case.depth) plane.c -= plane.a * right + plane.b * down;
        INFO(family);
        REQUIRE(same_bits(ask(pixel_case), seen, same_names(pixel_case.polygons.size())));
    });
}

TEST_CASE("visible_areas: mirroring the pixel changes no area by more than its error", "[clip][property]") {
    double worst = 0;
    for_all_families(15, 40, [&](PixelCase pixel_case, Dice&, std::string_view family) {
        if (family == "enormous" || family == "tiny-numbers") return;  // not mirrored exactly
        pixel_case.pixel = {};
        for (Ring& ring : pixel_case.polygons)
            for (Point& p : ring)
                p = {std::round(p.x * 0x1p25) * 0x1p-25, std::round(p.y * 0x1p25) * 0x1p-25};
        pixel_case.depth.reset();
        const Answer seen = ask(pixel_case);
        for (Ring& ring : pixel_case.polygons)
            for (Point& p : ring) p.x = 1 - p.x;
        const Answer mirrored = ask(pixel_case);
        if (family == "crowd") return;  // the bound holds up to 8 faces
        for (std::uint32_t i = 0; i < pixel_case.polygons.size(); ++i)
            worst = std::max(worst, std::abs(seen.area(i) - mirrored.area(i)));
    });
    CHECK(worst <= 2 * kVisibleAreaError);
}

TEST_CASE("visible_areas: a face listed twice shows as much as once", "[clip][property]") {
    double worst = 0;
    for_all_families(16, 40, [&](PixelCase pixel_case, Dice&, std::string_view family) {
        if (family == "crowd") return;
        const Answer seen = ask(pixel_case);
        const std::size_t n = pixel_case.polygons.size();
        for (std::size_t i = 0; i < n; ++i) pixel_case.polygons.push_back(pixel_case.polygons[i]);
        if (pixel_case.depth)
            pixel_case.depth->insert(pixel_case.depth->end(), pixel_case.depth->begin(),
                                     pixel_case.depth->begin() + static_cast<std::ptrdiff_t>(n));
        const Answer twice = ask(pixel_case);
        worst = std::max(worst, std::abs(twice.background - seen.background));
        for (std::uint32_t i = 0; i < n; ++i) {
            worst = std::max(worst, std::abs(seen.area(i) - twice.area(i)));
            worst = std::max(worst, twice.area(i + static_cast<std::uint32_t>(n)));
        }
    });
    CHECK(worst <= 2 * kVisibleAreaError);
}

TEST_CASE("visible_areas: the pieces of each face add up to its area", "[clip][pieces]") {
    double worst = 0;
    VisibleAreas visible_areas;
    for_all_families(17, 20, [&](const PixelCase& pixel_case, Dice&, std::string_view) {
        const std::vector<FaceView> faces = pixel_case.faces();
        const Answer seen = ask(visible_areas, pixel_case.pixel, faces, pixel_case.nearness());
        std::vector<double> sums(faces.size());
        double free = 0;
        for (const VisiblePiece& piece : visible_areas.pieces()) {
            double twice = 0;
            for (std::size_t i = 2; i < piece.ring.size(); ++i) {
                const Point o = piece.ring[0], p = piece.ring[i - 1], q = piece.ring[i];
                twice += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
            }
            (piece.face == VisiblePiece::kBackground ? free : sums[piece.face]) += twice / 2;
        }
        worst = std::max(worst, std::abs(free - seen.background));
        for (std::uint32_t i = 0; i < faces.size(); ++i)
            worst = std::max(worst, std::abs(sums[i] - seen.area(i)));
    });
    CHECK(worst <= kAreaSumError);
}

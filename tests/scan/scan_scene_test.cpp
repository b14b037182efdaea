// SPDX-License-Identifier: Apache-2.0
#include "keikan/scan/scan_scene.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "keikan/clip/visible_areas.hpp"
#include "keikan/support/parallel.hpp"
#include "small_scenes.hpp"

using namespace keikan;
using namespace keikan::small_scenes;

namespace {

/// Every pixel of the scan against visible_areas of every face there, and spans against themselves.
void check_against_visible_areas(const Geometry& geometry, const Camera& camera, double bound) {
    const ProjectedFaces faces = project_faces(geometry, camera);
    const std::vector<Shown> all = shown(scanned(geometry, camera), camera.size);
    VisibleAreas visible_areas;
    double worst = 0;
    for (int y = 0; y < camera.size.height; ++y)
        for (int x = 0; x < camera.size.width; ++x) {
            std::vector<FaceView> asked;
            for (const std::uint32_t f : faces_at(faces, {x, y})) asked.push_back(faces[f]);
            const PixelCoverage coverage = visible_areas({x, y}, asked, Nearness::ByDepth);
            std::map<FaceId, double> difference;
            for (const VisiblePart& part : coverage.parts) difference[asked[part.face].id] += part.area;
            const Shown& mine = all[at_pixel(camera, x, y)];
            for (const auto& [id, weight] : mine.weights) difference[id] -= weight;
            double error = std::abs(coverage.background - mine.background);
            for (const auto& [id, d] : difference) error = std::max(error, std::abs(d));
            if (error > bound) {
                INFO("pixel " << x << "," << y << " with " << asked.size() << " faces");
                CHECK(error <= bound);
            }
            worst = std::max(worst, error);
        }
    CHECK(worst <= bound);
}

/// The two answers may each be off by the bound of the areas, in either direction.
constexpr double kTwoBounds = 2 * kVisibleAreaError;
/// Crowded pixels, where the bound for eight faces does not apply (at most 1e-14 in any pixel).
constexpr double kCrowdedBounds = 2e-14;

}  // namespace

TEST_CASE("scan: a rectangle over two by two pixels shows a quarter in each", "[scan]") {
    const Camera view = camera({2, 2});
    Mesh mesh;
    add_rectangle(mesh, view, 0.5, 0.5, 1.5, 1.5, 10);
    const auto all = shown(scanned(geometry(mesh), view), view.size);
    for (const Shown& pixel : all) {
        REQUIRE(pixel.divided);
        REQUIRE(pixel.weights.size() == 1);
        CHECK(std::abs(pixel.weights[0].second - 0.25) <= kVisibleAreaError);
        CHECK(std::abs(pixel.background - 0.75) <= kVisibleAreaError);
    }
}

TEST_CASE("scan: a strip a sixteenth of a pixel thick covers a sixteenth of every pixel", "[scan][wire]") {
    const Camera view = camera({40, 3});
    Mesh mesh;
    add_rectangle(mesh, view, -5, 1.25, 45, 1.3125, 10);
    const auto all = shown(scanned(geometry(mesh), view), view.size);
    for (int x = 0; x < 40; ++x) {
        const Shown& pixel = all[at_pixel(view, x, 1)];
        REQUIRE(pixel.weights.size() == 1);
        CHECK(std::abs(pixel.weights[0].second - 1.0 / 16) <=
              16 * kVisibleAreaError);  // projected corners round
        CHECK_FALSE(all[at_pixel(view, x, 0)].divided);
        CHECK(all[at_pixel(view, x, 0)].background == 1);
    }
}

TEST_CASE("scan: what a face hides is not there, and what shows it wholly is a span", "[scan]") {
    const Camera view = camera({20, 20});
    Mesh mesh;
    add_rectangle(mesh, view, -1, -1, 21, 21, 10);
    add_rectangle(mesh, view, 3.3, 3.3, 9.1, 9.1, 12);
    const auto all = shown(scanned(geometry(mesh), view), view.size);
    for (const Shown& pixel : all) {
        CHECK_FALSE(pixel.divided);
        REQUIRE(pixel.weights.size() == 1);
        CHECK(pixel.weights[0].first == 0);
    }
}

TEST_CASE("scan: two faces through each other divide the pixel along the line where they meet", "[scan]") {
    for (const Camera& view : {camera({3, 3}), orthographic({3, 3})}) {
        Mesh mesh;
        add_rectangle(mesh, view, -1, -1, 4, 4, 10);
        // Nearer than the rectangle left of x = 1.25, farther right of it.
        add_face(mesh, view, {{-2.75, -1, 8}, {1.25, -1, 10}, {1.25, 4, 10}, {-2.75, 4, 8}});
        const auto all = shown(scanned(geometry(mesh), view), view.size);
        const Shown& pixel = all[at_pixel(view, 1, 1)];
        REQUIRE(pixel.weights.size() == 2);
        CHECK(std::abs(pixel.weights[0].second - 0.75) <=
              100 * kVisibleAreaError);  // projected corners round
        CHECK(std::abs(pixel.weights[1].second - 0.25) <= 100 * kVisibleAreaError);
        CHECK(pixel.background == 0);
        check_against_visible_areas(geometry(mesh), view, kTwoBounds);
    }
}

TEST_CASE("scan: a closed sheet's pixels are divided among its faces, without a gap", "[scan][layer]") {
    const Camera view = camera({40, 40});
    for (const int cells : {3, 17, 60}) {
        // Its border lies up to 0.3 of a cell further in than it says, and still outside of the picture.
        const Geometry scene = geometry(sheet(view, -6, -6, 52, cells, 10, 7));
        for (const Shown& pixel : shown(scanned(scene, view), view.size)) {
            double sum = pixel.background;
            for (const auto& [id, weight] : pixel.weights) sum += weight;
            CHECK(pixel.background == 0);
            CHECK(std::abs(sum - 1) <= kAreaSumError);
        }
        check_against_visible_areas(scene, view, kCrowdedBounds);
    }
}

TEST_CASE("scan: sheets behind and through each other, with their borders in the picture", "[scan][layer]") {
    const Camera view = camera({40, 40});
    std::vector<Object> objects;
    objects.push_back({"back", ObjectKind::Terrain, sheet(view, -4, -4, 48, 30, 14, 1)});
    objects.push_back({"front", ObjectKind::Terrain, sheet(view, 5, 8, 23, 20, 10, 2)});
    objects.push_back({"through", ObjectKind::Terrain, sheet(view, 15, 15, 21, 14, 10.05, 3)});
    objects.push_back({"wires", ObjectKind::Conductor, soup(view, 20, 4)});
    check_against_visible_areas(geometry(objects), view, kCrowdedBounds);
}

TEST_CASE("scan: a folded sheet, whose back shows, is divided as visible_areas says", "[scan][layer]") {
    const Camera view = camera({24, 24});
    Mesh mesh = sheet(view, 2, 2, 20, 12, 10, 5);
    // Columns of corners to and fro: folds, silhouettes and back faces.
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double phase = 0.9 * static_cast<double>(i % 13);
        mesh.positions[i].x += 3 * std::sin(phase);
        mesh.positions[i].y += 2 * std::cos(phase);
    }
    check_against_visible_areas(geometry(mesh), view, kCrowdedBounds);
}

TEST_CASE("scan: random faces, large and tiny, are divided as visible_areas says", "[scan]") {
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        const Camera view = seed % 2 == 0 ? camera({33, 21}) : orthographic({33, 21});
        check_against_visible_areas(geometry(soup(view, 60, seed)), view, kCrowdedBounds);
    }
}

TEST_CASE("scan: every engine but the published one divides as the default does (2)", "[scan][engine]") {
    const Camera view = camera({6, 6});
    Mesh mesh;  // three rectangles that overlap, with borders off the pixels'
    add_rectangle(mesh, view, 0.3, 0.4, 3.6, 4.2, 10);
    add_rectangle(mesh, view, 1.7, 2.1, 5.2, 5.9, 12);
    add_rectangle(mesh, view, -1, 3.3, 7, 3.8, 8);
    const Geometry scene = geometry(mesh);
    ScanOptions by_traversal;
    by_traversal.engine = Engine::Traversal;
    const auto expected = shown(scanned(scene, view), view.size);
    const auto found = shown(scanned(scene, view, by_traversal), view.size);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        REQUIRE(found[i].weights.size() == expected[i].weights.size());
        for (std::size_t k = 0; k < expected[i].weights.size(); ++k) {
            CHECK(found[i].weights[k].first == expected[i].weights[k].first);
            CHECK(std::abs(found[i].weights[k].second - expected[i].weights[k].second) <= kTwoBounds);
        }
        CHECK(std::abs(found[i].background - expected[i].background) <= kTwoBounds);
    }
}

TEST_CASE("scan: the bands are the same for 1, 2 and 8 threads (3)", "[scan][threads]") {
    const Camera view = camera({64, 100});
    std::vector<Object> objects;
    objects.push_back({"sheet", ObjectKind::Terrain, sheet(view, -4, -4, 110, 90, 14, 1)});
    objects.push_back({"soup", ObjectKind::Model, soup(view, 100, 4)});
    const Geometry scene = geometry(objects);
    std::vector<std::vector<ScanBand>> bands;
    for (const int threads : {1, 2, 8}) {
        const ThreadLimit limit(threads);
        bands.push_back(scanned(scene, view));
    }
    for (std::size_t run = 1; run < bands.size(); ++run) {
        REQUIRE(bands[run].size() == bands[0].size());
        for (std::size_t b = 0; b < bands[0].size(); ++b) CHECK(bands[run][b] == bands[0][b]);
    }
}

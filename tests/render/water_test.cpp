// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "../support/scratch_folder.hpp"
#include "keikan/image/srgb.hpp"
#include "keikan/render/render_scene.hpp"
#include "keikan/scan/scan_file.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/parallel.hpp"

using namespace keikan;
using nlohmann::json;

namespace {

/// Black water under a sky of one colour, no haze, no sun: water seen straight from above is 0.02037 of the
/// sky.
json black_water(json objects, json camera, ImageSize size) {
    json water = {{"type", "water"},
                  {"outline_m", {{-900, -900}, {900, -900}, {900, 900}, {-900, 900}}},
                  {"level_m", 0},
                  {"material", "white"}};
    water["surface"] = {{"waves", json::array()},
                        {"ripple_variance", 0},
                        {"absorption_per_m", {1e6, 1e6, 1e6}},
                        {"scattering_per_m", {0, 0, 0}}};
    objects.insert(objects.begin(), water);
    return {{"image", {{"width", size.width}, {"height", size.height}}},
            {"camera", camera},
            {"light",
             {{"sun", {{"direction", {0, 0, 1}}, {"colour", {0, 0, 0}}}},
              {"sky_ambient", {1, 1, 1}},
              {"ground_ambient", {1, 1, 1}}}},
            {"background", {{"zenith", {1, 1, 1}}, {"horizon", {1, 1, 1}}}},
            {"materials", {{"white", {{"colour", {1, 1, 1}}}}}},
            {"objects", objects}};
}

constexpr double kFromAbove = 0.02037319;  // ((n - 1) / (n + 1))^2

/// Four pixels of 1 m from straight above, and a roof that covers a quarter of the second and all of the
/// third.
json roof_from_above() {
    const json building = {{"type", "building"},
                           {"name", "roof"},
                           {"footprint_m", {{0.75, -3}, {2, -3}, {2, 3}, {0.75, 3}}},
                           {"floor_m", 0.5},
                           {"height_m", 1},
                           {"roof", "flat"},
                           {"materials", {{"wall", "white"}}}};
    const json camera = {
        {"type", "orthographic"}, {"position", {1, 0, 20}}, {"target", {1, 0, 0}}, {"width_m", 4}};
    return black_water(json::array({building}), camera, {4, 1});
}

struct Loaded {
    Scene scene;
    Geometry geometry;
};

Loaded load(const ScratchFolder& folder, const json& document) {
    write_whole_file(folder / "scene.json", document.dump());
    Scene scene = read_scene(folder / "scene.json");
    Geometry geometry = build_geometry(scene);
    return {std::move(scene), std::move(geometry)};
}

/// A small sea with a tower's wire before it and a house in it.
json small_sea() {
    json document = roof_from_above();
    document["image"] = {{"width", 48}, {"height", 32}};
    document["camera"] = {{"position", {0, -40, 6}}, {"target", {0, 0, 2}}, {"horizontal_fov_deg", 50}};
    document["light"]["sun"] = {{"direction", {0.2, 0.9, 0.5}}, {"colour", {1, 1, 1}}};
    document["objects"][0]["surface"] = {
        {"waves",
         {{{"amplitude_m", 0.1}, {"length_m", 4}, {"towards_deg", 200}},
          {{"amplitude_m", 0.02}, {"length_m", 0.9}, {"towards_deg", 150}}}}};
    document["objects"][1]["footprint_m"] = {{-4, 0}, {4, 0}, {4, 6}, {-4, 6}};
    document["objects"][1]["height_m"] = 5;
    return document;
}

}  // namespace

TEST_CASE("render_scene: a divided pixel mixes water and faces by their areas", "[render][water]") {
    const ScratchFolder folder("render_water");
    const auto [scene, geometry] = load(folder, roof_from_above());
    for (const WaterMode mode : {WaterMode::Variance, WaterMode::Paper, WaterMode::Fixed}) {
        RenderOptions options;
        options.water.mode = mode;
        const RenderedPicture picture = render_scene(scene, geometry, options);
        CHECK(picture.image[PixelIndex{0, 0}].r == Approx(kFromAbove).epsilon(1e-5));
        // The pixel from x = 0 to 1: the roof begins at 0.75. It is lit by the ambient light alone, so it
        // is 1.
        CHECK(picture.image[PixelIndex{1, 0}].r == Approx(0.25 + 0.75 * kFromAbove).epsilon(1e-5));
        CHECK(picture.image[PixelIndex{2, 0}].r == Approx(1).epsilon(1e-6));
        CHECK(picture.water.missed == 0);
        CHECK(picture.water.pixels == 3);
        CHECK(picture.water.mixed_pixels == 1);
    }
}

TEST_CASE("render_scene: --mixed paper takes the whole pixel for water", "[render][water]") {
    const ScratchFolder folder("render_water");
    const auto [scene, geometry] = load(folder, roof_from_above());
    RenderOptions options;
    options.water.mixed = MixedPixels::Paper;
    const RenderedPicture picture = render_scene(scene, geometry, options);
    CHECK(picture.image[PixelIndex{1, 0}].r == Approx(kFromAbove).epsilon(1e-5));
    CHECK(picture.image[PixelIndex{2, 0}].r == Approx(1).epsilon(1e-6));
}

TEST_CASE("render_scene: flat water is the colour of its material", "[render][water]") {
    const ScratchFolder folder("render_water");
    const auto [scene, geometry] = load(folder, roof_from_above());
    RenderOptions options;
    options.water.mode = WaterMode::Flat;
    const RenderedPicture picture = render_scene(scene, geometry, options);
    CHECK(picture.image[PixelIndex{0, 0}].r == Approx(1).epsilon(1e-6));
    CHECK(picture.water.pixels == 0);
}

TEST_CASE("render_scene: a wire over black water is as bright as its coverage, in every column",
          "[render][water][wire]") {
    const ScratchFolder folder("render_water");
    // A beam 0.02 m thick, 5 m above the water, 40 m away: 0.012 of a pixel high, white in ambient light.
    const json beam = {{"type", "building"},
                       {"name", "beam"},
                       {"footprint_m", {{-60, 40}, {60, 46}, {60, 46.02}, {-60, 40.02}}},
                       {"floor_m", 5},
                       {"height_m", 0.02},
                       {"roof", "flat"},
                       {"materials", {{"wall", "white"}}}};
    const json camera = {{"position", {0, 0, 12}}, {"target", {0, 43, 5}}, {"horizontal_fov_deg", 60}};
    json document = black_water(json::array({beam}), camera, {60, 40});
    document["background"] = {{"zenith", {0, 0, 0}}, {"horizon", {0, 0, 0}}};
    const auto [scene, geometry] = load(folder, document);
    std::vector<double> coverage(60, 0), brightness(60, 0);
    const ProjectedFaces faces = project_faces(geometry, scene.camera);
    scan_faces(faces, geometry, scene.camera, {}, [&](const ScanBand& band) {
        for (const DividedPixel& pixel : band.divided)
            for (std::uint32_t i = pixel.part_begin; i < pixel.part_end; ++i)
                if (band.faces[band.parts[i].face].object == 1)
                    coverage[static_cast<std::size_t>(pixel.x)] += band.parts[i].weight;
    });
    RenderOptions options;
    options.water.mode = WaterMode::Fixed;
    options.water.fixed = 4;
    const auto sum_up = [&] {
        const RenderedPicture picture = render_scene(scene, geometry, options);
        std::fill(brightness.begin(), brightness.end(), 0);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 60; ++x)
                brightness[static_cast<std::size_t>(x)] +=
                    static_cast<double>(picture.image[PixelIndex{x, y}].r);
    };
    sum_up();
    int with_reflection = 0;
    for (std::size_t x = 0; x < 60; ++x) {
        REQUIRE(coverage[x] > 0.005);
        // What is brighter is the beam's mirror image: at most what water mirrors of a white face,
        // everywhere.
        CHECK(brightness[x] >= coverage[x] * (1 - 1e-5));
        CHECK(brightness[x] <= coverage[x] + 0.2);
        with_reflection += brightness[x] > coverage[x] * 1.001 ? 1 : 0;
    }
    CHECK(with_reflection < 60);
    // As the paper has it, the pixels are water, and the beam is gone.
    options.water.mixed = MixedPixels::Paper;
    sum_up();
    int gone = 0;
    for (std::size_t x = 0; x < 60; ++x) gone += brightness[x] < 0.5 * coverage[x] ? 1 : 0;
    CHECK(gone > 40);
}

TEST_CASE("render_scene: water has the same bytes for any number of threads", "[render][water][threads]") {
    const ScratchFolder folder("render_water");
    const auto [scene, geometry] = load(folder, small_sea());
    RenderOptions options;
    options.water.least = 4;
    options.water.most = 16;
    const auto picture_of = [&](int threads) {
        const ThreadLimit limit(threads);
        return render_scene(scene, geometry, options);
    };
    const RenderedPicture one = picture_of(1);
    CHECK(one.water.missed == 0);
    CHECK(one.water.mixed_pixels > 10);
    for (const int threads : {2, 7}) {
        const RenderedPicture many = picture_of(threads);
        CHECK(many.image == one.image);
        CHECK(many.water.samples == one.water.samples);
        CHECK(many.water.most_samples == one.water.most_samples);
    }
}

TEST_CASE("shade_scan_file: water from a scan file has the same bits", "[render][water][scan]") {
    const ScratchFolder folder("render_water");
    const auto [scene, geometry] = load(folder, small_sea());
    RenderOptions options;
    options.water.mode = WaterMode::Fixed;
    options.water.fixed = 4;
    const ProjectedFaces faces = project_faces(geometry, scene.camera);
    ScanFileWriter writer(folder / "sea.scan", {scene.camera.size, Extraction::Outline, scene.geometry_hash});
    scan_faces(faces, geometry, scene.camera, {}, [&](const ScanBand& band) { writer.write(band); });
    writer.finish();
    CHECK(shade_scan_file(folder / "sea.scan", scene, options).image ==
          render_scene(scene, geometry, options).image);
}

TEST_CASE("render_scene: more samples for a smaller error, and nearer to the truth", "[render][water]") {
    const ScratchFolder folder("render_water");
    // Without the sun, whose glitter would need more samples than `most`.
    json document = small_sea();
    document["light"]["sun"]["colour"] = {0, 0, 0};
    document["background"]["zenith"] = {0.05, 0.1, 0.4};
    const auto [scene, geometry] = load(folder, document);
    RenderOptions options;
    options.water.least = 4;
    options.water.most = 1024;
    options.water.error = 8;
    const RenderedPicture rough = render_scene(scene, geometry, options);
    options.water.error = 2;
    options.water.seed = 2;
    const RenderedPicture fine = render_scene(scene, geometry, options);
    CHECK(fine.water.samples > 2 * rough.water.samples);
    options.water.mode = WaterMode::Fixed;
    options.water.fixed = 512;
    options.water.seed = 3;
    const RenderedPicture truth = render_scene(scene, geometry, options);
    const auto error_of = [&](const RenderedPicture& picture) {
        double sum = 0;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 48; ++x) {
                const auto squared = [](float p, float q) {
                    const auto code = [](float c) {
                        return 255 * srgb_from_linear(std::min(1.0, double{c}));
                    };
                    return std::pow(code(p) - code(q), 2);
                };
                const Rgb p = picture.image[PixelIndex{x, y}], q = truth.image[PixelIndex{x, y}];
                sum += (squared(p.r, q.r) + squared(p.g, q.g) + squared(p.b, q.b)) / 3;
            }
        return std::sqrt(sum / (48 * 32));
    };
    // What was asked for is a standard error, not a bound; the truth's own is in the difference as well.
    CHECK(error_of(fine) < 1.2 * 2);
    CHECK(error_of(rough) < 1.2 * 8);
    CHECK(error_of(fine) < error_of(rough));
}

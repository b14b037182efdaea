// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <filesystem>

#include "../support/scratch_folder.hpp"
#include "keikan/baseline/method.hpp"
#include "keikan/image/png_file.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"

using namespace keikan;
using namespace keikan::baseline;

namespace {

Scene small_hill() {
    return read_scene(std::filesystem::path(KEIKAN_SOURCE_DIR) / "data/scenes/hill.json", ImageSize{96, 62});
}

/// Four pixels of 1 m from straight above: black water under a white sky, which mirrors kFromAbove of it, and
/// a white roof over the last quarter of the second pixel and all of the third.
constexpr const char* kRoofOverWater = R"({
  "image": {"width": 4, "height": 1},
  "camera": {"type": "orthographic", "position": [1, 0, 20], "target": [1, 0, 0], "width_m": 4},
  "light": {"sun": {"direction": [0, 0, 1], "colour": [0, 0, 0]}, "sky_ambient": [1, 1, 1], "ground_ambient": [1, 1, 1]},
  "background": {"zenith": [1, 1, 1], "horizon": [1, 1, 1]},
  "materials": {"white": {"colour": [1, 1, 1]}},
  "objects": [
    {"type": "water", "outline_m": [[-900, -900], [900, -900], [900, 900], [-900, 900]], "level_m": 0,
     "material": "white", "surface": {"waves": [], "ripple_variance": 0, "absorption_per_m": [1e6, 1e6, 1e6],
                                      "scattering_per_m": [0, 0, 0]}},
    {"type": "building", "footprint_m": [[0.75, -3], [2, -3], [2, 3], [0.75, 3]], "floor_m": 0.5, "height_m": 1,
     "roof": "flat", "materials": {"wall": "white"}}
  ]
})";
constexpr double kFromAbove = 0.02037319;  // ((n - 1) / (n + 1))^2

}  // namespace

TEST_CASE("method_of: names go there and back, and what is no method is refused", "[baseline]") {
    for (const std::string name : {"kato", "kato:outline", "kato:paper", "none", "multiscan:11",
                                   "orthogonal:1", "catmull", "grid:16", "random:1048576"})
        CHECK(name_of(method_of(name)) == name);
    for (const std::string name :
         {"", "magic", "multiscan", "multiscan:", "multiscan:0", "grid:-4", "grid:1.5", "random:1048577",
          "kato:4", "none:1", "catmull:", "multiscan:4:4"})
        CHECK_THROWS_AS(method_of(name), InputError);
}

TEST_CASE("render_by: catmull's picture is kato's under outline extraction, byte for byte; paper's is not",
          "[baseline][catmull]") {
    const ScratchFolder folder("baseline");
    const Scene scene = small_hill();
    const Geometry geometry = build_geometry(scene);
    const auto bytes = [&](const std::string& method) {
        write_png(folder / "a.png", render_by(method_of(method), scene, geometry).image);
        return read_png(folder / "a.png");
    };
    CHECK(bytes("catmull") == bytes("kato:outline"));
    CHECK(bytes("catmull") != bytes("kato:paper"));
}

TEST_CASE("render_by: where nothing is in view, every method shows the background", "[baseline]") {
    Scene scene = small_hill();
    const Geometry geometry = build_geometry(scene);
    scene.camera.look_along({0, 0, 1});
    Image<Rgb> sky;
    for (const std::string name :
         {"kato", "none", "multiscan:2", "orthogonal:2", "catmull", "grid:4", "random:4"}) {
        const Image<Rgb> image = render_by(method_of(name), scene, geometry).image;
        if (sky.width() == 0) sky = image;
        INFO(name);
        CHECK(image == sky);
    }
}

TEST_CASE("render_by (1): the number of threads changes nothing", "[baseline][threads]") {
    const Scene scene = small_hill();
    const Geometry geometry = build_geometry(scene);
    for (const std::string method :
         {"none", "multiscan:3", "orthogonal:2", "catmull", "grid:4", "random:4"}) {
        Image<Rgb> first;
        for (const int threads : {1, 3}) {
            const ThreadLimit limit(threads);
            const Image<Rgb> image = render_by(method_of(method), scene, geometry).image;
            if (threads == 1) first = image;
            INFO(method);
            CHECK(image == first);
        }
    }
}

TEST_CASE("render_by: every method mixes water and faces by its own weights, with its own samples",
          "[baseline][water]") {
    const ScratchFolder folder("baseline");
    write_whole_file(folder / "scene.json", kRoofOverWater);
    const Scene scene = read_scene(folder / "scene.json");
    const Geometry geometry = build_geometry(scene);
    const auto check = [&](const std::string& method, double roof, std::uint64_t samples) {
        INFO(method);
        const RenderedPicture picture = render_by(method_of(method), scene, geometry);
        CHECK(picture.image[PixelIndex{0, 0}].r == Approx(kFromAbove).epsilon(1e-5));
        CHECK(picture.image[PixelIndex{1, 0}].r == Approx(roof + (1 - roof) * kFromAbove).epsilon(1e-5));
        CHECK(picture.image[PixelIndex{2, 0}].r == Approx(1).epsilon(1e-6));
        CHECK(picture.water.missed == 0);
        CHECK(picture.water.samples == samples);  // in the first, second and fourth pixel
    };
    check("none", 0, 3);
    check("multiscan:1", 0.25, 3);
    check("multiscan:5", 0.25, 15);
    check("catmull", 0.25, 3);
    check("grid:16", 0.25, 44);
    check("random:16", 0.25, 44);
    check("orthogonal:4", 0.25, 15);  // five level lines; the outermost count half
}

TEST_CASE("render_by: water with waves tends to what kato's samples tend to", "[baseline][water]") {
    const ScratchFolder folder("baseline");
    std::string text = kRoofOverWater;
    const auto put = [&](const std::string& what, const std::string& by) {
        text.replace(text.find(what), what.size(), by);
    };
    put("\"zenith\": [1, 1, 1]", "\"zenith\": [0, 0, 0]");
    put("\"waves\": [], \"ripple_variance\": 0",
        R"("waves": [{"amplitude_m": 0.15, "length_m": 3, "towards_deg": 70}])");
    put(R"("type": "orthographic", "position": [1, 0, 20], "target": [1, 0, 0], "width_m": 4)",
        R"("position": [0, -9, 3], "target": [0, 0, 0], "horizontal_fov_deg": 60)");
    write_whole_file(folder / "scene.json", text);
    const Scene scene = read_scene(folder / "scene.json", ImageSize{8, 5});
    const Geometry geometry = build_geometry(scene);
    MethodOptions options;
    options.render.water.mode = WaterMode::Fixed;
    options.render.water.fixed = 1024;
    const Image<Rgb> truth = render_by(method_of("kato"), scene, geometry, options).image;
    for (const std::string method : {"multiscan:64", "orthogonal:64", "grid:256", "random:256"}) {
        const RenderedPicture picture = render_by(method_of(method), scene, geometry, options);
        double worst = 0;
        for (std::size_t i = 0; i < truth.values().size(); ++i)
            worst = std::max(worst, std::abs(static_cast<double>(picture.image.values()[i].r) -
                                             static_cast<double>(truth.values()[i].r)));
        INFO(method);
        CHECK(worst < 0.05);  // of a sky from 0 to 1; random slopes: five times 0.08 / sqrt(64)
        CHECK(picture.water.missed == 0);
    }
}

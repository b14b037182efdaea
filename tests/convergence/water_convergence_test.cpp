// SPDX-License-Identifier: GPL-3.0-or-later
#include "convergence/water_convergence.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "../support/scratch_folder.hpp"

using namespace keikan;
using convergence::WaterCheckOptions;
using convergence::WaterDrawing;
using convergence::WaterReport;

namespace {

/// A sea with two waves under a gradient sky, so small that it is drawn in a moment; no sun.
constexpr const char* kSea = R"({
  "image": {"width": 32, "height": 24},
  "camera": {"position": [0, -40, 6], "target": [0, 0, 0], "horizontal_fov_deg": 40},
  "light": {"sun": {"direction": [0, 0, 1], "colour": [0, 0, 0]}},
  "background": {"zenith": [0.02, 0.06, 0.3], "horizon": [1, 0.9, 0.8]},
  "materials": {"water": {"colour": [0, 0, 0]}},
  "objects": [{
    "type": "water", "outline_m": [[-900, -900], [900, -900], [900, 900], [-900, 900]], "level_m": 0,
    "material": "water",
    "surface": {
      "waves": [{"amplitude_m": 0.1, "length_m": 4, "towards_deg": 200},
                {"amplitude_m": 0.02, "length_m": 0.9, "towards_deg": 150}],
      "ripple_variance": 0.01
    }
  }]
})";

struct Sea {
    explicit Sea(const ScratchFolder& folder) : scene(read_scene(folder.write("sea.json", kSea))) {}
    Scene scene;
    Geometry geometry = build_geometry(scene);
    WaterCheckOptions options{.window = {4, 7, 24, 16},
                              .reference_samples = 512,
                              .error = 2,
                              .k_w = {800},
                              .k_r = {3},
                              .paper_most = 16};

    /// render_scene as check_water calls it.
    RenderedPicture draw(const WaterOptions& water) const {
        RenderOptions render;
        render.water = water;
        render.extra = true;
        return render_scene(scene, geometry, render);
    }
};

constexpr PixelIndex kAt{1, 0};

/// Three pixels of water and one without, all black.
RenderedPicture four_pixels() {
    RenderedPicture picture = empty_picture({2, 2}, true);
    for (const PixelIndex at : {PixelIndex{0, 0}, kAt, PixelIndex{0, 1}}) picture.extra.water_samples[at] = 5;
    picture.water.pixels = 3;
    picture.water.samples = 15;
    return picture;
}

/// The report on four_pixels(), the adaptive method's changed by `change`.
template <typename Change>
WaterReport report_on(const Change& change, PixelWindow window = {0, 0, 2, 2}) {
    WaterCheckOptions options{.window = window, .k_w = {800}, .k_r = {3}};
    return convergence::check_water(
        [&](const WaterOptions& water) {
            RenderedPicture picture = four_pixels();
            if (water.mode == WaterMode::Variance) change(picture);
            return picture;
        },
        options);
}

}  // namespace

TEST_CASE("check_water: root of the mean square, and the largest error, of a picture worked out by hand",
          "[convergence]") {
    // 255 codes in one of the nine values of three pixels, 255 x 12.92 x 0.001 = 3.2946 in another.
    const auto two_values = [](RenderedPicture& picture) {
        picture.image[kAt] = {1, 0.001f, 0};
        picture.image[PixelIndex{1, 1}] = {1, 1, 1};  // no water: not compared
    };
    const WaterReport report = report_on(two_values);
    CHECK(report.pixels == 3);
    CHECK(report.adaptive.rmse == Approx(std::sqrt((255.0 * 255 + 3.2946 * 3.2946) / 9)));
    CHECK(report.adaptive.largest_error == Approx(255));
    CHECK(report.adaptive.samples_per_pixel == 5 + 1);  // one is what measuring beforehand takes
    CHECK(report.random.rmse == 0);
    CHECK(report.random.samples_per_pixel == 5);
    // The same in the column of that pixel alone: one pixel, three values.
    CHECK(report_on(two_values, {1, 0, 1, 2}).adaptive.rmse ==
          Approx(std::sqrt((255.0 * 255 + 3.2946 * 3.2946) / 3)));
    // Beyond white there is nothing to err by.
    CHECK(report_on([](RenderedPicture& picture) { picture.image[kAt].g = 7; }).adaptive.largest_error ==
          Approx(255));
}

TEST_CASE("check_water: a sea that is drawn as asked passes", "[convergence]") {
    const ScratchFolder folder("convergence");
    const Sea sea(folder);
    const WaterReport report = convergence::check_water(sea.scene, sea.geometry, sea.options);
    INFO(convergence::report_table(report));
    CHECK(report.pass());
    CHECK(report.pixels == 24 * 16);
    CHECK(report.missed() == 0);
    CHECK(report.paper.size() == 1);
    CHECK_THAT(convergence::report_json(report, 0), Catch::Contains("\"verdict\":\"pass\""));
}

TEST_CASE("check_water: a single missed sample, of any method or reference, fails", "[convergence]") {
    const ScratchFolder folder("convergence");
    const Sea sea(folder);
    // In each of the calls in turn: two references, variance, random, sobol, paper.
    WaterCheckOptions options = sea.options;
    options.window = {4, 4, 2, 2};
    options.reference_samples = 8;
    for (int fault = 0; fault < 6; ++fault) {
        int call = 0;
        const WaterReport report = convergence::check_water(
            [&](const WaterOptions& water) {
                RenderedPicture picture = sea.draw(water);
                if (call++ == fault) picture.water.missed = 1;
                return picture;
            },
            options);
        CHECK(call == 6);
        CHECK(report.missed() == 1);
        CHECK_FALSE(report.pass());
    }
}

TEST_CASE("check_water: a colour that is no number fails, whichever picture holds it", "[convergence]") {
    for (int fault = 0; fault < 6; ++fault) {
        int call = 0;
        const WaterReport report = convergence::check_water(
            [&](const WaterOptions&) {
                RenderedPicture picture = four_pixels();
                if (call++ == fault) picture.image[kAt].b = std::numeric_limits<float>::quiet_NaN();
                return picture;
            },
            {.window = {0, 0, 2, 2}, .k_w = {800}, .k_r = {3}});
        CHECK_FALSE(report.finite());
        CHECK_FALSE(report.pass());
    }
}

TEST_CASE("check_water: too few samples, and too many, miss the error that was asked for", "[convergence]") {
    const ScratchFolder folder("convergence");
    const Sea sea(folder);
    for (const double factor : {0.4, 2.5}) {
        const WaterReport report = convergence::check_water(
            [&](WaterOptions water) {
                if (water.mode == WaterMode::Variance) water.error *= factor;
                return sea.draw(water);
            },
            sea.options);
        INFO(convergence::report_table(report));
        CHECK_FALSE(report.error_as_asked());
        CHECK(report.beats_random());
        CHECK_FALSE(report.pass());
        CHECK_THAT(convergence::report_json(report, 0), Catch::Contains("\"error_as_asked\":false"));
    }
}

TEST_CASE("check_water: an estimator no better than random points fails", "[convergence]") {
    const ScratchFolder folder("convergence");
    Sea sea(folder);
    const WaterDrawing random = [&](WaterOptions water) {
        if (water.mode == WaterMode::Variance) {
            water.mode = WaterMode::Fixed;
            water.fixed_sampler = Sampler::Random;
            water.fixed = 24;
            water.seed += 1;
        }
        return sea.draw(water);
    };
    // Asked for what it errs by, so that this alone is wrong with it.
    sea.options.error = convergence::check_water(random, sea.options).adaptive.rmse;
    const WaterReport report = convergence::check_water(random, sea.options);
    INFO(convergence::report_table(report));
    CHECK(report.error_as_asked());
    CHECK_FALSE(report.beats_random());
    CHECK_FALSE(report.pass());
}

TEST_CASE("check_water: a picture without water is no pass", "[convergence]") {
    const WaterReport report = convergence::check_water(
        [](const WaterOptions&) {
            return empty_picture({2, 2}, true);
        },
        {.window = {0, 0, 2, 2}});
    CHECK(report.pixels == 0);
    CHECK_FALSE(report.pass());
}

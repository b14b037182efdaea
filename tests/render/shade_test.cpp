// SPDX-License-Identifier: Apache-2.0
#include "keikan/render/shade.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "keikan/support/check.hpp"

using namespace keikan;

namespace {

/// Some ten roundings of floats no larger than 1, each of half of 2^-24 at most, and `exp` or `pow` once.
constexpr double kFloatError = 1e-6;

/// An eye at the origin that looks along +y; pixel (4, 4) looks straight ahead, and three pixels further up
/// the ray rises by 3/4.
Scene example_scene() {
    Scene scene;
    scene.camera.focal_px = 4;
    scene.camera.centre_x = scene.camera.centre_y = 4.5;
    scene.camera.size = {8, 8};
    scene.light.to_sun = {0, -0.6, 0.8};
    scene.light.sun = {1, 0.9f, 0.8f};
    scene.light.sky_ambient = {0.4f, 0.4f, 0.4f};
    scene.light.ground_ambient = {0.2f, 0.2f, 0.2f};
    scene.background.zenith = {0, 0, 1};
    scene.background.horizon = {1, 1, 1};
    Material paint;
    paint.name = "paint";
    paint.colour = {0.5f, 0.25f, 0.125f};
    scene.materials = {paint};
    return scene;
}

/// A wall ten metres ahead that faces the eye.
SeenFace wall() {
    SeenFace face;
    face.plane = {0, 0, 0.1};
    face.normal[0] = {0, -2, 0};  // any length
    face.flat_normal = {0, -1, 0};
    return face;
}

constexpr PixelIndex kAhead{4, 4};

/// A band of the one row y, on which `face` is seen in the span [x, x + 1).
ScanBand band_of(const SeenFace& face, PixelIndex pixel) {
    ScanBand band;
    band.first_row = pixel.y;
    band.rows = 1;
    band.faces = {face};
    band.spans = {{pixel.x, pixel.x + 1, 0}};
    band.span_begin = {0, 1};
    band.divided_begin = {0, 0};
    return band;
}

Rgb colour_of(const ScanBand& band, const Scene& scene, PixelIndex pixel) {
    Image<Rgb> image(scene.camera.size);
    shade_band(band, scene, image);
    return image[pixel];
}

void check_colour(Rgb colour, double r, double g, double b) {
    CHECK(colour.r == Approx(r).margin(kFloatError).epsilon(0));
    CHECK(colour.g == Approx(g).margin(kFloatError).epsilon(0));
    CHECK(colour.b == Approx(b).margin(kFloatError).epsilon(0));
}

}  // namespace

TEST_CASE("shade_band: a matt wall shows ambient light and the sun by its cosine", "[render][phong]") {
    // n = (0, -1, 0): half sky and half ground, 0.3; n.l = 0.6.
    const Rgb colour = colour_of(band_of(wall(), kAhead), example_scene(), kAhead);
    check_colour(colour, 0.5 * (0.3 + 0.6), 0.25 * (0.3 + 0.6 * 0.9), 0.125 * (0.3 + 0.6 * 0.8));
}

TEST_CASE("shade_band: ambient light is the sky's from above and the ground's from below",
          "[render][phong]") {
    Scene scene = example_scene();
    scene.light.sun = {0, 0, 0};
    SeenFace face = wall();
    face.normal[0] = {0, 0, 1};
    check_colour(colour_of(band_of(face, kAhead), scene, kAhead), 0.2, 0.1, 0.05);
    face.normal[0] = {0, 0, -3};
    check_colour(colour_of(band_of(face, kAhead), scene, kAhead), 0.1, 0.05, 0.025);
}

TEST_CASE("shade_band: a face turned away from the sun has no share of it", "[render][phong]") {
    Scene scene = example_scene();
    scene.light.to_sun = {0, 1, 0};
    scene.materials[0].specular = 1;
    check_colour(colour_of(band_of(wall(), kAhead), scene, kAhead), 0.15, 0.075, 0.0375);
}

TEST_CASE("shade_band: the highlight is the mirrored sun's cosine to the eye, to the exponent",
          "[render][phong]") {
    // r = 2 (n.l) n - l = (0, -0.6, -0.8) and v = (0, -1, 0): r.v = 0.6.
    Scene scene = example_scene();
    scene.materials[0].diffuse = 0;
    scene.materials[0].specular = 0.5f;
    scene.materials[0].exponent = 2;
    const double highlight = 0.5 * 0.36;
    check_colour(colour_of(band_of(wall(), kAhead), scene, kAhead), 0.15 + highlight, 0.075 + 0.9 * highlight,
                 0.0375 + 0.8 * highlight);
}

TEST_CASE("shade_band: the normal changes over the image as the face says", "[render][phong]") {
    // Half a pixel right of normal_at the x component is 3/4 of y's size: the unit normal is (0.6, -0.8, 0).
    Scene scene = example_scene();
    scene.light.to_sun = {1, 0, 0};
    SeenFace face = wall();
    face.normal[0] = {0, -1, 0};
    face.normal[1] = {1.5f, 0, 0};
    face.normal_at = {4, 4.5};
    check_colour(colour_of(band_of(face, kAhead), scene, kAhead), 0.5 * (0.3 + 0.6), 0.25 * (0.3 + 0.6 * 0.9),
                 0.125 * (0.3 + 0.6 * 0.8));
}

TEST_CASE("shade_band: vertex normals that cancel out leave the plane's own", "[render][phong][degenerate]") {
    SeenFace face = wall();
    face.normal[0] = {0, 0, 0};
    const Rgb plain = colour_of(band_of(wall(), kAhead), example_scene(), kAhead);
    CHECK(colour_of(band_of(face, kAhead), example_scene(), kAhead) == plain);
}

TEST_CASE("shade_band: haze covers half of what is seen at range times ln 2", "[render][haze]") {
    Scene scene = example_scene();
    scene.haze.colour = {1, 1, 1};
    scene.haze.range_m = 10 / std::numbers::ln2;
    check_colour(colour_of(band_of(wall(), kAhead), scene, kAhead), (0.45 + 1) / 2, (0.21 + 1) / 2,
                 (0.0975 + 1) / 2);
    // Three pixels up, the way to the wall is 5/4 as long.
    const PixelIndex up{4, 1};
    scene.haze.range_m = 12.5 / std::numbers::ln2;
    check_colour(colour_of(band_of(wall(), up), scene, up), (0.45 + 1) / 2, (0.21 + 1) / 2, (0.0975 + 1) / 2);
}

TEST_CASE("shade_band: a face seen edge-on is far away, and its colour still a number",
          "[render][degenerate]") {
    Scene scene = example_scene();
    scene.haze.colour = {0.25f, 0.5f, 0.75f};
    scene.haze.range_m = 1000;
    SeenFace face = wall();
    for (const double w : {0.0, -1e-30, -0.5}) {
        face.plane = {0, 0, w};
        check_colour(colour_of(band_of(face, kAhead), scene, kAhead), 0.25, 0.5, 0.75);
    }
}

TEST_CASE("shade_band: a ramp colours by the height of the point and the slope of the normal there",
          "[render][ramp]") {
    Scene scene = example_scene();
    scene.light.sun = {0, 0, 0};
    scene.light.sky_ambient = scene.light.ground_ambient = {1, 1, 1};  // so that the colour is the albedo
    HeightSlopeRamp ramp;
    ramp.stops = {{5, {0, 0, 0}}, {9, {0, 1, 0}}, {20, {1, 1, 1}}};
    ramp.steep = {1, 0, 1};
    ramp.steep_from_deg = 35;
    ramp.steep_full_deg = 50;
    scene.materials[0].ramp = ramp;
    SeenFace face = wall();
    face.normal[0] = {0, 0, 1};
    const PixelIndex up{4, 1};  // 10 m ahead it is 7.5 m high
    check_colour(colour_of(band_of(face, up), scene, up), 0, 0.625, 0);
    check_colour(colour_of(band_of(face, kAhead), scene, kAhead), 0, 0, 0);
    const auto tilted = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        face.normal[0] = {0, static_cast<float>(-std::sin(angle)), static_cast<float>(std::cos(angle))};
        return colour_of(band_of(face, up), scene, up);
    };
    check_colour(tilted(34), 0, 0.625, 0);
    check_colour(tilted(42.5), 0.5, 0.3125, 0.5);
    check_colour(tilted(51), 1, 0, 1);

    // A normal that bends over the face: level where it is anchored, at 45 degrees a pixel further right.
    face.normal = {{{0, 0, 1}, {0, -1, 0}, {0, 0, 0}}};
    face.normal_at = {up.x - 0.5, up.y + 0.5};
    const double steep = 10.0 / 15;  // of the way from 35 to 50 degrees
    check_colour(colour_of(band_of(face, up), scene, up), steep, (1 - steep) * 0.625, steep);
}

TEST_CASE("shade_band: a ramp sees the same height under an orthographic camera", "[render][ramp]") {
    Scene scene = example_scene();
    scene.camera.kind = Camera::Kind::Orthographic;
    scene.light.sun = {0, 0, 0};
    scene.light.sky_ambient = scene.light.ground_ambient = {1, 1, 1};
    HeightSlopeRamp ramp;
    ramp.stops = {{0, {0, 0, 0}}, {1, {1, 1, 1}}};
    scene.materials[0].ramp = ramp;
    SeenFace face = wall();
    face.plane = {0, 0, -10};
    face.normal[0] = {0, 0, 1};
    const PixelIndex up{4, 1};  // 4 pixels are a metre
    check_colour(colour_of(band_of(face, up), scene, up), 0.75, 0.75, 0.75);
}

TEST_CASE("shade_band: the background goes from horizon to zenith by the sine of the elevation", "[render]") {
    const Scene scene = example_scene();
    ScanBand band = band_of(wall(), {4, 1});
    band.spans[0].face = Span::kBackground;
    check_colour(colour_of(band, scene, {4, 1}), 0.4, 0.4, 1);  // sine 3/5
    band.first_row = 7;
    check_colour(colour_of(band, scene, {4, 7}), 1, 1, 1);
}

TEST_CASE("shade_band: a divided pixel is the mean of its parts, in linear light", "[render][divided]") {
    Scene scene = example_scene();
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].colour = {0, 0, 1};
    ScanBand band = band_of(wall(), kAhead);
    SeenFace blue = wall();
    blue.material = 1;
    blue.object = 7;
    blue.plane = {0, 0, 0.05};
    band.faces.push_back(blue);
    band.spans.clear();
    band.span_begin = {0, 0};
    band.divided = {{4, Division::ExactAreas, 0, 2, 0.25}};
    band.divided_begin = {0, 1};
    band.parts = {{0, 0.5f, 0.5f, 0.25}, {1, 0.5f, 0.5f, 0.5}};
    Image<Rgb> image(scene.camera.size);
    ExtraImages extra{
        Image<float>({8, 8}), Image<float>({8, 8}), Image<float>({8, 8}), Image<float>({8, 8}), {}};
    shade_band(band, scene, image, &extra);
    // Background straight ahead: the horizon, white.
    check_colour(image[kAhead], 0.25 + 0.25 * 0.45, 0.25 + 0.25 * 0.21,
                 0.25 + 0.25 * 0.0975 + 0.5 * (0.3 + 0.6 * 0.8));
    CHECK(extra.background[kAhead] == 0.25f);
    CHECK(extra.object_id[kAhead] == 8);
    CHECK(extra.depth[kAhead] == 20);
    CHECK(extra.flags[kAhead] == 1);

    band.divided[0].background = 0.75;
    band.divided[0].division = Division::Scanline;
    band.parts = {{0, 0.5f, 0.5f, 0.125}, {1, 0.5f, 0.5f, 0.125}};
    shade_band(band, scene, image, &extra);
    CHECK(extra.background[kAhead] == 0.75f);
    CHECK(extra.object_id[kAhead] == 0);
    CHECK(extra.depth[kAhead] == 0);
    CHECK(extra.flags[kAhead] == 2);
}

TEST_CASE("shade_band: each part is shaded at its own centroid", "[render][divided]") {
    // The ramp shows the height that was looked at: a quarter and three quarters of a pixel down the wall.
    Scene scene = example_scene();
    scene.light.sun = {0, 0, 0};
    scene.light.sky_ambient = scene.light.ground_ambient = {1, 1, 1};
    HeightSlopeRamp ramp;
    ramp.stops = {{0, {0, 0, 0}}, {10, {1, 1, 1}}};
    scene.materials[0].ramp = ramp;
    SeenFace face = wall();
    face.normal[0] = {0, 0, 1};
    const PixelIndex up{4, 1};
    ScanBand band = band_of(face, up);
    band.spans.clear();
    band.span_begin = {0, 0};
    band.divided = {{4, Division::ExactAreas, 0, 2, 0}};
    band.divided_begin = {0, 1};
    band.parts = {{0, 0.5f, 0.25f, 0.75}, {0, 0.5f, 0.75f, 0.25}};
    const double mean_height = 0.75 * (10 * 3.25 / 4) + 0.25 * (10 * 2.75 / 4);
    check_colour(colour_of(band, scene, up), mean_height / 10, mean_height / 10, mean_height / 10);
}

TEST_CASE("shade_band: extra images that are empty are not made", "[render]") {
    ExtraImages extra;
    extra.depth = Image<float>({8, 8});
    Image<Rgb> image({8, 8});
    shade_band(band_of(wall(), kAhead), example_scene(), image, &extra);
    CHECK(extra.depth[kAhead] == 10);
    CHECK(extra.flags.width() == 0);
}

TEST_CASE("shade_band: a material that the scene does not have is our mistake", "[render]") {
    SeenFace face = wall();
    face.material = 1;
    Image<Rgb> image({8, 8});
    CHECK_THROWS_AS(shade_band(band_of(face, kAhead), example_scene(), image), CheckFailure);
}

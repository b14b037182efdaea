// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "../scan/small_scenes.hpp"
#include "keikan/baseline/catmull.hpp"
#include "keikan/baseline/multi_scanning.hpp"
#include "keikan/baseline/orthogonal_scanlines.hpp"
#include "keikan/baseline/supersampling.hpp"
#include "keikan/clip/visible_areas.hpp"

using namespace keikan;
using namespace keikan::baseline;

namespace {

using Factory = std::function<std::function<BandMaker()>(const FacesInView&)>;

struct Made {
    std::vector<ScanBand> bands;
    std::vector<WaterPoint> water;
};

Made made_by(const Factory& method, const Geometry& geometry, const Camera& camera) {
    const ProjectedFaces faces = project_faces(geometry, camera);
    const FacesInView view(geometry, faces, camera);
    const BandMaker make = method(view)();
    Made made;
    for (int row = 0; row < camera.size.height; row += kBandRows)
        make({row, std::min(kBandRows, camera.size.height - row)}, made.bands.emplace_back(), made.water);
    return made;
}

/// What the method shows in every pixel, row by row.
std::vector<small_scenes::Shown> shown_by(const Factory& method, const Geometry& geometry,
                                          const Camera& camera) {
    const Made made = made_by(method, geometry, camera);
    CHECK(made.water.empty());
    return small_scenes::shown(made.bands, camera.size);
}

Factory multiscan(int n) {
    return [n](const FacesInView& view) { return multi_scanning(view, n); };
}
Factory orthogonal(int n) {
    return [n](const FacesInView& view) { return orthogonal_scanlines(view, n); };
}
Factory grid(int n) {
    return [n](const FacesInView& view) { return supersampling(view, {SamplePattern::Grid, n, 1, {}}); };
}
Factory random_samples(int n) {
    return [n](const FacesInView& view) { return supersampling(view, {SamplePattern::Random, n, 1, {}}); };
}
const Factory kNone = [](const FacesInView& view) { return point_sampling(view); };
const Factory kCatmull = [](const FacesInView& view) { return exact_everywhere(view); };

double weight_of(const small_scenes::Shown& pixel, FaceId face) {
    for (const auto& [id, weight] : pixel.weights)
        if (id == face) return weight;
    return 0;
}

/// A rectangle of the image before an orthographic camera: image coordinates are metres, exactly.
Geometry one_rectangle(const Camera& camera, double left, double top, double right, double bottom) {
    Mesh mesh;
    small_scenes::add_rectangle(mesh, camera, left, top, right, bottom, 8);
    return small_scenes::geometry(mesh);
}

/// Two rectangles that meet along the level line y = `height`.
Geometry level_border(const Camera& camera, double height) {
    Mesh mesh;
    small_scenes::add_rectangle(mesh, camera, 0, 0, 4, height, 8);
    small_scenes::add_rectangle(mesh, camera, 0, height, 4, 4, 8);
    return small_scenes::geometry(mesh);
}

/// Where the only part of the picture's first divided pixel is shaded.
Point shaded_at(const Factory& method, const Geometry& geometry, const Camera& camera) {
    const Made made = made_by(method, geometry, camera);
    REQUIRE(made.bands[0].divided.size() >= 1);
    const DividedPixel& first = made.bands[0].divided[0];
    REQUIRE(first.part_end == first.part_begin + 1);
    const SeenPart& part = made.bands[0].parts[first.part_begin];
    return {part.x, part.y};
}

/// The places in the picture's first pixel that are looked at as water, row by row.
std::vector<WaterPoint> water_in_first_pixel(const Factory& method, const Camera& camera, double right,
                                             double bottom) {
    Mesh lake;
    small_scenes::add_rectangle(lake, camera, 0, 0, right, bottom, 8);
    std::vector<WaterPoint> water =
        made_by(method, small_scenes::geometry(lake, ObjectKind::Water), camera).water;
    std::erase_if(water, [](const WaterPoint& point) { return point.x != 0 || point.y != 0; });
    std::sort(water.begin(), water.end(), [](const WaterPoint& a, const WaterPoint& b) {
        return std::pair(a.at.y, a.at.x) < std::pair(b.at.y, b.at.x);
    });
    return water;
}

/// Root of the mean square of all faces' errors in all pixels, against exact areas.
double error_of(const Factory& method, const Geometry& geometry, const Camera& camera) {
    const auto truth = shown_by(kCatmull, geometry, camera), shown = shown_by(method, geometry, camera);
    double sum = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        for (const auto& [face, weight] : truth[i].weights)
            sum += std::pow(weight - weight_of(shown[i], face), 2);
        for (const auto& [face, weight] : shown[i].weights)
            if (weight_of(truth[i], face) == 0) sum += weight * weight;
    }
    return std::sqrt(sum / static_cast<double>(truth.size()));
}

}  // namespace

TEST_CASE("point_sampling: the face at the pixel's centre, an edge belongs to what is right of it or below",
          "[baseline][none]") {
    const Camera camera = small_scenes::orthographic();
    const auto pixels = shown_by(kNone, one_rectangle(camera, 0.5, 0.5, 2.5, 2.5), camera);
    const auto shows = [&](int x, int y) {
        const auto& pixel = pixels[static_cast<std::size_t>(4 * y + x)];
        CHECK_FALSE(pixel.divided);
        return weight_of(pixel, 0) == 1;
    };
    CHECK(shows(0, 0));
    CHECK(shows(1, 1));
    CHECK_FALSE(shows(2, 1));
    CHECK_FALSE(shows(1, 2));
    CHECK_FALSE(shows(3, 3));
}

TEST_CASE("multi_scanning (1): vertical edges are exact with one line", "[baseline][multiscan]") {
    const Camera camera = small_scenes::orthographic();
    for (const int n : {1, 3, 8}) {
        const auto pixels = shown_by(multiscan(n), one_rectangle(camera, 0.25, 0, 1.625, 4), camera);
        CHECK(weight_of(pixels[0], 0) == Approx(0.75).epsilon(1e-15));
        CHECK(weight_of(pixels[1], 0) == Approx(0.625).epsilon(1e-15));
        CHECK(pixels[1].background == Approx(0.375).epsilon(1e-15));
        CHECK(weight_of(pixels[2], 0) == 0);
    }
}

TEST_CASE("multi_scanning (2): a level edge counts the lines above it, and a thin strip is missed",
          "[baseline][multiscan]") {
    const Camera camera = small_scenes::orthographic();
    const auto share = [&](int n, double top, double bottom) {
        return weight_of(shown_by(multiscan(n), one_rectangle(camera, 0, top, 4, bottom), camera)[1], 0);
    };
    CHECK(share(1, 0, 0.3) == 0);
    CHECK(share(4, 0, 0.3) == 1.0 / 4);  // lines at 1/8, 3/8, 5/8, 7/8
    CHECK(share(10, 0, 0.32) == Approx(3.0 / 10).epsilon(1e-15));
    CHECK(share(4, 0.3125, 0.34375) == 0);
    CHECK(share(16, 0.3125, 0.359375) == 1.0 / 16);  // a third more than there is
}

TEST_CASE("multi_scanning: in general position the error falls as one over the square of the lines",
          "[baseline][multiscan]") {
    const Camera camera = small_scenes::camera({12, 12});
    const Geometry geometry =
        small_scenes::geometry(small_scenes::sheet(camera, 1.1, 0.7, 9, 5, 10, 3), ObjectKind::Terrain);
    const double at_8 = error_of(multiscan(8), geometry, camera),
                 at_32 = error_of(multiscan(32), geometry, camera),
                 at_128 = error_of(multiscan(128), geometry, camera);
    CHECK(at_8 > 0);
    CHECK(at_32 < at_8 / 6);  // 16 for smooth lengths; kinks at vertices take some of it
    CHECK(at_128 < at_32 / 6);
}

TEST_CASE("orthogonal_scanlines (1): vertical and level edges are exact with one line each way",
          "[baseline][orthogonal]") {
    const Camera camera = small_scenes::orthographic();
    for (const int n : {1, 2, 5}) {
        const auto upright = shown_by(orthogonal(n), one_rectangle(camera, 0.25, 0, 1.625, 4), camera);
        CHECK(weight_of(upright[0], 0) == Approx(0.75).epsilon(1e-15));
        CHECK(weight_of(upright[1], 0) == Approx(0.625).epsilon(1e-15));
        const auto level = shown_by(orthogonal(n), level_border(camera, 1.28), camera);
        CHECK(weight_of(level[5], 0) == Approx(0.28).epsilon(1e-14));
        CHECK(weight_of(level[5], 1) == Approx(0.72).epsilon(1e-14));
        CHECK(weight_of(level[1], 0) == 1);
        CHECK(weight_of(level[9], 1) == 1);
    }
}

TEST_CASE("orthogonal_scanlines (2): a strip between two level lines is missed, but for its ends",
          "[baseline][orthogonal]") {
    const Camera camera = small_scenes::orthographic();
    const Geometry strip = one_rectangle(camera, 0.5, 1.3125, 3.5, 1.34375);
    for (const int n : {1, 2}) {
        const auto pixels = shown_by(orthogonal(n), strip, camera);
        CHECK(weight_of(pixels[5], 0) == 0);
        CHECK(weight_of(pixels[6], 0) == 0);
        CHECK(weight_of(pixels[4], 0) > 0);  // it has a vertex there
    }
    const auto met = shown_by(orthogonal(16), strip, camera);  // the line at 21/16 is its upper edge
    CHECK(weight_of(met[5], 0) == Approx(0.03125).epsilon(1e-13));
}

TEST_CASE("orthogonal_scanlines: more exact than as many lines of multi-scanning", "[baseline][orthogonal]") {
    const Camera camera = small_scenes::camera({24, 24});
    const Geometry geometry = small_scenes::geometry(small_scenes::soup(camera, 60, 4));
    for (const int n : {2, 4, 16})
        CHECK(error_of(orthogonal(n), geometry, camera) < error_of(multiscan(n), geometry, camera));
    CHECK(error_of(orthogonal(64), geometry, camera) < error_of(orthogonal(4), geometry, camera) / 4);
}

TEST_CASE("sample_cells: no fewer rows than columns, and as square as can be", "[baseline][supersampling]") {
    const auto cells = [](int n) {
        const SampleCells c = sample_cells(n);
        return std::pair(c.columns, c.rows);
    };
    CHECK(cells(1) == std::pair(1, 1));
    CHECK(cells(2) == std::pair(1, 2));
    CHECK(cells(7) == std::pair(1, 7));
    CHECK(cells(12) == std::pair(3, 4));
    CHECK(cells(4096) == std::pair(64, 64));
}

TEST_CASE("supersampling (1): grid:N counts cell middles, random:N is exact where an edge is a cell's border",
          "[baseline][supersampling]") {
    const Camera camera = small_scenes::orthographic();
    const auto share = [&](const Factory& method, double right) {
        return weight_of(shown_by(method, one_rectangle(camera, 0, 0, right, 4), camera)[0], 0);
    };
    CHECK(share(grid(4), 0.4) == 0.5);  // columns at 1/4, 3/4
    CHECK(share(grid(4), 0.2) == 0);
    CHECK(share(grid(16), 0.4) == 0.5);  // at 1/8, 3/8, 5/8, 7/8
    CHECK(share(grid(16), 0.3) == 0.25);
    CHECK(share(random_samples(4), 0.5) == 0.5);
    CHECK(share(random_samples(16), 0.25) == 0.25);
}

TEST_CASE("supersampling: jittered places are uniform in their cells, and none knows of another",
          "[baseline][supersampling]") {
    // random:2 looks once into a pixel's upper half and once into its lower. The upper place is in the first
    // rectangle with the odds of 1/4, the lower one in the second with 1/2.
    constexpr int kSide = 32;
    const Camera camera = small_scenes::orthographic({kSide, kSide});
    Mesh first, second;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            small_scenes::add_rectangle(first, camera, x, y, x + 0.5, y + 0.25, 8);
            small_scenes::add_rectangle(second, camera, x + 0.5, y + 0.5, x + 1, y + 1, 8);
        }
    const Geometry geometry = small_scenes::geometry(
        {Object{"first", ObjectKind::Model, first}, Object{"second", ObjectKind::Model, second}});
    const double pixels = kSide * kSide;
    double in_first = 0, in_second = 0, in_both = 0;
    for (const small_scenes::Shown& pixel : shown_by(random_samples(2), geometry, camera)) {
        double of_first = 0, of_second = 0;
        for (const auto& [face, weight] : pixel.weights) (face < pixels ? of_first : of_second) += weight;
        in_first += of_first > 0;
        in_second += of_second > 0;
        in_both += of_first > 0 && of_second > 0;
    }
    // Five standard deviations of so many throws.
    const auto as_thrown = [&](double odds) {
        return Approx(odds * pixels).epsilon(0).margin(5 * std::sqrt(pixels * odds * (1 - odds)));
    };
    CHECK(in_first == as_thrown(1.0 / 4));
    CHECK(in_second == as_thrown(1.0 / 2));
    CHECK(in_both == as_thrown(1.0 / 8));
}

TEST_CASE("supersampling: with four times the samples, jittered ones err at most half as much",
          "[baseline][supersampling]") {
    const Camera camera = small_scenes::camera({24, 24});
    const Geometry geometry = small_scenes::geometry(small_scenes::soup(camera, 60, 4));
    const double at_16 = error_of(random_samples(16), geometry, camera),
                 at_256 = error_of(random_samples(256), geometry, camera);
    CHECK(at_256 < at_16 / 4);
    CHECK(error_of(grid(256), geometry, camera) < error_of(grid(16), geometry, camera) / 3);
}

TEST_CASE("supersampling: pixels that are not asked for stay background", "[baseline][supersampling]") {
    const Camera camera = small_scenes::orthographic();
    SupersamplingOptions options{SamplePattern::Grid, 4, 1, Image<std::uint8_t>(camera.size, 0)};
    options.only[{2, 1}] = 1;
    const auto pixels = shown_by([&](const FacesInView& view) { return supersampling(view, options); },
                                 one_rectangle(camera, 0, 0, 4, 4), camera);
    for (std::size_t i = 0; i < pixels.size(); ++i) CHECK(weight_of(pixels[i], 0) == (i == 6 ? 1 : 0));
}

TEST_CASE("methods: a face is shaded once in a pixel, in the middle of what was found of it there",
          "[baseline][none][multiscan][orthogonal][supersampling]") {
    const Camera camera = small_scenes::orthographic();
    // The right of the pixel's upper half.
    const Geometry face = one_rectangle(camera, 0.3125, 0, 1, 0.5);
    const auto at = [&](const Factory& method) { return shaded_at(method, face, camera); };
    CHECK(at(multiscan(4)) == Point{0.65625, 0.25});  // lines at 1/8 and 3/8
    CHECK(at(grid(16)) == Point{0.625, 0.25});        // columns at 3/8, 5/8, 7/8
    CHECK(at(kCatmull) == Point{0.65625, 0.25});
    const Point orthogonal_place = at(orthogonal(4)), random_place = at(random_samples(4096));
    CHECK(orthogonal_place.x == Approx(0.65625).margin(0.1));  // upright lines at 3/8, 5/8, 7/8, too
    CHECK(orthogonal_place.y == Approx(0.25).margin(0.1));
    // 1300 samples: the mean of uniform ones would be off by 0.005, that of one in each cell by less.
    CHECK(random_place.x == Approx(0.65625).margin(0.005));
    CHECK(random_place.y == Approx(0.25).margin(0.005));
}

TEST_CASE("methods: where water is looked at, and with what share of the pixel",
          "[baseline][none][multiscan][orthogonal][supersampling][water]") {
    const Camera camera = small_scenes::orthographic();
    const auto looks = [&](const Factory& method, double right, double bottom) {
        return water_in_first_pixel(method, camera, right, bottom);
    };
    const auto sum = [](const std::vector<WaterPoint>& points) {
        double weight = 0;
        for (const WaterPoint& point : points) weight += point.weight;
        return weight;
    };
    const auto one = looks(kNone, 0.75, 0.75);
    REQUIRE(one.size() == 1);
    CHECK((one[0].at == Point{0.5, 0.5} && one[0].weight == 1));
    CHECK(looks(kNone, 0.25, 4).empty());

    const auto by_line = looks(multiscan(4), 0.75, 0.5);  // lines at 1/8 and 3/8
    REQUIRE(by_line.size() == 2);
    CHECK((by_line[0].at == Point{0.375, 0.125} && by_line[1].at == Point{0.375, 0.375}));
    CHECK((by_line[0].weight == 0.1875 && by_line[1].weight == 0.1875));

    // The level lines, at 0 and 1, say a half; only the upright ones know where the shore is.
    CHECK(sum(looks(orthogonal(1), 4, 0.28)) == Approx(0.28).epsilon(1e-14));
    CHECK(sum(looks(orthogonal(4), 0.375, 4)) == Approx(0.375).epsilon(1e-14));

    const auto by_sample = looks(grid(4), 0.5, 4);
    REQUIRE(by_sample.size() == 2);
    CHECK((by_sample[0].at == Point{0.25, 0.25} && by_sample[1].at == Point{0.25, 0.75}));
    CHECK((by_sample[0].weight == 0.25 && by_sample[1].weight == 0.25));

    const auto once = looks(kCatmull, 0.5, 0.25);
    REQUIRE(once.size() == 1);
    CHECK((once[0].at == Point{0.25, 0.125} && once[0].weight == 0.125));
}

TEST_CASE("exact_everywhere (1): the areas of the scan, within the error of both", "[baseline][catmull]") {
    const Camera camera = small_scenes::camera({20, 20});
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        const Geometry geometry = small_scenes::geometry(small_scenes::soup(camera, 80, seed));
        const auto scanned = small_scenes::shown(small_scenes::scanned(geometry, camera), camera.size);
        const auto exact = shown_by(kCatmull, geometry, camera);
        double worst = 0;
        for (std::size_t i = 0; i < exact.size(); ++i) {
            worst = std::max(worst, std::abs(exact[i].background - scanned[i].background));
            for (const auto& [face, weight] : exact[i].weights)
                worst = std::max(worst, std::abs(weight - weight_of(scanned[i], face)));
        }
        CHECK(worst <= 4 * kVisibleAreaError);  // many more faces in a pixel than the 8 that the bound is for
    }
}

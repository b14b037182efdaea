// SPDX-License-Identifier: Apache-2.0
// Conductors over water, and their mirror images in it, as unbroken lines.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numeric>
#include <vector>

#include "../support/scratch_folder.hpp"
#include "keikan/render/render_scene.hpp"
#include "keikan/water/fresnel.hpp"

using namespace keikan;

namespace {

/// Of each column of the picture.
using Columns = std::vector<double>;
using Choice = std::function<bool(const Object&)>;

std::size_t object_of(const Geometry& geometry, FaceId face) {
    const auto& first = geometry.first_face;
    return static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), face) - first.begin()) - 1;
}

/// A picture's faces, and what the scan leaves of each column to each object.
struct Scanned {
    Scanned(const Scene& of, const Geometry& shown)
        : scene(of),
          geometry(shown),
          faces(project_faces(shown, of.camera)),
          of_object(shown.objects.size(), Columns(static_cast<std::size_t>(of.camera.size.width), 0)) {
        scan_faces(faces, geometry, scene.camera, {}, [&](const ScanBand& band) {
            const auto add = [&](std::uint32_t face, int x, double area) {
                of_object[band.faces[face].object][static_cast<std::size_t>(x)] += area;
            };
            for (const Span& span : band.spans)
                for (int x = span.x_begin; span.face != Span::kBackground && x < span.x_end; ++x)
                    add(span.face, x, 1);
            for (const DividedPixel& pixel : band.divided)
                for (std::uint32_t p = pixel.part_begin; p < pixel.part_end; ++p)
                    add(band.parts[p].face, pixel.x, band.parts[p].weight);
        });
    }
    Columns seen(const Choice& chosen) const {
        Columns sum(of_object[0].size(), 0);
        for (std::size_t o = 0; o < of_object.size(); ++o)
            for (std::size_t x = 0; chosen(geometry.objects[o]) && x < sum.size(); ++x)
                sum[x] += of_object[o][x];
        return sum;
    }
    const Scene& scene;
    const Geometry& geometry;
    ProjectedFaces faces;
    std::vector<Columns> of_object;
};

/// Where a vertical line of the picture is inside a convex polygon: from row to row; empty where from >= to.
struct Chord {
    double from = 0, to = 0;
};

Chord chord_at(const FaceView& face, double x) {
    Chord chord{1e30, -1e30};
    for (std::size_t i = 0; i < face.outline.size(); ++i) {
        const Point p = face.outline[i], q = face.outline[(i + 1) % face.outline.size()];
        if ((p.x < x) == (q.x < x)) continue;
        const double y = p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y);
        chord = {std::min(chord.from, y), std::max(chord.to, y)};
    }
    return chord;
}

/// The area that the chosen objects' faces cover together in each column, whatever hides them: lengths of the
/// union of their chords, on kChords lines a column. Between the corners of outlines and where these cross
/// the length is linear in x, so the rule errs at those alone; at upright edges, by a chord's share.
Columns union_area(const Scanned& picture, const Choice& chosen) {
    constexpr int kChords = 64;
    const auto& [scene, geometry, faces, ignored] = picture;
    const int width = scene.camera.size.width;
    std::vector<std::vector<Chord>> chords(static_cast<std::size_t>(width * kChords));
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (!chosen(geometry.objects[object_of(geometry, faces[f].id)])) continue;
        double left = 1e30, right = -1e30;
        for (const Point p : faces[f].outline) left = std::min(left, p.x), right = std::max(right, p.x);
        const int begin = static_cast<int>(std::max(0.0, left * kChords - 1)),
                  end = static_cast<int>(std::min<double>(width * kChords, right * kChords + 1));
        for (int i = begin; i < end; ++i) {
            const Chord chord = chord_at(faces[f], (i + 0.5) / kChords);
            if (chord.from < chord.to) chords[static_cast<std::size_t>(i)].push_back(chord);
        }
    }
    Columns area(static_cast<std::size_t>(width), 0);
    for (std::size_t i = 0; i < chords.size(); ++i) {
        std::sort(chords[i].begin(), chords[i].end(),
                  [](const Chord& p, const Chord& q) { return p.from < q.from; });
        double reached = 0;
        for (const Chord& c : chords[i]) {
            const double from = std::max(reached, c.from),
                         to = std::min(c.to, static_cast<double>(scene.camera.size.height));
            if (to > from) area[i / kChords] += (to - from) / kChords, reached = to;
        }
    }
    return area;
}

Columns brightness(const RenderedPicture& picture) {
    Columns sum(static_cast<std::size_t>(picture.image.width()), 0);
    for (int y = 0; y < picture.image.height(); ++y)
        for (int x = 0; x < picture.image.width(); ++x)
            sum[static_cast<std::size_t>(x)] += static_cast<double>(picture.image[PixelIndex{x, y}].r);
    return sum;
}

double total(const Columns& columns) {
    return std::accumulate(columns.begin(), columns.end(), 0.0);
}

bool begins(const std::string& name, const std::string& with) {
    return name.rfind(with, 0) == 0;
}

/// Nothing is lit but what `shines`, which is as bright as 1 from everywhere.
void darken(Scene& scene, const std::function<bool(std::size_t material)>& shines) {
    scene.light = {.sun = {0, 0, 0}, .sky_ambient = {1, 1, 1}, .ground_ambient = {1, 1, 1}};
    scene.background = {.zenith = {0, 0, 0}, .horizon = {0, 0, 0}};
    scene.haze.range_m = 0;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const float level = shines(m) ? 1 : 0;
        scene.materials[m] = {};
        scene.materials[m].colour = {level, level, level};
    }
    for (auto& water : scene.water) {
        water->absorption_per_m = {1e6f, 1e6f, 1e6f};
        water->scattering_per_m = {0, 0, 0};
    }
}

}  // namespace

TEST_CASE("river_crossing: every wire over the river is an unbroken line, as bright as its coverage",
          "[render][water][wire]") {
    Scene scene = read_scene(std::filesystem::path(KEIKAN_SOURCE_DIR) / "data/scenes/river_crossing.json",
                             ImageSize{250, 162});
    const Geometry geometry = build_geometry(scene);
    const Scanned picture(scene, geometry);
    const std::string span = "line/span 2-3 ";
    std::vector<std::string> wires{"ground wire 1"};
    for (const char* const circuit : {"circuit 1 phase ", "circuit 2 phase "})
        for (const char* const phase : {"1", "2", "3"}) wires.push_back(std::string(circuit) + phase);
    int columns = 0, alone = 0;
    for (const std::string& wire : wires) {
        // "... far" are the ribbons of the same wire.
        const auto is_wire = [&](const Object& object) { return begins(object.name, span + wire); };
        const Columns seen = picture.seen(is_wire), exact = union_area(picture, is_wire);
        const auto is_there = [](double area) { return area > 0; };
        const auto first = std::find_if(exact.begin(), exact.end(), is_there) - exact.begin();
        const auto last = exact.rend() - std::find_if(exact.rbegin(), exact.rend(), is_there);
        INFO(wire << " from column " << first << " to " << last);
        REQUIRE(last - first > 50);
        for (auto x = static_cast<std::size_t>(first + 1); x + 1 < static_cast<std::size_t>(last); ++x) {
            INFO("column " << x);
            CHECK(exact[x] > 0.002);
            CHECK(seen[x] > 0);
            // Towers, and wires before it, may hide some of it; nothing can add to it.
            CHECK(seen[x] <= exact[x] * 1.001);
            ++columns;
            alone += std::abs(seen[x] - exact[x]) <= 0.001 * exact[x];
        }
    }
    // Most of it all is hidden by nothing.
    CHECK(columns > 7 * 60);
    CHECK(alone > columns / 2);

    // All of the line together, so that nothing of it is hidden but the towers' feet by the ground: equal in
    // every column between the towers.
    const auto is_line = [](const Object& object) { return begins(object.name, "line/"); };
    const auto is_tower = [](const Object& object) { return object.kind == ObjectKind::Tower; };
    const Columns seen = picture.seen(is_line), exact = union_area(picture, is_line);
    const Columns towers = union_area(picture, is_tower);
    const auto column_of = [&](double x, double y) {
        return static_cast<std::size_t>(scene.camera.image_point({x, y, 360})->x);
    };
    std::vector<std::size_t> between;
    for (std::size_t x = column_of(23495, 2970); x < column_of(24105, 2955); ++x)
        if (towers[x] == 0) between.push_back(x);
    REQUIRE(between.size() > 100);
    for (const std::size_t x : between) {
        INFO("column " << x);
        CHECK(seen[x] == Approx(exact[x]).epsilon(0.01));
    }

    // The picture: only the wires shine, as bright as 1; what the water adds is their mirror image.
    const auto of_wires = [&](std::size_t material) {
        for (const Object& object : geometry.objects)
            if (object.kind == ObjectKind::Conductor &&
                std::count(object.mesh.face_material.begin(), object.mesh.face_material.end(), material) > 0)
                return true;
        return false;
    };
    darken(scene, of_wires);
    const Columns wanted =
        picture.seen([](const Object& object) { return object.kind == ObjectKind::Conductor; });
    RenderOptions options;
    options.water.mode = WaterMode::Flat;
    const Columns flat = brightness(render_scene(scene, geometry, options));
    options.water.mode = WaterMode::Fixed;
    options.water.fixed = 4;
    const Columns by_rays = brightness(render_scene(scene, geometry, options));
    for (const std::size_t x : between) {
        INFO("column " << x);
        CHECK(flat[x] == Approx(wanted[x]).epsilon(1e-5));
        CHECK(by_rays[x] >= wanted[x] * (1 - 1e-5));
    }
}

namespace {

/// A wire 0.02 m thick, a ribbon upright along x, 3 m over black water under a black sky; the wire shines.
/// Seen from 30 m away it is 0.027 of a pixel high.
constexpr const char* kStillWater = R"({
  "image": {"width": 40, "height": 30},
  "camera": {"position": [0, -30, 12], "target": [0, 2, 0], "horizontal_fov_deg": 50},
  "materials": {"white": {"colour": [1, 1, 1]}},
  "objects": [{
    "type": "water", "outline_m": [[-900, -900], [900, -900], [900, 900], [-900, 900]], "level_m": 0,
    "material": "white", "surface": {"waves": [], "ripple_variance": 0}
  }]
})";

struct StillWater {
    explicit StillWater(const ScratchFolder& folder)
        : scene(read_scene(folder.write("still.json", kStillWater))), geometry(build_geometry(scene)) {
        darken(scene, [](std::size_t) { return true; });
        add_wire(geometry, 1);
        // In the mirror: below the water, the other way up.
        add_wire(mirrored, -1);
        mirrored.first_face = {0, 1};
    }
    static void add_wire(Geometry& to, double up) {
        Object wire{"wire", ObjectKind::Conductor, {}};
        const std::uint32_t corners[] = {
            wire.mesh.add_position({-90, 9, up * 3}), wire.mesh.add_position({90, -3, up * 3}),
            wire.mesh.add_position({90, -3, up * 3.02}), wire.mesh.add_position({-90, 9, up * 3.02})};
        wire.mesh.add_face(corners, 0);
        to.objects.push_back(wire);
        if (!to.first_face.empty()) to.first_face.push_back(to.first_face.back() + 1);
    }

    /// What of the picture's columns the mirror image covers, exactly.
    Columns image_area() const {
        return union_area(Scanned(scene, mirrored), [](const Object&) { return true; });
    }
    /// What the water mirrors where the image is, in the middle of each column.
    Columns reflectance() const {
        const ProjectedFaces faces = project_faces(mirrored, scene.camera);
        Columns share;
        for (int x = 0; x < scene.camera.size.width; ++x) {
            const Chord chord = chord_at(faces[0], x + 0.5);
            const double down = -scene.camera.view_direction(x + 0.5, (chord.from + chord.to) / 2).z;
            share.push_back(fresnel_reflectance(down));
        }
        return share;
    }
    /// What the water shows: the picture less the wire itself.
    Columns water_light(const WaterOptions& water) const {
        RenderOptions options;
        options.water = water;
        Columns light = brightness(render_scene(scene, geometry, options));
        const Columns wire = Scanned(scene, geometry).seen([](const Object& o) { return o.name == "wire"; });
        for (std::size_t x = 0; x < light.size(); ++x) light[x] -= wire[x];
        return light;
    }

    Scene scene;
    Geometry geometry, mirrored;
};

}  // namespace

TEST_CASE("WaterPainter (3): a wire of a fortieth of a pixel is an unbroken line in still water",
          "[render][water][wire]") {
    const ScratchFolder folder("render_water");
    const StillWater still(folder);
    const Columns area = still.image_area(), reflectance = still.reflectance();
    const Columns light = still.water_light({});
    for (std::size_t x = 0; x < light.size(); ++x) {
        INFO("column " << x << ": " << light[x] / reflectance[x] << " of " << area[x]);
        REQUIRE(area[x] > 0.01);
        REQUIRE(area[x] < 0.04);
        // 1,024 places tell the area of a strip of one column within 0.003 of a pixel.
        CHECK(std::abs(light[x] / reflectance[x] - area[x]) < 3 * 0.003);
        CHECK(light[x] > 0);
    }
    // That is a tenth of the wire; in 40 columns and 12 pictures, half a hundredth.
    double wanted = 0, sum = 0;
    constexpr int kSeeds = 12;
    for (std::size_t x = 0; x < light.size(); ++x) wanted += area[x] * reflectance[x];
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) sum += total(still.water_light({.seed = seed}));
    CHECK(sum / kSeeds == Approx(wanted).epsilon(3 * 0.005));
    // With as many samples everywhere, which the default takes where nothing is mirrored, it is dots.
    const Columns dots = still.water_light({.mode = WaterMode::Fixed, .fixed = 16});
    CHECK(std::count_if(dots.begin(), dots.end(), [](double l) { return l < 1e-7; }) > 10);
}

TEST_CASE("WaterPainter (3): samples on the image of a wire do not make it brighter, with ripples neither",
          "[render][water][wire]") {
    const ScratchFolder folder("render_water");
    StillWater still(folder);
    // Slopes of 0.007 on either axis spread the image over about a pixel and a half.
    still.scene.water[0]->ripple_variance = 1e-4;
    const double truth = total(still.water_light({.mode = WaterMode::Fixed, .fixed = 512, .seed = 9}));
    // About 64 samples of each picture meet the wire: 1 / sqrt(24 x 64) is the standard error.
    double sum = 0;
    constexpr int kSeeds = 24;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) sum += total(still.water_light({.seed = seed}));
    CHECK(sum / kSeeds == Approx(truth).epsilon(3 * 0.0255));
}

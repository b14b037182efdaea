// SPDX-License-Identifier: Apache-2.0
#include "keikan/render/render_scene.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <vector>

#include "../support/scratch_folder.hpp"
#include "keikan/render/scene_rays.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"

using namespace keikan;

namespace {

constexpr ImageSize kSize{240, 156};

Scene hill(ImageSize size = kSize) {
    return read_scene(std::filesystem::path(KEIKAN_SOURCE_DIR) / "data/scenes/hill.json", size);
}

void write_scan(const std::filesystem::path& file, const Scene& scene, const ScanOptions& options) {
    const Geometry geometry = build_geometry(scene);
    const ProjectedFaces faces = project_faces(geometry, scene.camera);
    ScanFileWriter writer(file, {scene.camera.size, options.extraction, scene.geometry_hash});
    scan_faces(faces, geometry, scene.camera, options, [&](const ScanBand& band) { writer.write(band); });
    writer.finish();
}

bool same(const RenderedPicture& p, const RenderedPicture& q) {
    return p.image == q.image && p.extra.background == q.extra.background &&
           p.extra.object_id == q.extra.object_id && p.extra.depth == q.extra.depth &&
           p.extra.flags == q.extra.flags;
}

}  // namespace

TEST_CASE("shade_scan_file (1): a scan file gives the same bits as the scene itself", "[render][scan]") {
    const ScratchFolder folder("render");
    Scene scene = hill();
    for (const Extraction extraction : {Extraction::Outline, Extraction::Paper}) {
        RenderOptions options;
        options.scan.extraction = extraction;
        options.extra = true;
        write_scan(folder / "hill.scan", scene, options.scan);
        // Colours and lights may change between the two processes.
        scene.light.sun = {0.2f, 0.4f, 0.9f};
        scene.haze.range_m = 3000;
        const RenderedPicture rendered = render_scene(scene, build_geometry(scene), options);
        CHECK(same(rendered, shade_scan_file(folder / "hill.scan", scene, options)));
        CHECK(rendered.scan.divided_pixels > 0);
    }
}

TEST_CASE("render_scene: the number of threads changes nothing", "[render][threads]") {
    const ScratchFolder folder("render");
    const Scene scene = hill();
    const Geometry geometry = build_geometry(scene);
    RenderOptions options;
    options.extra = true;
    write_scan(folder / "hill.scan", scene, options.scan);
    const RenderedPicture first = render_scene(scene, geometry, options);
    for (const int threads : {1, 2, 8}) {
        const ThreadLimit limit(threads);
        CHECK(same(first, render_scene(scene, geometry, options)));
        CHECK(same(first, shade_scan_file(folder / "hill.scan", scene, options)));
    }
}

TEST_CASE("render_scene: every row is told once", "[render]") {
    const Scene scene = hill();
    std::atomic<int> rows = 0;
    RenderOptions options;
    options.after_rows = [&](int n) { rows += n; };
    render_scene(scene, build_geometry(scene), options);
    CHECK(rows == kSize.height);
}

TEST_CASE("render_scene: coverage and flags agree with each other", "[render]") {
    const Scene scene = hill();
    RenderOptions options;
    options.extra = true;
    const RenderedPicture picture = render_scene(scene, build_geometry(scene), options);
    int skies = 0, grounds = 0, wrong = 0;
    for (std::size_t i = 0; i < picture.image.values().size(); ++i) {
        const float background = picture.extra.background.values()[i],
                    object = picture.extra.object_id.values()[i];
        skies += background == 1;
        grounds += background == 0;
        if (background < 0 || background > 1) ++wrong;
        if ((object == 0) != (picture.extra.depth.values()[i] == 0)) ++wrong;
        if (picture.extra.flags.values()[i] == 0 && background != (object == 0 ? 1 : 0)) ++wrong;
    }
    CHECK(wrong == 0);
    CHECK(skies > 1000);
    CHECK(grounds > 1000);
}

TEST_CASE("SceneRays: half of the sun's disc is seen from the edge of a shadow, all or nothing of a point",
          "[render][shadow]") {
    // A wall across y = 0, 10 m high; the sun 45 degrees up beyond it: its shadow ends at y = -10 on z = 0,
    // in a penumbra that is 0.186 m wide.
    Geometry geometry;
    Mesh wall;
    const std::uint32_t corners[] = {wall.add_position({-500, 0, -1}), wall.add_position({500, 0, -1}),
                                     wall.add_position({500, 0, 10}), wall.add_position({-500, 0, 10})};
    wall.add_face(corners, 0);
    geometry.objects.push_back({"wall", ObjectKind::Building, wall});
    geometry.first_face = {0, 1};
    Scene scene;
    scene.materials.resize(1);
    scene.camera.position = {0, -20, 5};
    scene.light.to_sun = {0, std::sqrt(0.5), std::sqrt(0.5)};
    const auto share_at = [&](double y, Shadows shadows) {
        scene.light.shadows = shadows;
        const std::vector<glm::dvec3> points(256, {0, y, 0});
        return SceneRays(scene, geometry).sun_share(points, {0, 0, 1}, 7);
    };
    CHECK(share_at(-10, Shadows::Soft) == Approx(0.5).margin(0.04));
    for (const Shadows shadows : {Shadows::Soft, Shadows::Hard}) {
        CHECK(share_at(-10.2, shadows) == 1);
        CHECK(share_at(-9.8, shadows) == 0);
    }
    CHECK(share_at(-10.02, Shadows::Soft) < 1);
    CHECK(share_at(-10.02, Shadows::Hard) == 1);
    CHECK(share_at(-9.98, Shadows::Soft) > 0);
    CHECK(share_at(-9.98, Shadows::Hard) == 0);
}

TEST_CASE("shade_scan_file: the scan of another picture is refused", "[render][scan]") {
    const ScratchFolder folder("render");
    const Scene scene = hill();
    write_scan(folder / "hill.scan", scene, {});
    CHECK_THROWS_WITH(shade_scan_file(folder / "hill.scan", hill({120, 78})),
                      (folder / "hill.scan").string() + ": was scanned at 240x156, the scene is 120x78");
    Scene moved = scene;
    moved.geometry_hash ^= 1;
    CHECK_THROWS_WITH(shade_scan_file(folder / "hill.scan", moved),
                      Catch::Contains("was scanned from another geometry or camera"));
    CHECK_THROWS_AS(shade_scan_file(folder / "missing.scan", scene), InputError);
}

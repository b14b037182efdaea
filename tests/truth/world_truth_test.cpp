// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth/world_truth.hpp"

#include <catch2/catch.hpp>

#include "keikan/scene/scene.hpp"

using namespace keikan;
using namespace keikan::truth;

namespace {

/// A camera at the origin that looks north, all numbers short: it projects without rounding.
Camera plain_camera() {
    Camera camera;
    camera.focal_px = 4;
    camera.centre_x = camera.centre_y = 4;
    camera.near_m = 1;
    camera.size = {8, 8};
    return camera;
}

/// A triangle at depth 4, y = 4, before a wall at depth 8.
Geometry two_objects(double shift) {
    Geometry geometry;
    Object front{"front", ObjectKind::Model, {}}, wall{"wall", ObjectKind::Model, {}};
    const std::uint32_t triangle[] = {front.mesh.add_position({-1 + shift, 4, -2}),
                                      front.mesh.add_position({1 + shift, 4, -2}),
                                      front.mesh.add_position({0.5 + shift, 4, 1})};
    front.mesh.add_face(triangle, 0);
    const std::uint32_t square[] = {wall.mesh.add_position({-20, 8, -20}),
                                    wall.mesh.add_position({20, 8, -20}), wall.mesh.add_position({20, 8, 20}),
                                    wall.mesh.add_position({-20, 8, 20})};
    wall.mesh.add_face(square, 0);
    geometry.objects = {front, wall};
    geometry.first_face = {0, 1, 2};
    return geometry;
}

}  // namespace

TEST_CASE("rounding_of_projection: numbers that project without rounding differ by nothing",
          "[truth][world]") {
    const Camera camera = plain_camera();
    const Geometry geometry = two_objects(0);
    const ProjectedFaces faces = project_faces(geometry, camera);
    REQUIRE(faces.size() == 2);
    const WorldSummary summary = rounding_of_projection(faces, geometry, camera, 1, 1);
    CHECK(summary.pixels == 64);
    CHECK(summary.checked > 5);
    CHECK(summary.max_difference == 0);
}

TEST_CASE("rounding_of_projection: what rounding did is found, and so is a doctored corner",
          "[truth][world][planted]") {
    const Camera camera = plain_camera();
    const Geometry geometry = two_objects(1.0 / 3);
    ProjectedFaces faces = project_faces(geometry, camera);
    const WorldSummary rounded = rounding_of_projection(faces, geometry, camera, 1, 1);
    CHECK(rounded.max_difference < 1e-14);

    faces.points[0].x += 1e-6;
    const WorldSummary doctored = rounding_of_projection(faces, geometry, camera, 1, 1);
    CHECK(doctored.max_difference > 1e-8);
    CHECK(doctored.max_difference < 2e-6);
    CHECK((doctored.object == "front" || doctored.object == "wall"));
}

TEST_CASE("WorldFaces: corners and planes are those of the projection, but for its rounding",
          "[truth][world]") {
    const Camera camera = plain_camera();
    const Geometry geometry = two_objects(0.1);
    const ProjectedFaces faces = project_faces(geometry, camera);
    const WorldFaces world(faces, geometry, camera);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const oracle::RationalFace face = world[i];
        REQUIRE(face.outline.size() == faces[i].outline.size());
        for (std::size_t k = 0; k < face.outline.size(); ++k) {
            const oracle::RationalPoint& p = face.outline[k];
            CHECK(mpq_class(p.x, p.w).get_d() == Approx(faces[i].outline[k].x).epsilon(1e-14));
            CHECK(mpq_class(p.y, p.w).get_d() == Approx(faces[i].outline[k].y).epsilon(1e-14));
        }
        const mpq_class in_middle(face.a * 4 + face.b * 4 + face.c, face.unit);
        CHECK(in_middle.get_d() == Approx(i == 0 ? 0.25 : 0.125));
    }
}

TEST_CASE("areas_by_rational_splitting: faces of fractions that are doubles give the same areas",
          "[truth][world]") {
    const Ring triangle = {{-0.5, 0.25}, {1.5, 0.125}, {0.75, 3}}, square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    const DepthPlane tilted{0.5, -0.25, 1}, level{0, 0, 1.125};
    const FaceView doubles[] = {{0, triangle, tilted}, {1, square, level}};
    std::vector<oracle::RationalFace> fractions;
    for (const FaceView& face : doubles) {
        const auto in_eighths = [](double value) { return mpz_class(8 * value); };
        oracle::RationalFace same{
            face.id, {}, in_eighths(face.depth.a), in_eighths(face.depth.b), in_eighths(face.depth.c), 8};
        for (const Point p : face.outline)
            same.outline.push_back({mpz_class(24 * p.x), mpz_class(24 * p.y), 24});
        fractions.push_back(same);
    }
    const oracle::RationalFace* const asked[] = {&fractions[0], &fractions[1]};
    for (const PixelIndex pixel : {PixelIndex{0, 0}, PixelIndex{1, 0}, PixelIndex{0, 2}})
        CHECK(oracle::areas_by_rational_splitting(pixel, asked) ==
              oracle::areas_by_rational_splitting(pixel, doubles, Nearness::ByDepth));
}

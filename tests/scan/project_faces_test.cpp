// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "keikan/scan/pixel_question.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/support/parallel.hpp"
#include "small_scenes.hpp"

using namespace keikan;
using namespace keikan::small_scenes;

namespace {

/// Roundings on a projected coordinate's way, in units in the last place of numbers up to 64 pixels.
constexpr double kPixelRounding = 8 * 64 * 0x1p-52;

double nearness(const DepthPlane& plane, Point p) {
    return plane.a * p.x + plane.b * p.y + plane.c;
}

}  // namespace

TEST_CASE("project_faces: a face keeps its corners' order, and its plane gives 1/depth there",
          "[scan][project]") {
    const Camera view = camera({20, 20});
    Mesh mesh;
    const std::vector<Corner> corners{{2, 3, 10}, {15, 4, 20}, {7, 18, 14}};
    add_face(mesh, view, corners);
    const ProjectedFaces faces = project_faces(geometry(mesh), view);
    REQUIRE(faces.size() == 1);
    const FaceView face = faces[0];
    REQUIRE(face.outline.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::abs(face.outline[i].x - corners[i].x) <= kPixelRounding);
        CHECK(std::abs(face.outline[i].y - corners[i].y) <= kPixelRounding);
        CHECK(nearness(face.depth, face.outline[i]) == Approx(1 / corners[i].depth).epsilon(1e-12));
    }
}

TEST_CASE("project_faces: an orthographic camera's nearness is minus the depth", "[scan][project]") {
    const Camera view = orthographic({20, 20});
    Mesh mesh;
    const std::vector<Corner> corners{{2, 3, 10}, {15, 4, 20}, {7, 18, 14}};
    add_face(mesh, view, corners);
    const ProjectedFaces faces = project_faces(geometry(mesh), view);
    REQUIRE(faces.size() == 1);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(nearness(faces.plane[0], faces[0].outline[i]) == Approx(-corners[i].depth).epsilon(1e-12));
}

TEST_CASE("project_faces: a face far from the world's origin has the same plane as near it",
          "[scan][project]") {
    Camera view = camera({20, 20});
    Mesh near, far;
    const std::vector<Corner> corners{{2, 3, 10}, {15, 4, 20}, {7, 18, 14}};
    add_face(near, view, corners);
    const glm::dvec3 away(400000, 5200000, 800);
    add_face(far, view, corners);
    for (glm::dvec3& p : far.positions) p += away;
    const ProjectedFaces here = project_faces(geometry(near), view);
    view.position += away;
    const ProjectedFaces there = project_faces(geometry(far), view);
    REQUIRE(there.size() == 1);
    // The positions themselves round to 1e-9 m there: a plane made of world coordinates would be off by 1e-4.
    CHECK(there.plane[0].a == Approx(here.plane[0].a).epsilon(1e-8));
    CHECK(there.plane[0].c == Approx(here.plane[0].c).epsilon(1e-8));
}

TEST_CASE("project_faces: what crosses the near plane is cut there, alike on both sides of a shared edge",
          "[scan][project][near]") {
    Camera view = camera({20, 20});
    view.near_m = 0.25;
    Mesh mesh;
    // Two triangles with one edge in common, which starts behind the camera and ends in front of it.
    const auto behind = mesh.add_position({0.5, -3, -0.7}), ahead = mesh.add_position({9.1, 12, -8.3});
    const auto left = mesh.add_position({1.3, 11, -9}), right = mesh.add_position({12, 9, -1.1});
    mesh.add_face(std::vector{behind, ahead, left}, 0);
    mesh.add_face(std::vector{ahead, behind, right}, 0);
    const ProjectedFaces faces = project_faces(geometry(mesh), view);
    REQUIRE(faces.size() == 2);
    const auto points = [&](std::size_t f) {
        std::set<std::pair<double, double>> set;
        for (const Point p : faces[f].outline) set.insert({p.x, p.y});
        return set;
    };
    CHECK(faces[0].outline.size() == 4);
    CHECK(faces[1].outline.size() == 4);
    const auto first = points(0), second = points(1);
    std::vector<std::pair<double, double>> common;
    std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                          std::back_inserter(common));
    CHECK(common.size() == 2);  // the corner ahead, and the point where the edge meets the near plane
    for (std::size_t f = 0; f < 2; ++f) {
        int at_near = 0;
        for (const Point p : faces[f].outline)
            if (std::abs(nearness(faces.plane[f], p) - 1 / view.near_m) < 1e-9 / view.near_m) ++at_near;
        CHECK(at_near == 2);
    }
}

TEST_CASE("project_faces: what cannot be seen is left out", "[scan][project]") {
    const Camera view = camera({20, 20});
    Mesh mesh;
    add_rectangle(mesh, view, 2, 2, 4, 4, 10);                   // 0: seen
    add_rectangle(mesh, view, -9, 2, -1, 4, 10);                 // beside the image
    add_rectangle(mesh, view, 2, 21, 4, 24, 10);                 // below it
    add_rectangle(mesh, view, 2, 2, 4, 4, 0.05);                 // before the near plane
    add_rectangle(mesh, view, -2, -2, -4, -4, -10);              // behind the camera
    add_face(mesh, view, {{2, 2, 10}, {4, 4, 20}, {6, 6, 30}});  // seen edge-on
    add_rectangle(mesh, view, -90, -90, 90, 90, 40);             // 6: all around the image
    const ProjectedFaces faces = project_faces(geometry(mesh), view);
    CHECK(faces.id == std::vector<FaceId>{0, 6});
}

TEST_CASE("project_faces: of a closed solid only the faces that look at the camera are kept",
          "[scan][project]") {
    const Camera view = camera({40, 40});
    Mesh box;
    for (int i = 0; i < 8; ++i) box.add_position({1 + (i & 1), 10 + (i >> 1 & 1), -3 + (i >> 2)});
    // Counter-clockwise seen from outside.
    for (const auto& face : {std::vector<std::uint32_t>{0, 1, 5, 4},
                             {2, 6, 7, 3},
                             {0, 4, 6, 2},
                             {1, 3, 7, 5},
                             {0, 2, 3, 1},
                             {4, 5, 7, 6}})
        box.add_face(face, 0);
    CHECK(project_faces(geometry(box), view).size() == 6);
    box.closed = true;
    // Seen from the left and above: front, left side and top.
    CHECK(project_faces(geometry(box), view).id == std::vector<FaceId>{0, 2, 5});
}

TEST_CASE("project_faces: shared corners land on the same doubles, for any number of threads",
          "[scan][project][threads]") {
    const Camera view = camera({64, 64});
    const Geometry scene = geometry(sheet(view, -4, -4, 90, 120, 14, 1));
    std::vector<ProjectedFaces> results;
    for (const int threads : {1, 2, 8}) {
        const ThreadLimit limit(threads);
        results.push_back(project_faces(scene, view));
    }
    for (const ProjectedFaces& faces : results) {
        CHECK(std::is_sorted(faces.id.begin(), faces.id.end()));
        CHECK(faces.points == results[0].points);
        CHECK(faces.begin == results[0].begin);
        CHECK(faces.id == results[0].id);
        CHECK(faces.plane == results[0].plane);
    }
}

TEST_CASE("faces_at: bounding boxes that touch the pixel belong to it", "[scan]") {
    const Camera view = orthographic({20, 20});
    Mesh mesh;
    add_rectangle(mesh, view, 2, 2, 4, 4, 10);
    add_rectangle(mesh, view, 5, 5, 9, 9, 10);
    const ProjectedFaces faces = project_faces(geometry(mesh), view);
    CHECK(faces_at(faces, {4, 4}) == std::vector<std::uint32_t>{0, 1});
    CHECK(faces_at(faces, {1, 1}) == std::vector<std::uint32_t>{0});
    CHECK(faces_at(faces, {9, 5}) == std::vector<std::uint32_t>{1});
    CHECK(faces_at(faces, {10, 5}).empty());

    const PixelCase question = pixel_question(faces, {4, 4});
    CHECK(question.id == "4,4");
    CHECK(question.pixel == PixelIndex{4, 4});
    REQUIRE(question.polygons.size() == 2);
    CHECK(question.nearness() == Nearness::ByDepth);
    CHECK((*question.depth)[1] == faces.plane[1]);
}

TEST_CASE("project_faces: backs of a terrain are left out exactly when the camera surely stands above it",
          "[scan][project][terrain]") {
    // A ridge from west to east: the camera south of it sees the northern slope from behind.
    Mesh ridge;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            ridge.add_position({100.0 * column - 100, 100.0 * row - 50, row == 1 ? 30.0 : 0.0});
    for (std::uint32_t sw : {0u, 1u, 3u, 4u}) {
        ridge.add_face(std::vector{sw, sw + 1, sw + 4}, 0);
        ridge.add_face(std::vector{sw, sw + 4, sw + 3}, 0);
    }
    const auto seen = [&](glm::dvec3 eye, ObjectKind kind) {
        Camera view = camera({64, 64});
        view.centre_x = view.centre_y = 32;
        view.position = eye;
        return project_faces(geometry(ridge, kind), view).id;
    };
    const glm::dvec3 above(0, -40, 20), below(0, -40, 1), beside(0, -60, 20), grazing(0, -40, 3.05);
    const std::vector<FaceId> front{0, 1, 2, 3}, all{0, 1, 2, 3, 4, 5, 6, 7};
    CHECK(seen(above, ObjectKind::Terrain) == front);
    CHECK(seen(above, ObjectKind::Model) == all);  // only a terrain promises to be a height field
    CHECK(seen(below, ObjectKind::Terrain).size() > 4);
    CHECK(seen(beside, ObjectKind::Terrain) == all);
    CHECK(seen(grazing, ObjectKind::Terrain).size() > 4);  // the near plane reaches into the ground
}

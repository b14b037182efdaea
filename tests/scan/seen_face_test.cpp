// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>

#include "keikan/scan/projected_faces.hpp"
#include "keikan/scan/seen_face.hpp"
#include "small_scenes.hpp"

using namespace keikan;
using namespace keikan::small_scenes;

namespace {

/// Components of a float vector that was worked out in doubles, and rounded a few times when put to use.
constexpr double kNormalRounding = 8 * 0x1p-24;

glm::dvec3 vector_of(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// The unit normal that shading would use at an image point.
glm::dvec3 normal_at(const SeenFace& face, double x, double y) {
    return glm::normalize(vector_of(face.normal[0]) + (x - face.normal_at.x) * vector_of(face.normal[1]) +
                          (y - face.normal_at.y) * vector_of(face.normal[2]));
}

void check_vector(const glm::dvec3& found, const glm::dvec3& expected) {
    CHECK(std::abs(found.x - expected.x) <= kNormalRounding);
    CHECK(std::abs(found.y - expected.y) <= kNormalRounding);
    CHECK(std::abs(found.z - expected.z) <= kNormalRounding);
}

SeenFace only_face(const Mesh& mesh, const Camera& view) {
    const Geometry scene = geometry(mesh);
    const ProjectedFaces faces = project_faces(scene, view);
    REQUIRE(faces.size() == 1);
    return seen_face(faces, 0, scene, 0, view);
}

/// A triangle of the plane 3 (y - 50) = 4 z, which rises to the back: its normal towards the eye is
/// (0, -3, 4) / 5 where the eye stands above it.
Mesh ramp_ahead(bool backwards) {
    Mesh mesh;
    const std::uint32_t a = mesh.add_position({2, 50 - 40, -30}), b = mesh.add_position({10, 50 - 32, -24}),
                        c = mesh.add_position({20, 50 - 36, -27});
    mesh.add_face(backwards ? std::vector{a, c, b} : std::vector{a, b, c}, 0);
    return mesh;
}

}  // namespace

TEST_CASE("seen_face: the plane's normal is a unit vector on the viewer's side, however the face is wound",
          "[scan][normal]") {
    for (const bool backwards : {false, true})
        for (const Camera& view : {camera({100, 100}), orthographic({100, 100})}) {
            const SeenFace seen = only_face(ramp_ahead(backwards), view);
            check_vector(vector_of(seen.flat_normal), {0, -0.6, 0.8});
            check_vector(normal_at(seen, 3, 4), {0, -0.6, 0.8});  // without vertex normals: the same all over
            check_vector(normal_at(seen, 90, 0), {0, -0.6, 0.8});
        }
}

TEST_CASE("seen_face: from below the same plane shows its other side", "[scan][normal]") {
    Camera view = camera({100, 100});
    view.position = {0, 0, -200};
    view.centre_x = view.centre_y = 50;
    view.forward = {0, 0, 1};
    view.right = {1, 0, 0};
    view.down = {0, 1, 0};
    check_vector(vector_of(only_face(ramp_ahead(false), view).flat_normal), {0, 0.6, -0.8});
}

TEST_CASE("seen_face: vertex normals are met at the corners and linear over the face between them",
          "[scan][normal]") {
    const std::vector<glm::vec3> normals{{0, -1, 0}, {0.6f, -0.8f, 0}, {0, -0.6f, 0.8f}};
    const std::vector<Corner> corners{{2, 3, 10}, {15, 4, 20}, {7, 18, 14}};
    for (const Camera& view : {camera({20, 20}), orthographic({20, 20})})
        for (const float sign : {1.0f, -1.0f}) {  // normals that point away from the viewer are turned round
            Mesh mesh;
            add_face(mesh, view, corners);
            for (const glm::vec3& n : normals) mesh.normals.push_back(sign * n);
            const SeenFace seen = only_face(mesh, view);
            glm::dvec3 place(0, 0, 0), mean(0, 0, 0);
            const double share[3] = {0.2, 0.3, 0.5};
            for (std::size_t i = 0; i < 3; ++i) {
                check_vector(normal_at(seen, corners[i].x, corners[i].y), glm::dvec3(normals[i]));
                place += share[i] * mesh.positions[i];
                mean += share[i] * glm::dvec3(normals[i]);
            }
            const double to_image = view.kind == Camera::Kind::Perspective ? view.focal_px / place.y : 1;
            check_vector(normal_at(seen, place.x * to_image, -place.z * to_image), glm::normalize(mean));
        }
}

TEST_CASE("seen_face: a face names its object, its number and its material", "[scan]") {
    const Camera view = camera({20, 20});
    Mesh first, second;
    add_face(first, view, {{30, 3, 10}, {35, 4, 10}, {31, 8, 10}});  // beside the picture
    add_face(second, view, {{30, 3, 10}, {35, 4, 10}, {31, 8, 10}});
    const std::uint32_t corner[3] = {second.add_position(at(view, 2, 3, 10)),
                                     second.add_position(at(view, 9, 3, 10)),
                                     second.add_position(at(view, 2, 9, 10))};
    second.add_face(std::vector(corner, corner + 3), 7);
    const Geometry scene =
        geometry({Object{"first", ObjectKind::Model, first}, Object{"second", ObjectKind::Tower, second}});
    const ProjectedFaces faces = project_faces(scene, view);
    REQUIRE(faces.size() == 1);
    const SeenFace seen = seen_face(faces, 0, scene, 1, view);
    CHECK(seen.id == 2);
    CHECK(seen.object == 1);
    CHECK(seen.material == 7);
}

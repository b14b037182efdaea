// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/mesh_file.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "../support/scratch_folder.hpp"
#include "keikan/support/input_error.hpp"
#include "mesh_facts.hpp"

using namespace keikan;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

std::uint16_t one_material(const std::string&) {
    return 7;
}

const char* kCubeObj =
    "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

LoadedMesh load(const std::string& name, const std::string& text, const MeshPlacement& placement = {}) {
    const ScratchFolder folder;
    return read_mesh_file(folder.write(name, text), placement, one_material);
}

double area_of(const Mesh& mesh) {
    double area = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        area += glm::length(doubled_area(mesh, mesh.face(f))) / 2;
    return area;
}

}  // namespace

TEST_CASE("mesh_file: the quads of an OBJ cube stay quads and share their vertices", "[scene][mesh_file]") {
    const LoadedMesh cube = load("cube.obj", kCubeObj, {.y_up = false});
    REQUIRE(is_well_formed(cube.mesh));
    CHECK(cube.mesh.face_count() == 6);
    CHECK(cube.faces_in_file == 6);
    CHECK(cube.mesh.positions.size() == 8);
    CHECK(open_edges(cube.mesh) == 0);
    CHECK_FALSE(cube.mesh.closed);
    CHECK(cube.not_planar + cube.concave + cube.without_area == 0);
    CHECK(std::count(cube.mesh.face_material.begin(), cube.mesh.face_material.end(), 7) == 6);
    CHECK(sixfold_volumes(cube.mesh).front() / 6 == 8);
}

TEST_CASE("mesh_file: a mesh is scaled, stood upright, turned and moved, in this order",
          "[scene][mesh_file]") {
    const MeshPlacement placement{
        .position_m = {100, 200, 300}, .yaw_rad = std::acos(-1.0) / 2, .scale = 3, .y_up = true};
    const LoadedMesh triangle = load("t.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n", placement);
    // (1,0,0) -> x -> y; (0,1,0) is up; (0,0,1) -> -y -> +x.
    const std::array<glm::dvec3, 3> expected{{{100, 203, 300}, {100, 200, 303}, {103, 200, 300}}};
    REQUIRE(triangle.mesh.positions.size() == 3);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK_THAT(glm::distance(triangle.mesh.positions[i], expected[i]), WithinAbs(0, 1e-12));
}

TEST_CASE("mesh_file: polygons that are concave or not planar become triangles and are counted",
          "[scene][mesh_file]") {
    const LoadedMesh arrow =
        load("arrow.obj", "v 0 0 0\nv 4 4 0\nv 0 1 0\nv -4 4 0\nf 1 2 3 4\n", {.y_up = false});
    CHECK(arrow.concave == 1);
    CHECK(arrow.not_planar == 0);
    CHECK(arrow.mesh.face_count() == 2);
    CHECK_THAT(area_of(arrow.mesh), WithinAbs(4, 1e-12));
    for (std::size_t f = 0; f < 2; ++f) CHECK(doubled_area(arrow.mesh, arrow.mesh.face(f)).z > 0);

    const LoadedMesh saddle = load("saddle.obj", "v 0 0 0\nv 1 0 0.1\nv 1 1 0\nv 0 1 0.1\nf 1 2 3 4\n");
    CHECK(saddle.not_planar == 1);
    CHECK(saddle.mesh.face_count() == 2);
    CHECK(largest_distance_from_plane(saddle.mesh) < 1e-15);
    CHECK_THAT(saddle.note("bridge"),
               Contains("bridge") && Contains("1 triangulated because they are not planar"));
}

TEST_CASE("mesh_file: rounding to float does not make a polygon crooked", "[scene][mesh_file]") {
    // Corners of a tilted square with seven digits, 1 km from the file's origin.
    const LoadedMesh tile =
        load("tile.obj",
             "v 1000.1234 57.32111 3\nv 1003.1234 57.32111 4.3333333\n"
             "v 1003.1234 60.32111 5.7777777\nv 1000.1234 60.32111 4.4444444\nf 1 2 3 4\n");
    CHECK(tile.not_planar == 0);
    CHECK(tile.mesh.face_count() == 1);
    // The same square bent by a millimetre is.
    const LoadedMesh bent =
        load("bent.obj",
             "v 1000.1234 57.32111 3\nv 1003.1234 57.32111 4.3343333\n"
             "v 1003.1234 60.32111 5.7777777\nv 1000.1234 60.32111 4.4444444\nf 1 2 3 4\n");
    CHECK(bent.not_planar == 1);
}

TEST_CASE("mesh_file: a star that winds twice is not taken for convex", "[scene][mesh_file]") {
    const LoadedMesh star = load("star.obj",
                                 "v 0 1 0\nv -0.5878 -0.8090 0\nv 0.9511 0.3090 0\nv -0.9511 0.3090 0\n"
                                 "v 0.5878 -0.8090 0\nf 1 2 3 4 5\n");
    CHECK(star.concave == 1);
    CHECK(star.mesh.face_count() == 3);
}

TEST_CASE("mesh_file: PLY polygons, and faces without area that are left out", "[scene][mesh_file]") {
    const LoadedMesh plate =
        load("plate.ply",
             "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
             "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
             "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3\n3 0 1 4\n");
    CHECK(plate.faces_in_file == 1);
    CHECK(plate.without_area == 1);
    CHECK(plate.mesh.face(0).size() == 4);
}

TEST_CASE("mesh_file: glTF, with the transform of its nodes", "[scene][mesh_file]") {
    // One triangle (0,0,0) (1,0,0) (0,1,0), its bytes inline; the node moves it by (10, 20, 30).
    const LoadedMesh triangle =
        load("t.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
        "nodes":[{"mesh":0,"translation":[10,20,30]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
        "bufferViews":[{"buffer":0,"byteLength":36}],
        "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
    REQUIRE(triangle.mesh.positions.size() == 3);
    CHECK(triangle.mesh.positions[1] == glm::dvec3(11, -30, 20));
}

TEST_CASE("mesh_file: materials are asked for by their names in the file, once each", "[scene][mesh_file]") {
    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl steel\nKd 0.5 0.5 0.5\nnewmtl glass\nKd 0 0 1\n");
    const auto file = folder.write("m.obj",
                                   "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl steel\nf 1 2 3\n"
                                   "usemtl glass\nf 1 2 4\nusemtl steel\nf 2 3 4\n");
    std::vector<std::string> asked;
    const LoadedMesh loaded = read_mesh_file(file, {}, [&](const std::string& name) {
        asked.push_back(name);
        return static_cast<std::uint16_t>(name == "glass" ? 2 : 1);
    });
    CHECK(asked == loaded.file_materials);
    CHECK(asked.size() == 2);
    CHECK(std::count(loaded.mesh.face_material.begin(), loaded.mesh.face_material.end(), 1) == 2);
    CHECK(std::count(loaded.mesh.face_material.begin(), loaded.mesh.face_material.end(), 2) == 1);
    CHECK(load("cube.obj", kCubeObj).file_materials == std::vector<std::string>{""});
}

TEST_CASE("mesh_file: what cannot be read names the file and the reason", "[scene][mesh_file]") {
    const auto refusal = [](const std::string& name, const std::string& text) {
        try {
            load(name, text);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
             {"empty.obj", ""},
             {"noise.obj", "\x01\x02\x03"},
             {"points.obj", "v 0 0 0\nv 1 0 0\n"},
             {"wild.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"},
             {"flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"},
             {"nan.obj", "v nan 0 0\nv 1 0 0\nv 2 1 0\nf 1 2 3\n"},
             {"cut.ply", "ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\n"},
             {"cut.gltf", "{\"asset\":"},
             {"not.glb", "glTF"},
             {"model.stl", "solid"}}) {
        const std::string said = refusal(name, text);
        INFO(said);
        CHECK_THAT(said, Contains(name));
        CHECK(std::count(said.begin(), said.end(), '\n') == 0);
    }
    CHECK_THROWS_AS(read_mesh_file("nowhere/at_all.obj", {}, one_material), InputError);
    CHECK_THROWS_AS(load("cube.obj", kCubeObj, {.scale = 0}), InputError);
}

TEST_CASE("mesh_file: a real pylon's 16 crooked quads are triangulated", "[scene][mesh_file]") {
    const char* named = std::getenv("KEIKAN_SHARED_DATA");
    const std::filesystem::path shared = named != nullptr ? named : KEIKAN_SOURCE_DIR "/../shared/data";
    const auto file = shared / "pylons" / "generic_pylon_50m.obj";
    if (!std::filesystem::exists(file)) {
        std::cout << "skipped: no " << file << '\n';
        return;
    }
    const LoadedMesh pylon = read_mesh_file(file, {}, one_material);
    INFO(pylon.note("pylon"));
    CHECK(is_well_formed(pylon.mesh));
    CHECK(pylon.faces_in_file > 100);
    CHECK(largest_distance_from_plane(pylon.mesh) < 1e-5);  // 50 m in float
}

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "../support/scratch_folder.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/scene/terrain.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"

using namespace keikan;
using nlohmann::json;

namespace {

const std::filesystem::path kShipped = std::filesystem::path(KEIKAN_SOURCE_DIR) / "data";

/// The hill with some objects on it.
json hill_with(const json& objects) {
    json document = json::parse(std::ifstream(kShipped / "scenes/hill.json"));
    document["terrain"]["grid"] = (kShipped / "terrain/hill.png").string();
    document["materials"]["plain"] = json::object();
    document["objects"] = objects;
    return document;
}

Geometry built(const json& document) {
    const ScratchFolder folder;
    return build_geometry(read_scene(folder.write("scene.json", document.dump())));
}

std::string refusal_to_build(const json& document) {
    try {
        built(document);
    } catch (const InputError& error) {
        const std::string text = error.what();
        return text.substr(text.find("scene.json"));
    }
    return "not refused";
}

HeightGrid hill() {
    return read_height_grid(kShipped / "terrain/hill.png",
                            GridFrame{{-640, -640}, {20, 20}, 0.01, 0, std::nullopt});
}

std::pair<double, double> heights_of(const Mesh& mesh) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const glm::dvec3& p : mesh.positions) {
        low = std::min(low, p.z);
        high = std::max(high, p.z);
    }
    return {low, high};
}

std::uint64_t bits_of(const Geometry& geometry) {
    std::uint64_t bits = 0;
    for (const Object& object : geometry.objects) {
        for (const glm::dvec3& p : object.mesh.positions) {
            for (const double value : {p.x, p.y, p.z})
                bits = bits * 6364136223846793005U + std::bit_cast<std::uint64_t>(value);
        }
        for (const std::uint32_t corner : object.mesh.corners) bits = bits * 6364136223846793005U + corner;
    }
    return bits;
}

}  // namespace

TEST_CASE("build_geometry: a building's floor is on the highest ground, its walls go down to the lowest",
          "[scene][build]") {
    const json house = {{"type", "building"},
                        {"rectangle", {{"centre_m", {-120, 40}}, {"size_m", {20, 10}}}},
                        {"height_m", 7},
                        {"materials", {{"wall", "plain"}}}};
    const Geometry geometry = built(hill_with(json::array({house})));
    REQUIRE(geometry.objects.size() == 2);
    CHECK(geometry.objects[1].kind == ObjectKind::Building);
    double lowest = 1e9, highest = -1e9;
    for (double x = -130; x <= -110; x += 0.5) {
        for (const double y : {35.0, 45.0}) {
            lowest = std::min(lowest, *height_at(hill(), x, y));
            highest = std::max(highest, *height_at(hill(), x, y));
        }
    }
    const auto [foot, roof] = heights_of(geometry.objects[1].mesh);
    CHECK(roof == Approx(highest + 7).margin(0.5));
    CHECK(foot < lowest);
    CHECK(foot > lowest - 1.5);
}

TEST_CASE("build_geometry: a tower on a slope stands on four legs that reach the ground", "[scene][build]") {
    const json tower = {
        {"type", "tower"}, {"position_m", {150, -60}}, {"yaw_deg", 30}, {"materials", {{"steel", "plain"}}}};
    const Geometry geometry = built(hill_with(json::array({tower})));
    REQUIRE(geometry.objects.size() == 3);
    const Mesh& steel = geometry.objects[1].mesh;
    // In each corner of the base, the lowest steel is at or below the ground there, and not far below.
    const glm::dvec2 centre(150, -60);
    const double turn = 30 * 3.141592653589793 / 180;
    for (int corner = 0; corner < 4; ++corner) {
        double above = 1e9;
        for (const glm::dvec3& p : steel.positions) {
            const glm::dvec2 from = glm::dvec2(p) - centre;
            const double x = std::cos(turn) * from.x + std::sin(turn) * from.y;
            const double y = -std::sin(turn) * from.x + std::cos(turn) * from.y;
            if ((x > 0) != (corner % 2 == 1) || (y > 0) != (corner / 2 == 1) || std::abs(x) < 5 ||
                std::abs(y) < 5)
                continue;
            above = std::min(above, p.z - *height_at(hill(), p.x, p.y));
        }
        INFO("corner " << corner);
        CHECK(above <= 0.01);
        CHECK(above > -4);
    }
}

TEST_CASE("build_geometry: what stands beside the terrain is refused with its place", "[scene][build]") {
    const json tower = {{"type", "tower"}, {"position_m", {700, 0}}, {"materials", {{"steel", "plain"}}}};
    CHECK(refusal_to_build(hill_with(json::array({tower}))).starts_with("scene.json:/objects/0: ("));
    const json line = {{"type", "power_line"},
                       {"route", {{0, 0}, {700, 0}}},
                       {"materials", {{"steel", "plain"}, {"conductor", "plain"}}}};
    CHECK(refusal_to_build(hill_with(json::array({line}))).starts_with("scene.json:/objects/0: "));
}

TEST_CASE("build_geometry: without a terrain the ground is the plane z = 0", "[scene][build]") {
    json document = hill_with(json::array({{{"type", "building"},
                                            {"footprint_m", {{0, 0}, {9, 0}, {9, 6}, {0, 6}}},
                                            {"height_m", 5},
                                            {"materials", {{"wall", "plain"}}}}}));
    document.erase("terrain");
    const Geometry geometry = built(document);
    REQUIRE(geometry.objects.size() == 1);
    CHECK(heights_of(geometry.objects[0].mesh).second == 5);
}

TEST_CASE("build_geometry: the scenes of the project are whole", "[scene][build]") {
    for (const char* name : {"hill", "ridge_line", "coast"}) {
        INFO(name);
        const Scene scene = read_scene(kShipped / "scenes" / (std::string(name) + ".json"));
        const Geometry geometry = build_geometry(scene);
        REQUIRE(geometry.first_face.size() == geometry.objects.size() + 1);
        std::set<std::string> names;
        for (const Object& object : geometry.objects) {
            const Mesh& mesh = object.mesh;
            CHECK(names.insert(object.name).second);
            REQUIRE(mesh.face_begin.size() == mesh.face_material.size() + 1);
            REQUIRE(mesh.face_begin.back() == mesh.corners.size());
            const bool corners_exist =
                std::all_of(mesh.corners.begin(), mesh.corners.end(),
                            [&](std::uint32_t c) { return c < mesh.positions.size(); });
            const bool materials_exist =
                std::all_of(mesh.face_material.begin(), mesh.face_material.end(),
                            [&](std::uint16_t m) { return m < scene.materials.size(); });
            bool faces_are = true;
            for (std::size_t f = 0; f < mesh.face_count(); ++f)
                faces_are = faces_are && mesh.face(f).size() >= 3;
            CHECK((corners_exist && materials_exist && faces_are));
            CHECK((mesh.normals.empty() || mesh.normals.size() == mesh.positions.size()));
        }
    }
}

TEST_CASE("build_geometry: ridge_line has at least 250,000 faces and 6 towers, seen from below",
          "[scene][build]") {
    const Scene scene = read_scene(kShipped / "scenes/ridge_line.json");
    const Geometry geometry = build_geometry(scene);
    CHECK(scene.camera.size == ImageSize{1000, 650});
    CHECK(geometry.first_face.back() >= 250'000);
    std::vector<double> heights_px;
    double nearest_top_px = 650;
    for (const Object& object : geometry.objects) {
        if (object.kind != ObjectKind::Tower) continue;
        double top = 1e9, foot = -1e9;
        bool in_front = true;
        for (const glm::dvec3& p : object.mesh.positions) {
            const auto seen = scene.camera.image_point(p);
            in_front = in_front && seen && seen->x >= 0 && seen->x < 1000;
            if (!seen) continue;
            top = std::min(top, seen->y);
            foot = std::max(foot, seen->y);
        }
        if (!in_front) continue;
        CHECK(heights_of(object.mesh).second > scene.camera.position.z);
        heights_px.push_back(foot - top);
        nearest_top_px = std::min(nearest_top_px, top);
    }
    CHECK(heights_px.size() >= 6);
    CHECK(nearest_top_px >= 0);
    CHECK(nearest_top_px < 65);  // the near tower reaches into the top tenth
    CHECK(*std::max_element(heights_px.begin(), heights_px.end()) > 400);
    CHECK(*std::min_element(heights_px.begin(), heights_px.end()) < 40);
}

TEST_CASE("build_geometry: the same bits for any number of threads", "[scene][build]") {
    const Scene scene = read_scene(kShipped / "scenes/ridge_line.json");
    const auto with_threads = [&](int threads) {
        const ThreadLimit limit(threads);
        return bits_of(build_geometry(scene));
    };
    CHECK(with_threads(1) == with_threads(5));
}

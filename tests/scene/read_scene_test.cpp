// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "../support/scratch_folder.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/support/input_error.hpp"

using namespace keikan;
using nlohmann::json;

namespace {

const std::filesystem::path kData = std::filesystem::path(KEIKAN_SOURCE_DIR) / "data";

/// A scene with one of everything that can be read without building.
json sample() {
    return json::parse(R"({
      "description": "a sample",
      "image": {"width": 400, "height": 260},
      "camera": {"position": [0, -100, 40], "target": [0, 0, 20], "focal_length_35mm": 36},
      "light": {"sun": {"direction": [0, 0, 2], "colour": [1, 0.9, 0.8]}, "sky_ambient": "#ffffff"},
      "background": {"zenith": [0.1, 0.2, 0.3]},
      "haze": {"range_m": 5000},
      "materials": {"steel": {"colour": [0.4, 0.4, 0.4], "specular": 0.2}, "grey": {}, "blue": {"colour": "#0000ff"}},
      "objects": [
        {"type": "tower", "position_m": [0, 0], "materials": {"steel": "steel"}},
        {"type": "power_line", "name": "line", "route": [[0, 0], [300, 0], {"position_m": [600, 40], "height_m": 70}],
         "conductor": {"sag_m": 8, "sub_conductors": 2}, "materials": {"steel": "steel", "conductor": "grey"}},
        {"type": "building", "rectangle": {"centre_m": [30, 30], "size_m": [12, 8], "yaw_deg": 20}, "roof": "gabled",
         "windows": {"rows": 2}, "materials": {"wall": "grey"}},
        {"type": "water", "outline_m": [[-10, -10], [10, -10], [10, 10]], "level_m": 1, "material": "blue"}
      ]
    })");
}

Scene read(const json& document, std::optional<ImageSize> size = std::nullopt) {
    const ScratchFolder folder;
    return read_scene(folder.write("scene.json", document.dump()), size);
}

/// The message with which a document is refused, without its folder.
std::string refusal(const json& document) {
    try {
        read(document);
    } catch (const InputError& error) {
        const std::string text = error.what();
        return text.substr(text.find("scene.json"));
    }
    return "not refused";
}

std::string refusal_of(const std::function<void(json&)>& change) {
    json document = sample();
    change(document);
    return refusal(document);
}

std::uint64_t hash_after(const std::function<void(json&)>& change) {
    json document = sample();
    change(document);
    return read(document).geometry_hash;
}

}  // namespace

TEST_CASE("read_scene: values land where they belong", "[scene][read]") {
    const Scene scene = read(sample());
    CHECK(scene.camera.size == ImageSize{400, 260});
    CHECK(scene.camera.focal_px == Approx(400));
    CHECK(scene.camera.centre_x == 200);
    CHECK(scene.camera.centre_y == 130);
    CHECK(scene.light.to_sun == glm::dvec3(0, 0, 1));
    CHECK(scene.light.sky_ambient == Rgb{1, 1, 1});
    CHECK(scene.background.zenith == Rgb{0.1f, 0.2f, 0.3f});
    CHECK(scene.haze.range_m == 5000);
    REQUIRE(scene.materials.size() == 3);
    CHECK(scene.materials[0].name == "blue");
    CHECK(scene.materials[1].name == "grey");
    CHECK(scene.materials[2].specular == 0.2f);
}

TEST_CASE("read_scene: another size keeps the field of view across", "[scene][read]") {
    const Scene wide = read(sample(), ImageSize{4000, 2600});
    CHECK(wide.camera.focal_px == Approx(4000));
    CHECK(wide.camera.size == ImageSize{4000, 2600});
    const Scene narrow = read(sample());
    const glm::dvec3 a = wide.camera.view_direction(0, 0), b = narrow.camera.view_direction(0, 0);
    CHECK(glm::length(a - b) < 1e-12);
}

TEST_CASE("read_scene: the smallest scene of docs/scene.md is one", "[scene][read]") {
    std::ifstream in(std::filesystem::path(KEIKAN_SOURCE_DIR) / "docs/scene.md");
    const std::string page{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const std::size_t from = page.find("```json\n") + 8;
    json document = json::parse(page.substr(from, page.find("```", from) - from));
    document["terrain"]["grid"] = (kData / "terrain/hill.png").string();
    CHECK(read(document).camera.position.z > 40);
}

TEST_CASE("read_scene: three ways to state the same lens", "[scene][camera]") {
    const double half = std::atan(0.5) * 180 / 3.141592653589793;
    for (const auto& [key, value] :
         {std::pair("focal_length_35mm", 36.0),
          {"horizontal_fov_deg", 2 * half},
          {"vertical_fov_deg", 2 * std::atan(0.5 * 260 / 400) * 180 / 3.141592653589793}}) {
        json document = sample();
        document["camera"].erase("focal_length_35mm");
        document["camera"][key] = value;
        CHECK(read(document).camera.focal_px == Approx(400));
    }
}

TEST_CASE("read_scene: yaw is a compass bearing, pitch looks up", "[scene][camera]") {
    json document = sample();
    document["camera"] = {
        {"position", {0, 0, 0}}, {"yaw_deg", 90}, {"pitch_deg", 30}, {"focal_length_35mm", 50}};
    const Camera camera = read(document).camera;
    CHECK(camera.forward.x == Approx(std::sqrt(0.75)));
    CHECK(camera.forward.y == Approx(0).margin(1e-15));
    CHECK(camera.forward.z == Approx(0.5));
}

TEST_CASE("read_scene: an orthographic picture is so many metres wide", "[scene][camera]") {
    json document = sample();
    document["camera"] = {
        {"type", "orthographic"}, {"position", {0, 0, 10}}, {"target", {0, 1, 10}}, {"width_m", 80}};
    const Camera camera = read(document).camera;
    CHECK(camera.kind == Camera::Kind::Orthographic);
    CHECK(camera.focal_px == 5);
}

TEST_CASE("read_scene: a camera may stand so high above the ground", "[scene][camera][terrain]") {
    const Scene scene = read_scene(kData / "scenes/hill.json");
    json document = *scene.document;
    document["terrain"]["grid"] = (kData / "terrain/hill.png").string();
    document["camera"]["height_above_ground_m"] = 12;
    CHECK(read(document).camera.position.z == Approx(scene.camera.position.z + 10));
    document["camera"]["position"] = {-641, 0};
    CHECK(refusal(document).starts_with("scene.json:/camera/position: lies beside the terrain"));
}

TEST_CASE("read_scene: the sun by date, time and place", "[scene][sun]") {
    json document = sample();
    document["light"]["sun"] = {{"date", "2003-10-17"},
                                {"time", "12:30:30"},
                                {"utc_offset_hours", -7},
                                {"latitude_deg", 39.742476},
                                {"longitude_deg", -105.1786}};
    CHECK(std::asin(read(document).light.to_sun.z) * 180 / 3.141592653589793 == Approx(39.872).margin(0.02));
    document["light"]["sun"]["time"] = "23:30";
    CHECK(refusal(document).find("below the horizon") != std::string::npos);
    document["light"]["sun"]["date"] = "2003-02-29";
    CHECK(refusal(document) == "scene.json:/light/sun/date: is not a day of the calendar");
}

TEST_CASE("read_scene: what is wrong is named with its JSON path", "[scene][read]") {
    using Change = std::function<void(json&)>;
    const std::vector<std::pair<Change, std::string>> cases{
        {[](json& d) { d.erase("camera"); }, "scene.json:/: lacks the key \"camera\""},
        {[](json& d) { d["camara"] = 1; }, "scene.json:/camara: unknown key"},
        {[](json& d) { d["objects"][1]["conductor"]["sag"] = 1; },
         "scene.json:/objects/1/conductor/sag: unknown key"},
        {[](json& d) { d["objects"][1]["conductor"]["sag_m"] = -2; },
         "scene.json:/objects/1/conductor/sag_m: must be greater than 0"},
        {[](json& d) { d["objects"][1]["conductor"]["sag_m"] = "8"; },
         "scene.json:/objects/1/conductor/sag_m: must be a number, not a text"},
        {[](json& d) { d["objects"][1]["conductor"]["sub_conductors"] = 3; },
         "scene.json:/objects/1/conductor/sub_conductors: must be 1, 2 or 4"},
        {[](json& d) { d["objects"][1]["conductor"]["weight_n_per_m"] = 16; },
         "scene.json:/objects/1/conductor/sag_m: weight or tension stands beside it"},
        {[](json& d) { d["objects"][1]["route"][2]["position_m"][1] = nullptr; },
         "scene.json:/objects/1/route/2/position_m/1: must be a number, not null"},
        {[](json& d) { d["objects"][0]["materials"]["steel"] = "stel"; },
         "scene.json:/objects/0/materials/steel: no material is named \"stel\""},
        {[](json& d) { d["objects"][2]["footprint_m"] = json::array(); },
         "scene.json:/objects/2: has both \"footprint_m\" and \"rectangle\""},
        {[](json& d) { d["objects"][3]["outline_m"].erase(2); },
         "scene.json:/objects/3/outline_m: must have at least 3 items, not 2"},
        {[](json& d) { d["objects"][3]["type"] = "lake"; }, "scene.json:/objects/3/type: must be"},
        {[](json& d) {
             d["materials"]["a/b~c"] = {{"diffuse", -1}};
         },
         "scene.json:/materials/a~1b~0c/diffuse: must be at least 0"},
        {[](json& d) { d["materials"]["grey"]["colour"] = "#12345g"; },
         "scene.json:/materials/grey/colour: must be"},
        {[](json& d) { d["image"]["width"] = 1.5; }, "scene.json:/image/width: must be a whole number"},
        {[](json& d) { d["image"]["width"] = 0; }, "scene.json:/image/width: must be from 1 to"},
        {[](json& d) {
             d["camera"]["target"] = {0, -100, 40};
         },
         "scene.json:/camera/target: is the camera's own"},
        {[](json& d) {
             d["camera"]["position"] = {0, 0};
         },
         "scene.json:/camera/position: needs a third number"},
        {[](json& d) {
             d["light"]["sun"]["direction"] = {0, 0, 0};
         },
         "scene.json:/light/sun/direction: must have a length"},
        {[](json& d) { d["haze"] = json::array(); }, "scene.json:/haze: must be an object, not an array"},
        {[](json& d) {
             d["terrain"] = {{"grid", "none.png"}, {"material", "grey"}};
         },
         "scene.json:/terrain/grid: there is no file"},
    };
    for (const auto& [change, expected] : cases) {
        const std::string message = refusal_of(change);
        INFO(message);
        CHECK(message.substr(0, expected.size()) == expected);
        CHECK(message.find('\n') == std::string::npos);
    }
}

TEST_CASE("read_scene: broken JSON is named with its line", "[scene][read]") {
    const ScratchFolder folder;
    const auto message = [&](const std::string& text) -> std::string {
        try {
            read_scene(folder.write("scene.json", text));
        } catch (const InputError& error) {
            const std::string what = error.what();
            return what.substr(what.find("scene.json"));
        }
        return "not refused";
    };
    CHECK(message("{\n\"camera\": \n}").starts_with("scene.json:3: "));
    CHECK(message("{} {}").starts_with("scene.json:1: "));
    CHECK(message("").starts_with("scene.json:1: "));
    CHECK(message("{\"camera\": {\"position\": [1e999, 0, 0]}}").find("overflow") != std::string::npos);
    CHECK(message("{\"haze\": {\"range_m\": 1, \"range_m\": 2}}") ==
          "scene.json: key \"range_m\" comes twice in one object");
    CHECK(message(std::string(100'000, '[')).find("nested deeper") != std::string::npos);
    CHECK(message("[1, 2]") == "scene.json:/: must be an object, not an array");
    CHECK_THROWS_AS(read_scene(folder / "missing.json"), InputError);
    CHECK_THROWS_AS(read_scene(std::filesystem::temp_directory_path()), InputError);
}

TEST_CASE("read_scene: cut off anywhere, a scene is refused", "[scene][read]") {
    const ScratchFolder folder;
    const std::string text = sample().dump();
    for (std::size_t length = 0; length < text.size(); length += 7) {
        CHECK_THROWS_AS(read_scene(folder.write("scene.json", text.substr(0, length))), InputError);
    }
}

TEST_CASE("geometry_hash: colours, lights and sky do not change it", "[scene][hash]") {
    const std::uint64_t hash = read(sample()).geometry_hash;
    CHECK(hash_after([](json& d) { d["description"] = "another"; }) == hash);
    CHECK(hash_after([](json& d) {
              d["materials"]["steel"] = {{"colour", {0.9, 0, 0}}, {"exponent", 80}};
          }) == hash);
    CHECK(hash_after([](json& d) { d["light"]["sun"]["direction"] = {1, 1, 1}; }) == hash);
    CHECK(hash_after([](json& d) { d.erase("background"); }) == hash);
    CHECK(hash_after([](json& d) { d["haze"]["range_m"] = 1; }) == hash);
    CHECK(hash_after([](json& d) {
              d["camera"]["position"] = {0.0, -1e2, 40.0};
          }) == hash);  // the same numbers
}

TEST_CASE("geometry_hash: faces, camera, size and material names change it", "[scene][hash]") {
    const std::uint64_t hash = read(sample()).geometry_hash;
    CHECK(hash_after([](json& d) { d["camera"]["position"][2] = 40.000001; }) != hash);
    CHECK(hash_after([](json& d) { d["image"]["width"] = 401; }) != hash);
    CHECK(hash_after([](json& d) { d["objects"][1]["conductor"]["sag_m"] = 8.01; }) != hash);
    CHECK(hash_after([](json& d) { d["objects"].erase(3); }) != hash);
    CHECK(hash_after([](json& d) { d["objects"][2]["materials"]["wall"] = "blue"; }) != hash);
    CHECK(hash_after([](json& d) { d["materials"]["new"] = json::object(); }) != hash);
    CHECK(read(sample(), ImageSize{400, 261}).geometry_hash != hash);
    CHECK(read(sample(), ImageSize{400, 260}).geometry_hash == hash);
}

TEST_CASE("geometry_hash: the contents of named files change it, their folder does not", "[scene][hash]") {
    const ScratchFolder here, there;
    const auto copy_to = [](const ScratchFolder& folder) {
        std::filesystem::copy_file(kData / "terrain/hill.png", folder / "hill.png");
        std::filesystem::copy_file(kData / "terrain/hill.json", folder / "hill.json");
        json document = json::parse(std::ifstream(kData / "scenes/hill.json"));
        document["terrain"]["grid"] = "hill.png";
        return read_scene(folder.write("scene.json", document.dump())).geometry_hash;
    };
    const std::uint64_t hash = copy_to(here);
    CHECK(copy_to(there) == hash);
    json frame = json::parse(std::ifstream(here / "hill.json"));
    frame["height_offset_m"] = 1;
    here.write("hill.json", frame.dump());
    CHECK(read_scene(here / "scene.json").geometry_hash != hash);
}

TEST_CASE("build_geometry: faces are numbered object by object", "[scene][build]") {
    const Scene scene = read_scene(kData / "scenes/hill.json");
    const Geometry geometry = build_geometry(scene);
    REQUIRE(geometry.objects.size() == 1);
    CHECK(geometry.objects[0].kind == ObjectKind::Terrain);
    CHECK(geometry.first_face == std::vector<std::uint32_t>{0, 2 * 64 * 64});
    const std::string text = describe(scene, geometry);
    CHECK(text.find("8192 faces") != std::string::npos);
}

TEST_CASE("build_geometry: an outline that crosses itself is refused with its place", "[scene][build]") {
    json document = sample();
    document["objects"] = json::array({{{"type", "water"},
                                        {"outline_m", {{0, 0}, {2, 2}, {2, 0}, {0, 2}}},
                                        {"level_m", 0},
                                        {"material", "blue"}}});
    const ScratchFolder folder;
    const Scene scene = read_scene(folder.write("scene.json", document.dump()));
    try {
        build_geometry(scene);
        FAIL("not refused");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).find("scene.json:/objects/0: outline_m: its sides 0 and 2") !=
              std::string::npos);
    }
}

TEST_CASE("read_scene: the surface of water is read, and changes no faces", "[scene][water]") {
    const ScratchFolder folder;
    json document =
        json::parse(R"({"camera": {"position": [0, -9, 5], "target": [0, 0, 0], "horizontal_fov_deg": 50},
        "materials": {"blue": {}}, "objects": [
        {"type": "water", "outline_m": [[-9, -9], [9, -9], [9, 9]], "level_m": 1, "material": "blue"},
        {"type": "water", "outline_m": [[19, 9], [29, 9], [29, 19]], "level_m": 2, "material": "blue"}]})");
    const auto read = [&] { return read_scene(folder.write("scene.json", document.dump())); };
    const Scene flat = read();
    REQUIRE(flat.water.size() == 2);
    CHECK_FALSE(flat.water[0]);
    CHECK_FALSE(flat.water[1]);

    // Towards the east and the north; longest first.
    document["objects"][1]["surface"] = json::parse(R"({"depth_m": 7, "waves": [
        {"amplitude_m": 0.01, "length_m": 1, "towards_deg": 90}, {"amplitude_m": 0.1, "length_m": 4, "towards_deg": 0}]})");
    const Scene wavy = read();
    CHECK_FALSE(wavy.water[0]);
    REQUIRE(wavy.water[1]);
    CHECK(wavy.water[1]->level_m == 2);
    CHECK(wavy.water[1]->depth_m == 7);
    REQUIRE(wavy.water[1]->waves.size() == 2);
    CHECK(wavy.water[1]->waves.direction(0).y == Approx(1));
    CHECK(wavy.water[1]->waves.direction(1).x == Approx(1));
    CHECK(wavy.geometry_hash == flat.geometry_hash);
    document["objects"][1]["level_m"] = 3;
    CHECK_FALSE(read().geometry_hash == flat.geometry_hash);

    // A west wind drives waves to the east; what they lack of the measured slopes is in the ripples.
    document["objects"][0]["surface"] = json::parse(R"({"wind": {"speed_m_s": 5, "from_deg": 270}})");
    const WaterSurface sea = read().water[0].value();
    double along = 0, variance = sea.ripple_variance;
    for (std::size_t i = 0; i < sea.waves.size(); ++i) {
        along += sea.waves.direction(i).x;
        variance += sea.waves.slope_variance(i);
    }
    CHECK(along > 0.7 * static_cast<double>(sea.waves.size()));
    CHECK(variance == Approx(0.003 + 0.00512 * 5));

    document["objects"][0]["surface"] =
        json::parse(R"({"waves": [{"amplitude_m": 1, "length_m": 2, "towards_deg": 0}]})");
    CHECK_THROWS_WITH(read(), Catch::Contains("/objects/0/surface/waves: a wave of amplitude 1 m") &&
                                  Catch::Contains("breaks"));
}

TEST_CASE("build_geometry: a concave water outline covers its area, level and facing up", "[scene][build]") {
    json document = sample();
    document["objects"] = json::array({{{"type", "water"},
                                        {"outline_m", {{0, 0}, {0, 6}, {6, 6}, {6, 0}, {3, 4}}},
                                        {"level_m", 2.5},
                                        {"material", "blue"}}});
    const ScratchFolder folder;
    const Geometry geometry = build_geometry(read_scene(folder.write("scene.json", document.dump())));
    REQUIRE(geometry.objects.size() == 1);
    CHECK(geometry.objects[0].kind == ObjectKind::Water);
    const Mesh& mesh = geometry.objects[0].mesh;
    double area = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto c = mesh.face(f);
        area += glm::cross(mesh.positions[c[1]] - mesh.positions[c[0]],
                           mesh.positions[c[2]] - mesh.positions[c[0]])
                    .z /
                2;
        CHECK(mesh.face_material[f] == 0);
    }
    CHECK(area == Approx(36 - 12));
    for (const glm::dvec3& p : mesh.positions) CHECK(p.z == 2.5);
}

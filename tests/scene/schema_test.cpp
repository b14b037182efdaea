// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "../support/scratch_folder.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/support/input_error.hpp"

using namespace keikan;
using nlohmann::json;

namespace {

const std::filesystem::path kSource = KEIKAN_SOURCE_DIR;
const std::filesystem::path kSchema = kSource / "data/schema/scene.schema.json";

/// What only the reader can know: the schema may accept a document that is refused for one of these.
constexpr std::array kBeyondTheSchema{"no material is named",
                                      "there is no file",
                                      "is the camera's own position",
                                      "must have a length",
                                      "below the horizon",
                                      "is not a day",
                                      "must be greater than the height",
                                      "must be at least \"steep_from_deg\"",
                                      "lies beside the terrain",
                                      "the window reaches outside",
                                      "a wave of amplitude",  // it breaks
                                      "too shallow for a Stokes wave",
                                      "longest waves are shorter"};

json first_sample() {
    json document = json::parse(R"({
      "$schema": "scene.schema.json", "description": "every key once",
      "image": {"width": 400, "height": 260},
      "camera": {"type": "perspective", "position": [0, -100], "height_above_ground_m": 40, "target": [0, 0],
                 "target_height_above_ground_m": 3, "roll_deg": 1, "focal_length_35mm": 36, "near_m": 1,
                 "shift": [0.1, 0.2]},
      "light": {"sun": {"date": "1997-10-15", "time": "10:30", "utc_offset_hours": 9, "latitude_deg": 35,
                        "longitude_deg": 139, "colour": [1, 0.9, 0.8], "shadows": true},
                "sky_ambient": "#a0b0ff", "ground_ambient": [0.1, 0.1, 0.1]},
      "background": {"zenith": [0.1, 0.2, 0.3], "horizon": "#ffffff", "model": "cie_clear", "sun_disc": true},
      "haze": {"range_m": 5000, "colour": [0.7, 0.7, 0.8]},
      "materials": {"m": {"colour": [0.4, 0.4, 0.4], "diffuse": 1, "specular": 0.2, "exponent": 30,
                          "ramp": {"stops": [{"height_m": 0, "colour": [0, 1, 0]}, {"height_m": 9, "colour": [1, 1, 1]}],
                                   "steep": [0.3, 0.3, 0.3], "steep_from_deg": 30, "steep_full_deg": 45}},
                    "n": {}},
      "terrain": {"name": "hill", "grid": "", "material": "m", "stride": 2, "south_west_m": [-640, -640],
                  "window": {"first_column": 1, "first_row": 1, "columns": 64, "rows": 64},
                  "frame": {"description": "d", "crs": "EPSG:32654", "south_west_m": [0, 0], "spacing_m": [20, 20],
                            "height_scale_m": 0.01, "height_offset_m": 0, "void_value": 65535}},
      "objects": [
        {"type": "tower", "name": "t", "position_m": [0, 0], "height_above_ground_m": 1, "yaw_deg": 10, "detail": "boxes",
         "design": {"height_m": 80, "base_width_m": 14, "waist_width_m": 3.6, "top_width_m": 2, "peak_above_arm_m": 10,
                    "arm_spacing_m": 11, "arm_length_m": [11, 12, 10], "arm_depth_m": 2.6, "ground_arm_m": 0,
                    "leg_width_base_m": 0.25, "leg_width_top_m": 0.12, "brace_width_base_m": 0.1,
                    "brace_width_top_m": 0.06, "secondary_width_m": 0.05,
                    "insulator": {"kind": "V", "length_m": 4.6, "discs": 28, "disc_diameter_m": 0.28, "v_half_width_m": 2.6}},
         "materials": {"steel": "m", "insulator": "m", "foundation": "n"}},
        {"type": "power_line", "name": "l", "tower": {"height_m": 70}, "route": [[0, 0], {"position_m": [300, 0], "height_m": 70}],
         "conductor": {"diameter_m": 0.03, "sub_conductors": 2, "bundle_spacing_m": 0.4, "spacer_every_m": 50, "sag_m": 8},
         "ground_wire": {"weight_n_per_m": 8, "horizontal_tension_n": 20000}, "detail": "angles",
         "materials": {"steel": "m", "insulator": "m", "foundation": "m", "conductor": "n", "ground_wire": "n", "spacer": "m"}},
        {"type": "building", "name": "b", "footprint_m": [[0, 0], [10, 0], [10, 8]], "floor_m": 3, "foundation_m": 1,
         "height_m": 6, "roof": "flat", "roof_height_m": 2, "materials": {"wall": "m", "roof": "m", "window": "n"},
         "windows": {"rows": 2, "width_m": 1, "height_m": 1, "spacing_m": 3, "sill_m": 1, "storey_m": 3, "recess_m": 0.1}},
        {"type": "mesh", "name": "x", "file": "", "position_m": [0, 0], "base_m": 5, "yaw_deg": 3, "scale": 2, "up": "z",
         "material": "m", "materials": {"glass": "n"}},
        {"type": "water", "name": "w", "outline_m": [[-10, -10], [10, -10], [10, 10]], "level_m": 1, "material": "n",
         "surface": {"wind": {"speed_m_s": 5, "from_deg": 270, "fetch_m": 900, "waves": 9, "shortest_m": 0.2, "seed": 3},
                     "order": 3, "time_s": 2, "depth_m": 8, "ripple_variance": 0.002, "absorption_per_m": [0.4, 0.1, 0.1],
                     "scattering_per_m": "#102020", "bed_colour": [0.2, 0.2, 0.1]}}
      ]
    })");
    document["terrain"]["grid"] = document["objects"][3]["file"] =
        (kSource / "data/terrain/hill.png").string();
    return document;
}

/// The keys that exclude those of the first.
json second_sample() {
    json document = first_sample();
    document["camera"] = {{"type", "orthographic"},
                          {"position", {1, 2, 3}},
                          {"yaw_deg", 90},
                          {"pitch_deg", 3},
                          {"width_m", 80}};
    document["light"]["sun"] = {{"azimuth_deg", 90}, {"elevation_deg", 30}};
    document["terrain"]["frame"]["spacing_m"] = 20;
    json& building = document["objects"][2];
    building.erase("footprint_m");
    building["rectangle"] = {{"centre_m", {30, 30}}, {"size_m", {12, 8}}, {"yaw_deg", 20}};
    document["objects"][3].erase("base_m");
    document["objects"][4]["surface"] = {
        {"waves",
         {{{"amplitude_m", 0.2}, {"length_m", 8}, {"towards_deg", 30}, {"phase_deg", 90}},
          {{"amplitude_m", 0.01}, {"length_m", 1}, {"towards_deg", -10}}}}};
    return document;
}

/// Small documents, each about one thing: the keys under `place` are what it is there for.
struct Sample {
    std::string place;
    json document;
};

std::vector<Sample> samples() {
    std::vector<Sample> all;
    const json shortest_camera = {{"position", {1, 2, 3}}, {"yaw_deg", 4}, {"vertical_fov_deg", 50}};
    std::set<std::string> seen;
    for (json document : {first_sample(), second_sample()}) {
        for (const json& object : document["objects"]) {
            if (!seen.insert(object.dump()).second) continue;
            all.push_back({"/objects",
                           {{"camera", shortest_camera},
                            {"materials", {{"m", json::object()}, {"n", json::object()}}}}});
            all.back().document["objects"] = json::array({object});
        }
        document.erase("objects");
        all.push_back({"", document});
    }
    all.push_back({"/camera", {{"camera", shortest_camera}}});
    all.push_back({"",
                   {{"camera", {{"position", {1, 2, 3}}, {"target", {3, 4, 5}}, {"horizontal_fov_deg", 50}}},
                    {"light", {{"sun", {{"direction", {1, 1, 1}}}}}}}});
    return all;
}

/// Every document that differs from the sample in one place: a value replaced, a key removed or added.
std::vector<json> mutations(const Sample& sample) {
    const json& document = sample.document;
    std::vector<json> changed;
    const json flat = document.flatten();
    std::set<std::string> places{sample.place};
    for (const auto& entry : flat.items()) {
        for (std::string path = entry.key(); !path.empty(); path = path.substr(0, path.rfind('/'))) {
            if (path.starts_with(sample.place)) places.insert(path);
        }
    }
    for (const std::string& place : places) {
        const json::json_pointer pointer(place);
        for (const json& value : {json(nullptr), json("text"), json(-1), json(0), json(2.5), json(1e12),
                                  json::object(), json({1, 2}), json({1, 2, 3})}) {
            changed.push_back(document);
            changed.back()[pointer] = value;
        }
        if (document[pointer].is_object()) {
            changed.push_back(document);
            changed.back()[pointer]["unheard_of"] = 1;
            for (const auto& entry : document[pointer].items()) {
                changed.push_back(document);
                changed.back()[pointer].erase(entry.key());
            }
        }
    }
    return changed;
}

/// The reader's reason to refuse; empty if it does not.
std::string refusal(const json& document, const ScratchFolder& folder) {
    try {
        read_scene(folder.write("scene.json", document.dump()));
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

/// What the schema says of each document; nothing where python3-jsonschema is missing.
std::optional<std::vector<bool>> schema_verdicts(const std::vector<json>& documents) {
    const ScratchFolder folder;
    std::string lines;
    for (const json& document : documents) lines += document.dump() + "\n";
    folder.write("lines", lines);
    const std::string command = "python3 '" + (kSource / "tests/scene/validate_lines.py").string() + "' '" +
                                kSchema.string() + "' '" + (folder / "lines").string() + "' > '" +
                                (folder / "verdicts").string() + "'";
    const int status = std::system(command.c_str());
    if (WEXITSTATUS(status) == 77 || WEXITSTATUS(status) == 127) {
        std::cerr << "skipped: python3-jsonschema is not installed\n";
        return std::nullopt;
    }
    REQUIRE(status == 0);
    std::vector<bool> verdicts;
    std::ifstream in(folder / "verdicts");
    for (std::string word; in >> word;) verdicts.push_back(word == "valid");
    REQUIRE(verdicts.size() == documents.size());
    return verdicts;
}

void collect_names(const json& schema, std::set<std::string>& names) {
    if (schema.is_object() && schema.contains("properties") && schema.value("type", "") == "object") {
        for (const auto& entry : schema["properties"].items()) names.insert(entry.key());
    }
    if (!schema.is_structured()) return;
    for (const json& part : schema) collect_names(part, names);
}

}  // namespace

TEST_CASE("scene schema: every key that it knows is in a sample", "[scene][schema]") {
    std::set<std::string> names;
    collect_names(json::parse(std::ifstream(kSchema)), names);
    CHECK(names.size() > 100);
    std::string text;
    for (const Sample& sample : samples()) text += sample.document.dump();
    for (const std::string& name : names) {
        INFO(name);
        CHECK(text.find("\"" + name + "\":") != std::string::npos);
    }
}

TEST_CASE("scene schema: says what the reader says, of samples and of each with one thing changed",
          "[scene][schema]") {
    std::vector<json> documents;
    for (const Sample& sample : samples()) documents.push_back(sample.document);
    for (const Sample& sample : samples()) {
        const auto changed = mutations(sample);
        documents.insert(documents.end(), changed.begin(), changed.end());
    }
    const auto verdicts = schema_verdicts(documents);
    if (!verdicts) return;
    const ScratchFolder folder;
    std::size_t accepted = 0;
    for (std::size_t i = 0; i < documents.size(); ++i) {
        const std::string reason = refusal(documents[i], folder);
        accepted += reason.empty();
        const bool beyond =
            std::any_of(kBeyondTheSchema.begin(), kBeyondTheSchema.end(),
                        [&](const char* words) { return reason.find(words) != std::string::npos; });
        if (beyond || (*verdicts)[i] == reason.empty()) continue;
        FAIL_CHECK((reason.empty() ? "read, but invalid: " : "valid, but refused: " + reason + ": ")
                   << documents[i].dump());
    }
    for (std::size_t i = 0; i < samples().size(); ++i) CHECK(refusal(documents[i], folder).empty());
    CHECK(accepted > 100);
}

TEST_CASE("scene schema: every scene of the project is valid, readable and its words are the reader's",
          "[scene][schema]") {
    std::vector<json> documents;
    for (const auto& entry : std::filesystem::directory_iterator(kSource / "data/scenes")) {
        if (entry.path().extension() != ".json") continue;
        INFO(entry.path());
        CHECK_NOTHROW(read_scene(entry.path()));
        documents.push_back(json::parse(std::ifstream(entry.path())));
    }
    REQUIRE_FALSE(documents.empty());
    if (const auto verdicts = schema_verdicts(documents)) {
        for (const bool valid : *verdicts) CHECK(valid);
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "keikan/scan/scan_scene.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "keikan/support/progress.hpp"
#include "picture_size.hpp"
#include "truth/layer_truth.hpp"
#include "truth/read_layer.hpp"
#include "truth/scene_truth.hpp"
#include "truth/truth_files.hpp"
#include "truth/world_truth.hpp"

namespace keikan {
namespace {

struct TruthCommand {
    std::string scene, output, size, format = "auto", png, window;
    std::vector<std::string> layers;
    bool from_world = false;
    std::uint64_t one_in = 16;
};

/// Whether the mattes go into a Cryptomatte; otherwise into channels. Errors: InputError.
bool is_cryptomatte(const std::string& format, std::size_t mattes) {
    if (format == "auto") return mattes > truth::kMostChannels;
    if (format == "channels") return false;
    if (format == "cryptomatte") return true;
    throw InputError("--format " + format + ": there are only: auto, channels, cryptomatte");
}

void require_writable(const TruthCommand& command) {
    if (command.output != "-" && std::filesystem::path(command.output).extension() != ".exr")
        throw InputError(command.output, "", "a file of coverages ends in .exr");
    is_cryptomatte(command.format, 0);
    const AtomicFile probe(command.output);  // unfinished: leaves nothing
}

nlohmann::ordered_json places(const std::vector<truth::TruthSummary::Place>& found) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const auto& [pixel, error] : found)
        list.push_back({{"pixel", {pixel.x, pixel.y}}, {"error", error}});
    return list;
}

/// The summary on standard output, and in the file of --json.
void tell_json(const std::string& json, const CommonOptions& common) {
    if (!common.json.empty() && common.json != "-") write_whole_file(common.json, json + "\n");
    std::puts(json.c_str());
    std::fflush(stdout);
}

/// Writes the picture in the forms asked for, and says in which.
std::string write_picture(const TruthCommand& command, const truth::CoveragePicture& picture,
                          std::map<std::string, std::string> metadata) {
    metadata.insert(
        {{"software", "keikan-verify " KEIKAN_VERSION},
         {"content", "exact visible coverage of every pixel, rounded once to the nearest float"},
         {"filter", "box of one pixel: pixel (i, j) is the unit square [i, i+1] x [j, j+1], y down"}});
    const bool cryptomatte = is_cryptomatte(command.format, picture.mattes.size());
    if (cryptomatte)
        write_cryptomatte(command.output, picture, std::move(metadata));
    else
        write_coverage_channels(command.output, picture, std::move(metadata));
    if (!command.png.empty()) truth::write_coverage_pngs(command.png, picture);
    return cryptomatte ? "cryptomatte" : "channels";
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void truth_of_scene(const TruthCommand& command, CommonOptions& common) {
    const auto start = std::chrono::steady_clock::now();
    require_writable(command);
    const ThreadLimit threads(common.threads);
    const Scene scene = read_scene(command.scene, picture_size(command.size));
    const Geometry geometry = build_geometry(scene);
    const ProjectedFaces faces = project_faces(geometry, scene.camera);
    Progress progress("truth", static_cast<std::size_t>(scene.camera.size.height), !common.quiet);
    truth::SceneTruth truth(faces, geometry, scene.camera.size, common.seed);
    scan_faces(faces, geometry, scene.camera, {}, [&](const ScanBand& band) {
        truth.take(band);
        progress.advance(static_cast<std::size_t>(band.rows));
    });
    const truth::CoveragePicture& picture = truth.picture();
    const ImageSize size = scene.camera.size;
    const std::string format = write_picture(command, picture,
                                             {{"scene", scene.file.filename().string()},
                                              {"scene_hash", fmt::format("{:016x}", scene.geometry_hash)},
                                              {"window", fmt::format("0,0,{},{}", size.width, size.height)}});

    const truth::TruthSummary& found = truth.summary();
    common.pass = found.pass();
    nlohmann::ordered_json json;
    json["verdict"] = found.pass() ? "pass" : "fail";
    json["pixels"] = found.pixels;
    json["polygons"] = found.polygons;
    json["objects"] = picture.mattes.size();
    json["format"] = format;
    json["max_area_error"] = found.max_error;
    json["max_sum_error"] = found.max_sum_error;
    json["codes_16_bit"] = {{"compared", found.values},
                            {"differing", found.differing_codes},
                            {"at_boundary", found.at_boundary},
                            {"differing_at_boundary", found.differing_at_boundary},
                            {"pixels", places(found.differing)}};
    json["oracle"] = {{"cgal", found.rungs.cgal},
                      {"rational", found.rungs.rational},
                      {"quad", found.rungs.quad},
                      {"certified", found.rungs.certified}};
    json["unsettled"] = found.unsettled;
    json["form_faults"] = found.form_faults;
    json["worst"] = places(found.worst);
    if (command.from_world) {
        const truth::WorldSummary world =
            truth::rounding_of_projection(faces, geometry, scene.camera, common.seed, command.one_in);
        json["from_world"] = {{"checked", world.checked},
                              {"one_in", command.one_in},
                              {"max_coverage_difference", world.max_difference},
                              {"pixel", {world.at.x, world.at.y}},
                              {"object", world.object}};
    }
    json["seconds"] = seconds_since(start);
    tell_json(json.dump(), common);
    if (common.quiet) return;
    fmt::print(
        stderr,
        "{}: {} pixels, {} objects as {}; float path against truth: {} of {} 16-bit values differ, {} near a "
        "boundary; largest error {:.3g}; {} pixels settled by rational arithmetic\n",
        found.pass() ? "pass" : "FAIL", found.pixels, picture.mattes.size(), format, found.differing_codes,
        found.values, found.at_boundary, found.max_error, found.unsettled);
}

/// "x0,y0,x1,y1". Errors: InputError.
truth::Window window_of(const std::string& text) {
    std::istringstream in(text);
    double number[4] = {};
    char comma = ',';
    for (int i = 0; i < 4; ++i) {
        if (i > 0) in >> comma;
        if (!(in >> number[i]) || comma != ',' || !std::isfinite(number[i]))
            throw InputError("--window " + text + ": is not X0,Y0,X1,Y1");
    }
    if (in.peek() != std::istringstream::traits_type::eof())
        throw InputError("--window " + text + ": is not X0,Y0,X1,Y1");
    if (number[0] == number[2] || number[1] == number[3])
        throw InputError("--window " + text + ": has no area");
    return {{number[0], number[1]}, {number[2], number[3]}};
}

void truth_of_layers(const TruthCommand& command, CommonOptions& common) {
    const auto start = std::chrono::steady_clock::now();
    require_writable(command);
    const truth::Window window = window_of(command.window);
    const std::optional<ImageSize> size = picture_size(command.size);
    if (!size) throw InputError("--layers needs --size WIDTHxHEIGHT");
    const ThreadLimit threads(common.threads);
    const std::vector<truth::Layer> layers = truth::read_layers(command.layers);
    std::vector<double> covered(layers.size() + 1, 0.0);
    const auto add = [&](PixelIndex, std::uint32_t layer, const mpq_class& coverage) {
        covered[std::min<std::size_t>(layer, layers.size())] += coverage.get_d();
    };
    const truth::CoveragePicture picture = truth::layer_coverage(layers, window, *size, add);
    const std::string format =
        write_picture(command, picture,
                      {{"layers", fmt::format("{}", fmt::join(picture.mattes, ","))},
                       {"scene_hash", fmt::format("{:016x}", truth::hash_of(layers))},
                       {"window", fmt::format("{:.17g},{:.17g},{:.17g},{:.17g}", window.from.x, window.from.y,
                                              window.to.x, window.to.y)}});
    nlohmann::ordered_json json;
    json["verdict"] = "pass";
    json["pixels"] = static_cast<std::int64_t>(size->width) * size->height;
    json["format"] = format;
    json["layers"] = nlohmann::ordered_json::array();
    std::size_t polygons = 0;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        polygons += layers[i].polygons.size();
        json["layers"].push_back({{"name", layers[i].name},
                                  {"polygons", layers[i].polygons.size()},
                                  {"covered_pixels", covered[i]}});
    }
    json["polygons"] = polygons;
    json["background_pixels"] = covered.back();
    json["seconds"] = seconds_since(start);
    tell_json(json.dump(), common);
}

void run_truth(const TruthCommand& command, CommonOptions& common) {
    if (command.scene.empty() == command.layers.empty())
        throw InputError("truth: takes a scene, or --layers with --window and --size");
    if (!command.layers.empty()) {
        if (command.from_world) throw InputError("--from-world: layers have no camera");
        return truth_of_layers(command, common);
    }
    if (!command.window.empty()) throw InputError("--window: a scene has its camera");
    truth_of_scene(command, common);
}

}  // namespace

void add_truth_command(CLI::App& app, CommonOptions& common) {
    auto* const sub =
        app.add_subcommand("truth", "Ground truth: exact coverage per object, rounded once, as OpenEXR");
    const auto command = std::make_shared<TruthCommand>();
    sub->add_option("SCENE", command->scene, "Scene file (docs/scene.md)");
    sub->add_option("-o,--output", command->output, "OpenEXR file to write")->required();
    sub->add_option("--size", command->size, "WIDTHxHEIGHT instead of the scene's");
    sub->add_option("--format", command->format, "channels, cryptomatte, or auto: by the number of objects")
        ->capture_default_str();
    sub->add_option("--png", command->png, "Folder for a grey 16-bit PNG of each object too");
    sub->add_option("--layers", command->layers,
                    "Instead of a scene: files of polygons, nearest first (.wkt, .geojson)")
        ->delimiter(',');
    sub->add_option("--window", command->window,
                    "X0,Y0,X1,Y1: the picture's first and last corner in the layers' coordinates");
    sub->add_flag("--from-world", command->from_world,
                  "Measure the rounding of the projection too: coverage from world coordinates, exactly");
    sub->add_option("--one-in", command->one_in,
                    "--from-world: one of so many pixels that show more than a face")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 32))
        ->capture_default_str();
    sub->callback([command, &common] { run_truth(*command, common); });
}

}  // namespace keikan

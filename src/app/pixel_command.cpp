// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/scan/pixel_question.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/parallel.hpp"
#include "option_values.hpp"

namespace keikan {

namespace {

struct PixelCommand {
    std::string scene, at, size;
};

/// Which object each face belongs to, by name: a key that readers of pixel cases ignore.
nlohmann::json object_names(const ProjectedFaces& faces, PixelIndex pixel, const Geometry& geometry) {
    nlohmann::json names = nlohmann::json::array();
    for (const std::uint32_t face : faces_at(faces, pixel)) {
        const auto next = std::ranges::upper_bound(geometry.first_face, faces.id[face]);
        names.push_back(
            geometry.objects[static_cast<std::size_t>(next - geometry.first_face.begin() - 1)].name);
    }
    return names;
}

void pixel(const PixelCommand& command, const CommonOptions& common) {
    const ThreadLimit threads(common.threads);
    const Scene scene = read_scene(command.scene, picture_size(command.size));
    const PixelIndex index = pixel_of(command.at, scene.camera.size);
    const Geometry geometry = build_geometry(scene);
    const ProjectedFaces faces = project_faces(geometry, scene.camera);
    std::string line = pixel_case_line(pixel_question(faces, index));
    line.pop_back();
    write_whole_file("-", line + ", \"objects\": " + object_names(faces, index, geometry).dump() + "}\n");
}

}  // namespace

void add_pixel_command(CLI::App& app, const CommonOptions& common) {
    auto* const sub = app.add_subcommand("pixel", "One pixel of a scene as a pixel case (docs/cases.md)");
    const auto command = std::make_shared<PixelCommand>();
    sub->add_option("SCENE", command->scene, "Scene file (docs/scene.md)")->required();
    sub->add_option("--at", command->at, "X,Y: column and row of the pixel")->required();
    sub->add_option("--size", command->size, "WIDTHxHEIGHT instead of the scene's");
    sub->callback([command, &common] { pixel(*command, common); });
}

}  // namespace keikan

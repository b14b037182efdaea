// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>

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

void pixel(const PixelCommand& command, const CommonOptions& common) {
    const ThreadLimit threads(common.threads);
    const Scene scene = read_scene(command.scene, picture_size(command.size));
    const PixelIndex index = pixel_of(command.at, scene.camera.size);
    const ProjectedFaces faces = project_faces(build_geometry(scene), scene.camera);
    write_whole_file("-", pixel_case_line(pixel_question(faces, index)) + "\n");
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

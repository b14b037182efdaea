// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/parallel.hpp"
#include "option_values.hpp"

namespace keikan {

namespace {

struct InfoCommand {
    std::string scene, size;
};

void info(const InfoCommand& command, const CommonOptions& common) {
    const ThreadLimit threads(common.threads);
    const Scene scene = read_scene(command.scene, picture_size(command.size));
    std::string text = describe(scene, build_geometry(scene));
    if (!text.ends_with('\n')) text += '\n';
    write_whole_file("-", text);
}

}  // namespace

void add_info_command(CLI::App& app, const CommonOptions& common) {
    auto* const sub = app.add_subcommand("info", "What is in a scene");
    const auto command = std::make_shared<InfoCommand>();
    sub->add_option("SCENE", command->scene, "Scene file (docs/scene.md)")->required();
    sub->add_option("--size", command->size, "WIDTHxHEIGHT instead of the scene's");
    sub->callback([command, &common] { info(*command, common); });
}

}  // namespace keikan

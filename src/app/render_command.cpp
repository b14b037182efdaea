// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "keikan/baseline/method.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "keikan/support/progress.hpp"
#include "option_values.hpp"
#include "output_picture.hpp"
#include "run_statistics.hpp"
#include "water_choice.hpp"

namespace keikan {

namespace {

/// Errors: InputError naming the option.
baseline::Method method_option(const std::string& text) {
    try {
        return baseline::method_of(text);
    } catch (const InputError& error) {
        throw InputError(std::string("--method: ") + error.what());
    }
}

struct RenderCommand {
    std::string scene, size, method = "kato", extract = "outline", engine = "splitting", shadows, stats;
    WaterChoice water;
    OutputOptions output;
};

void render(const RenderCommand& command, const CommonOptions& common) {
    const baseline::Method method = method_option(command.method);
    require_writable(command.output);
    const std::optional<Shadows> shadows = shadows_of(command.shadows);
    const ThreadLimit threads(common.threads);
    StageClock clock;

    Scene scene = read_scene(command.scene, picture_size(command.size));
    if (shadows) scene.light.shadows = *shadows;
    clock.ended("read");
    const Geometry geometry = build_geometry(scene);
    clock.ended("build");
    Progress progress("rendering", static_cast<std::size_t>(scene.camera.size.height), !common.quiet);
    baseline::MethodOptions method_options;
    method_options.seed = static_cast<std::uint32_t>(common.seed);
    RenderOptions& options = method_options.render;
    options.scan.extraction = extraction_of(command.extract);
    options.water = water_options(command.water);
    options.scan.engine = engine_of(command.engine);
    options.extra = command.output.aov;
    options.after_rows = [&](int rows) { progress.advance(static_cast<std::size_t>(rows)); };
    RenderedPicture picture = render_by(method, scene, geometry, method_options);
    clock.ended("render");
    clock.note("render.project", picture.scan.seconds_project);
    clock.note("render.bin", picture.scan.seconds_bin);
    clock.note("render.divide", picture.scan.seconds_divide);
    clock.note("render.shade", picture.seconds_shade);
    const ScanStatistics scan = picture.scan;
    const WaterStatistics water = picture.water;
    if (water.pixels > 0) clock.note("render.water", water.seconds);
    write_picture(command.output, scene, std::move(picture));
    clock.ended("write");

    write_statistics(command.stats, "render", scene.camera.size, clock, &scan, &water);
    tell_done(common.quiet, command.output.image, scene.camera.size, clock);
}

}  // namespace

void add_render_command(CLI::App& app, const CommonOptions& common) {
    auto* const sub = app.add_subcommand("render", "Scan and shade: from a scene to a picture");
    const auto command = std::make_shared<RenderCommand>();
    sub->add_option("SCENE", command->scene, "Scene file (docs/scene.md)")->required();
    sub->add_option("-o,--output", command->output.image,
                    "Picture: .png, .exr, or - for PNG on standard output")
        ->required();
    sub->add_option("--size", command->size, "WIDTHxHEIGHT instead of the scene's");
    sub->add_option("--method", command->method,
                    "Anti-aliasing: kato, none, multiscan:N, orthogonal:N, catmull, grid:N, random:N "
                    "(docs/results.md)")
        ->capture_default_str();
    sub->add_option("--extract", command->extract, "Which pixels are divided exactly: outline, paper")
        ->capture_default_str();
    add_water_options(*sub, command->water);
    add_shadows_option(*sub, command->shadows);
    sub->add_option("--engine", command->engine, "For visible areas: splitting, traversal, published")
        ->capture_default_str();
    sub->add_option("--bits", command->output.bits, "Of a PNG, for each colour: 8 or 16")
        ->check(CLI::IsMember({8, 16}))
        ->capture_default_str();
    sub->add_flag("--aov", command->output.aov, "Also background, object_id, depth, flags in the .exr");
    sub->add_option("--stats", command->stats, "Write seconds per stage and counts as JSON");
    sub->callback([command, &common] { render(*command, common); });
}

}  // namespace keikan

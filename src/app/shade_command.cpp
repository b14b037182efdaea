// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "keikan/support/parallel.hpp"
#include "keikan/support/progress.hpp"
#include "option_values.hpp"
#include "output_picture.hpp"
#include "run_statistics.hpp"
#include "water_choice.hpp"

namespace keikan {

namespace {

struct ShadeCommand {
    std::string scan, scene, shadows, stats;
    WaterChoice water;
    OutputOptions output;
};

void shade(const ShadeCommand& command, const CommonOptions& common) {
    require_writable(command.output);
    const std::optional<Shadows> shadows = shadows_of(command.shadows);
    const ThreadLimit threads(common.threads);
    StageClock clock;

    // The scan decides the size: a scene scanned with --size is shaded without repeating it.
    const ImageSize size = ScanFileReader(command.scan).header().size;
    Scene scene = read_scene(command.scene, size);
    if (shadows) scene.light.shadows = *shadows;
    clock.ended("read");
    Progress progress("shading", static_cast<std::size_t>(size.height), !common.quiet);
    RenderOptions options;
    options.water = water_options(command.water);
    options.extra = command.output.aov;
    options.after_rows = [&](int rows) { progress.advance(static_cast<std::size_t>(rows)); };
    RenderedPicture picture = shade_scan_file(command.scan, scene, options);
    clock.ended("shade");
    const WaterStatistics water = picture.water;
    if (water.pixels > 0) clock.note("shade.water", water.seconds);
    write_picture(command.output, scene, std::move(picture));
    clock.ended("write");

    write_statistics(command.stats, "shade", size, clock, nullptr, &water);
    tell_done(common.quiet, command.output.image, size, clock);
}

}  // namespace

void add_shade_command(CLI::App& app, const CommonOptions& common) {
    auto* const sub =
        app.add_subcommand("shade", "The paper's second process: from a scan file to a picture");
    const auto command = std::make_shared<ShadeCommand>();
    sub->add_option("SCAN", command->scan, "Scan file, made by keikan scan")->required();
    sub->add_option("SCENE", command->scene, "Scene file, for its colours, materials and lights")->required();
    sub->add_option("-o,--output", command->output.image,
                    "Picture: .png, .exr, or - for PNG on standard output")
        ->required();
    add_water_options(*sub, command->water);
    add_shadows_option(*sub, command->shadows);
    sub->add_option("--bits", command->output.bits, "Of a PNG, for each colour: 8 or 16")
        ->check(CLI::IsMember({8, 16}))
        ->capture_default_str();
    sub->add_flag("--aov", command->output.aov, "Also background, object_id, depth, flags in the .exr");
    sub->add_option("--stats", command->stats, "Write seconds per stage as JSON");
    sub->callback([command, &common] { shade(*command, common); });
}

}  // namespace keikan

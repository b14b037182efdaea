// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scan/scan_file.hpp"
#include "keikan/scan/scan_scene.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/support/parallel.hpp"
#include "keikan/support/progress.hpp"
#include "option_values.hpp"
#include "run_statistics.hpp"

namespace keikan {

namespace {

struct ScanCommand {
    std::string scene, output, size, extract = "outline", engine = "splitting", stats;
};

void scan(const ScanCommand& command, const CommonOptions& common) {
    const ThreadLimit threads(common.threads);
    StageClock clock;
    ScanOptions options;
    options.extraction = extraction_of(command.extract);
    options.engine = engine_of_scan_file(command.engine);

    const Scene scene = read_scene(command.scene, picture_size(command.size));
    clock.ended("read");
    ScanFileWriter writer(command.output, {scene.camera.size, options.extraction, scene.geometry_hash});
    const Geometry geometry = build_geometry(scene);
    clock.ended("build");
    const ProjectedFaces faces = project_faces(geometry, scene.camera);
    clock.ended("project");
    Progress progress("scanning", static_cast<std::size_t>(scene.camera.size.height), !common.quiet);
    const ScanStatistics statistics =
        scan_faces(faces, geometry, scene.camera, options, [&](const ScanBand& band) {
            writer.write(band);
            progress.advance(static_cast<std::size_t>(band.rows));
        });
    writer.finish();
    clock.ended("scan");
    clock.note("scan.bin", statistics.seconds_bin);
    clock.note("scan.divide", statistics.seconds_divide);

    write_statistics(command.stats, "scan", scene.camera.size, clock, &statistics);
    tell_done(common.quiet, command.output, scene.camera.size, clock);
}

}  // namespace

void add_scan_command(CLI::App& app, const CommonOptions& common) {
    auto* const sub = app.add_subcommand("scan", "The paper's first process: from a scene to a scan file");
    const auto command = std::make_shared<ScanCommand>();
    sub->add_option("SCENE", command->scene, "Scene file (docs/scene.md)")->required();
    sub->add_option("-o,--output", command->output, "Scan file (docs/scan_file.md)")->required();
    sub->add_option("--size", command->size, "WIDTHxHEIGHT instead of the scene's");
    sub->add_option("--extract", command->extract, "Which pixels are divided exactly: outline, paper")
        ->capture_default_str();
    sub->add_option("--engine", command->engine, "For visible areas: splitting, traversal")
        ->capture_default_str();
    sub->add_option("--stats", command->stats, "Write seconds per stage and counts as JSON");
    sub->callback([command, &common] { scan(*command, common); });
}

}  // namespace keikan

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <memory>

#include "commands.hpp"
#include "crosscheck/left_out_check.hpp"
#include "crosscheck/scene_check.hpp"
#include "keikan/render/shade.hpp"
#include "keikan/scan/scan_scene.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "keikan/support/progress.hpp"
#include "picture_size.hpp"
#include "report/scene_report.hpp"
#include "report_page.hpp"
#include "verdict.hpp"

namespace keikan {
namespace {

struct SceneCommand {
    std::string scene, size, pixels = "all", engine = "splitting", extract = "outline", report;
    std::uint64_t left_out_one_in = 4;
};

Extraction extraction_of(const std::string& text) {
    if (text == "outline") return Extraction::Outline;
    if (text == "paper") return Extraction::Paper;
    throw InputError("--extract " + text + ": there are only: outline, paper");
}

bool flagged_only_of(const std::string& text) {
    if (text == "all") return false;
    if (text == "flagged") return true;
    throw InputError("--pixels " + text + ": there are only: all, flagged");
}

/// Scans the picture, and checks and paints each band as it comes.
crosscheck::CheckSummary check_bands(const ProjectedFaces& faces, const Geometry& geometry,
                                     const Scene& scene, const ScanOptions& scan,
                                     crosscheck::SceneCheck& check, report::SceneLayers* layers,
                                     Image<Rgb>& picture, Progress& progress) {
    scan_faces(faces, geometry, scene.camera, scan, [&](const ScanBand& band) {
        check.take(band);
        if (layers) {
            layers->take(band);
            shade_band(band, scene, picture);
        }
        progress.advance(static_cast<std::size_t>(band.rows));
    });
    return check.finish();
}

report::Page page_of(const SceneCommand& command, const CommonOptions& common, const std::string& summary) {
    report::Page page = page_of("scene", common);
    page.subject = command.scene;
    page.scene = shell_word(command.scene);
    page.size = command.size;
    page.engine = command.engine;
    page.summary = summary;
    return page;
}

void scene(const SceneCommand& command, CommonOptions& common) {
    ScanOptions scan;
    scan.extraction = extraction_of(command.extract);
    crosscheck::SceneCheckOptions options;
    options.flagged_only = flagged_only_of(command.pixels);
    options.spans_are_exact = scan.extraction == Extraction::Outline;
    options.engine = engine_of(command.engine);
    options.seed = common.seed;
    const bool reported = !command.report.empty();
    options.kinds = reported;
    if (reported) report::make_report_folder(command.report);
    const ThreadLimit threads(common.threads);
    const auto start = std::chrono::steady_clock::now();

    const Scene read = read_scene(command.scene, picture_size(command.size));
    const Geometry geometry = build_geometry(read);
    const ProjectedFaces faces = project_faces(geometry, read.camera);
    const ImageSize size = read.camera.size;
    Progress progress("verifying", static_cast<std::size_t>(size.height), !common.quiet);
    crosscheck::SceneCheck check(faces, geometry, size, options);
    Image<Rgb> picture(reported ? size : ImageSize{});
    report::SceneLayers layers(faces, geometry, reported ? size : ImageSize{});
    crosscheck::CheckSummary summary =
        check_bands(faces, geometry, read, scan, check, reported ? &layers : nullptr, picture, progress);
    crosscheck::check_left_out(faces, project_faces(geometry, read.camera, HiddenBacks::Kept), size,
                               common.seed, command.left_out_one_in, summary);
    summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    const std::string json =
        crosscheck::summary_json(summary, options.spans_are_exact ? nullptr : &check.unflagged());
    if (reported)
        report::write_scene_report(command.report, page_of(command, common, json),
                                   {faces, check, summary, options, layers, picture});
    const std::string sized = command.size.empty() ? "" : " --size " + command.size;
    tell_verdict(summary, json, common, [&](const crosscheck::Disagreement& d) {
        return fmt::format("keikan pixel {} --at {},{}{} | keikan-verify areas -", shell_word(command.scene),
                           d.pixel.x, d.pixel.y, sized);
    });
}

}  // namespace

void add_scene_command(CLI::App& app, CommonOptions& common) {
    auto* const sub =
        app.add_subcommand("scene", "Every pixel of a scene: visible areas, float against exact");
    const auto command = std::make_shared<SceneCommand>();
    sub->add_option("SCENE", command->scene, "Scene file (docs/scene.md)")->required();
    sub->add_option("--size", command->size, "WIDTHxHEIGHT instead of the scene's");
    sub->add_option("--pixels", command->pixels, "Which are checked: all, flagged")->capture_default_str();
    sub->add_option("--engine", command->engine, "For visible areas: splitting, traversal, published")
        ->capture_default_str();
    sub->add_option("--extract", command->extract, "Which pixels are divided exactly: outline, paper")
        ->capture_default_str();
    sub->add_option("--left-out-one-in", command->left_out_one_in,
                    "Of the pixels with faces that are never asked about, one in so many is asked about them")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40))
        ->capture_default_str();
    sub->add_option(
        "--report", command->report,
        "Folder for the page of the pixel inspector, the picture, its errors, the flags and the summary");
    sub->callback([command, &common] { scene(*command, common); });
}

}  // namespace keikan

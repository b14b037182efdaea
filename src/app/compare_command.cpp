// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>

#include "commands.hpp"
#include "keikan/baseline/method.hpp"
#include "keikan/compare/comparison.hpp"
#include "keikan/compare/report.hpp"
#include "keikan/compare/sequence.hpp"
#include "keikan/image/exr_file.hpp"
#include "keikan/image/png_file.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "keikan/support/progress.hpp"
#include "option_values.hpp"
#include "water_choice.hpp"

namespace keikan {

namespace {

constexpr const char* kAllMethods =
    "kato,kato:paper,none,multiscan:4,multiscan:11,orthogonal:4,catmull,grid:16,random:16";

struct CompareCommand {
    std::string scene, folder, size, methods = kAllMethods, reference, inset, shadows;
    int repeat = 3, search_to = 4096, frames = 0, reference_samples = 512;
    double step_m = 0.05;
    WaterChoice water;
};

std::vector<baseline::Method> methods_of(const std::string& list) {
    std::vector<baseline::Method> methods;
    std::istringstream names(list);
    for (std::string name; std::getline(names, name, ',');) {
        try {
            methods.push_back(baseline::method_of(name));
        } catch (const InputError& error) {
            throw InputError(std::string("--methods: ") + error.what());
        }
        if (std::count(methods.begin(), methods.end(), methods.back()) > 1)
            throw InputError("--methods: '" + name + "' stands there twice");
    }
    if (methods.empty()) throw InputError("--methods: names no method");
    return methods;
}

Image<Rgb> reference_picture(const std::string& file, ImageSize size) {
    Image<Rgb> picture;
    if (std::filesystem::path(file).extension() == ".exr") {
        const ExrPicture exr = read_exr(file);
        for (const char* const channel : {"R", "G", "B"})
            if (!exr.channels.contains(channel))
                throw InputError(file, "", std::string("has no channel ") + channel);
        picture = rgb_image(exr);
    } else {
        picture = read_png(file);
    }
    if (picture.size() != size)
        throw InputError(file, "",
                         "is " + std::to_string(picture.width()) + "x" + std::to_string(picture.height()) +
                             ", the scene is " + std::to_string(size.width) + "x" +
                             std::to_string(size.height));
    return picture;
}

/// The folder is made where it is missing, and must be writable, before any work is done.
void require_folder(const std::string& folder) {
    std::error_code trouble;
    std::filesystem::create_directory(folder, trouble);
    if (trouble || !std::filesystem::is_directory(folder))
        throw InputError(folder, "", "cannot be made: " + (trouble ? trouble.message() : "it is no folder"));
    const AtomicFile probe(std::filesystem::path(folder) / "compare.json");  // unfinished: leaves nothing
}

void compare_scene(const CompareCommand& command, const CommonOptions& common) {
    compare::ComparisonOptions options;
    options.methods = methods_of(command.methods);
    options.repeat = command.repeat;
    options.seed = static_cast<std::uint32_t>(common.seed);
    options.water = water_options(command.water);
    options.reference_samples = command.reference_samples;
    options.search_to = command.search_to;
    const std::optional<Shadows> shadows = shadows_of(command.shadows);
    const ThreadLimit threads(common.threads);
    Scene scene = read_scene(command.scene, picture_size(command.size));
    if (shadows) scene.light.shadows = *shadows;
    compare::ReportOptions report;
    if (!command.inset.empty()) report.inset = pixel_of(command.inset, scene.camera.size, "--inset");
    if (!command.reference.empty())
        options.reference = reference_picture(command.reference, scene.camera.size);
    require_folder(command.folder);
    const Geometry geometry = build_geometry(scene);

    // How many steps the searches take is not known: the bar counts what is.
    Progress progress("comparing",
                      options.methods.size() * static_cast<std::size_t>(command.repeat + command.frames) + 1,
                      !common.quiet);
    options.tell = [&](const std::string& doing) {
        progress.note(doing);
        progress.advance();
    };
    const compare::Comparison comparison = compare::compare_methods(scene, geometry, options);
    std::optional<compare::Sequence> sequence;
    if (command.frames > 0)
        sequence = compare::render_sequence(
            scene, geometry,
            {options.methods, command.frames, command.step_m, options.seed, options.water, options.tell});
    const std::string name = scene.file.stem().string();
    compare::write_comparison(command.folder, name, comparison, sequence, report);
    write_whole_file("-", compare::comparison_table(name, comparison, sequence));
    compare::require_exact(comparison);
}

}  // namespace

void add_compare_command(CLI::App& app, const CommonOptions& common) {
    auto* const sub =
        app.add_subcommand("compare", "Methods against each other and exact truth (docs/results.md)");
    const auto command = std::make_shared<CompareCommand>();
    sub->add_option("SCENE", command->scene, "Scene file (docs/scene.md)")->required();
    sub->add_option("-o,--output", command->folder,
                    "Folder for compare.json, table.md, plot.svg and pictures; made where it is missing")
        ->required();
    sub->add_option("--methods", command->methods,
                    "kato, kato:paper, none, multiscan:N, orthogonal:N, catmull, grid:N, random:N")
        ->capture_default_str();
    sub->add_option("--size", command->size, "WIDTHxHEIGHT instead of the scene's");
    sub->add_option("--reference", command->reference,
                    "Picture to measure against: .exr, .png (default: exact areas, water by many samples)");
    sub->add_option("--reference-samples", command->reference_samples,
                    "Of water, in a pixel of the default reference")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    sub->add_option("--repeat", command->repeat, "Turns; seconds are their medians")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    sub->add_option("--search-to", command->search_to, "Largest N of the searches for equal quality; 0: none")
        ->check(CLI::Range(0, baseline::kMostSamples))
        ->capture_default_str();
    sub->add_option("--frames", command->frames, "Also a sequence of so many frames: how conductors flicker")
        ->check(CLI::Range(0, 10000));
    sub->add_option("--step", command->step_m, "Metres that the camera moves from frame to frame")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    sub->add_option(
        "--inset", command->inset,
        "X,Y: upper left corner of the part that is enlarged (default: where most conductors are)");
    add_water_options(*sub, command->water);
    add_shadows_option(*sub, command->shadows);
    sub->callback([command, &common] { compare_scene(*command, common); });
}

}  // namespace keikan

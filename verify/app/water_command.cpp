// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "convergence/water_convergence.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "picture_size.hpp"

namespace keikan {
namespace {

constexpr ImageSize kDefaultWindow{64, 40};

struct WaterCommand {
    std::string scene, size, window;
    convergence::WaterCheckOptions options;
};

/// "X,Y,WIDTHxHEIGHT" within the picture.
PixelWindow window_of(const std::string& text, ImageSize size) {
    int numbers[4] = {};
    const char* at = text.data();
    const char* const end = at + text.size();
    bool good = true;
    for (int i = 0; good && i < 4; ++i) {
        const auto read = std::from_chars(at, end, numbers[i]);
        good =
            read.ec == std::errc() && (i == 3 ? read.ptr == end : read.ptr != end && *read.ptr == ",,x"[i]);
        at = read.ptr + 1;
    }
    if (!good) throw InputError("--window: '" + text + "' is not X,Y,WIDTHxHEIGHT, such as 400,500,64x40");
    const PixelWindow w{numbers[0], numbers[1], numbers[2], numbers[3]};
    const bool inside = w.x >= 0 && w.y >= 0 && w.width > 0 && w.height > 0 && w.width <= size.width - w.x &&
                        w.height <= size.height - w.y;
    if (!inside)
        throw InputError(
            fmt::format("--window: {} is not within the picture of {}x{}", text, size.width, size.height));
    return w;
}

void water(WaterCommand command, CommonOptions& common) {
    const ThreadLimit threads(common.threads);
    const auto start = std::chrono::steady_clock::now();
    const Scene scene = read_scene(command.scene, picture_size(command.size));
    const Geometry geometry = build_geometry(scene);
    if (command.window.empty()) {
        const auto window = convergence::window_of_water(scene, geometry, kDefaultWindow);
        if (!window) throw InputError(command.scene, "", "shows no water with a surface");
        command.options.window = *window;
    } else {
        command.options.window = window_of(command.window, scene.camera.size);
    }
    command.options.seed = static_cast<std::uint32_t>(common.seed);
    const convergence::WaterReport report = convergence::check_water(scene, geometry, command.options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    common.pass = report.pass();
    const std::string json = convergence::report_json(report, seconds);
    if (!common.json.empty() && common.json != "-") write_whole_file(common.json, json + "\n");
    fmt::print("{}\n", json);
    std::fflush(stdout);
    if (common.quiet) return;
    fmt::print(stderr,
               "{}{}: {} pixels of water in {},{},{}x{}; error {:.2f} of {:g} asked for, {:.2f} of random "
               "points'; {} "
               "missed; waves taken for slopes: {:.2f}; {:.1f} s\n",
               convergence::report_table(report), report.pass() ? "pass" : "FAIL", report.pixels,
               report.window.x, report.window.y, report.window.width, report.window.height,
               report.adaptive.rmse, report.asked_error, report.adaptive.rmse / report.random.rmse,
               report.missed(), report.filter_rmse, seconds);
}

}  // namespace

void add_water_command(CLI::App& app, CommonOptions& common) {
    auto* const sub =
        app.add_subcommand("water", "A scene's water against itself with thousands of samples a pixel");
    const auto command = std::make_shared<WaterCommand>();
    auto& options = command->options;
    sub->add_option("SCENE", command->scene, "Scene file (docs/scene.md)")->required();
    sub->add_option("--size", command->size, "WIDTHxHEIGHT instead of the scene's");
    sub->add_option(
        "--window", command->window,
        "X,Y,WIDTHxHEIGHT: the pixels that are looked at (default: 64x40 in the middle of the water)");
    sub->add_option("--reference", options.reference_samples, "Samples a pixel of the reference")
        ->check(CLI::Range(16, 1 << 20))
        ->capture_default_str();
    sub->add_option("--water-error", options.error,
                    "What the adaptive method is asked for, in codes of 8 bits")
        ->check(CLI::Range(0.01, 255.0))
        ->capture_default_str();
    sub->add_option("--kw", options.k_w, "The paper's k_w, one or several")
        ->delimiter(',')
        ->check(CLI::Range(0.0, 1e9));
    sub->add_option("--kr", options.k_r, "The paper's k_r, one or several")
        ->delimiter(',')
        ->check(CLI::Range(0.0, 1e6));
    sub->add_option("--paper-most", options.paper_most, "Most samples of a pixel of the paper's mode")
        ->check(CLI::Range(2, 1 << 20))
        ->capture_default_str();
    sub->callback([command, &common] { water(*command, common); });
}

}  // namespace keikan

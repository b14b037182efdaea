// SPDX-License-Identifier: Apache-2.0
#include "water_choice.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "keikan/support/input_error.hpp"

namespace keikan {

void add_water_options(CLI::App& command, WaterChoice& choice) {
    command
        .add_option(
            "--water", choice.mode,
            "Samples of water: variance (as many as --water-error asks for), paper (equations 1 to 3), "
            "fixed, flat (none)")
        ->capture_default_str();
    command
        .add_option("--water-error", choice.error, "Standard error of a pixel of water, in codes of 8 bits")
        ->check(CLI::Range(0.01, 255.0))
        ->capture_default_str();
    command
        .add_option("--water-most", choice.most,
                    "Most samples of a pixel of water (default: 256; paper: 1024)")
        ->check(CLI::Range(2, 1 << 20));
    command.add_option("--water-fixed", choice.fixed, "With --water fixed: samples of a pixel")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    command
        .add_option("--water-sampler", choice.sampler,
                    "With --water fixed: sobol, jittered, haber, paper, random")
        ->capture_default_str();
    command.add_option("--kw", choice.k_w, "With --water paper: k_w of equation (1)")
        ->check(CLI::Range(0.0, 1e9))
        ->capture_default_str();
    command.add_option("--kr", choice.k_r, "With --water paper: k_r of equation (3)")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    command.add_flag("--water-all-waves", choice.trace_all_waves,
                     "Trace waves that are smaller than a pixel, too, instead of taking them for slopes");
    command
        .add_option("--mixed", choice.mixed,
                    "Pixels that hold water and other things: exact, paper (all water)")
        ->capture_default_str();
}

WaterOptions water_options(const WaterChoice& choice) {
    WaterOptions options;
    if (choice.mode == "variance")
        options.mode = WaterMode::Variance;
    else if (choice.mode == "paper")
        options.mode = WaterMode::Paper;
    else if (choice.mode == "fixed")
        options.mode = WaterMode::Fixed;
    else if (choice.mode == "flat")
        options.mode = WaterMode::Flat;
    else
        throw InputError("--water: '" + choice.mode + "' is none of variance, paper, fixed, flat");
    if (choice.mixed == "paper")
        options.mixed = MixedPixels::Paper;
    else if (choice.mixed != "exact")
        throw InputError("--mixed: '" + choice.mixed + "' is neither 'exact' nor 'paper'");
    try {
        options.fixed_sampler = sampler_of(choice.sampler);
    } catch (const InputError& error) {
        throw InputError(std::string("--water-sampler: ") + error.what());
    }
    options.error = choice.error;
    options.fixed = choice.fixed;
    options.filter = !choice.trace_all_waves;
    options.paper.k_w = choice.k_w;
    options.paper.k_r = choice.k_r;
    if (choice.most > 0) {
        options.most = choice.most;
        options.paper.most = choice.most;
        options.least = std::min(options.least, choice.most);
    }
    return options;
}

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "keikan/render/water_options.hpp"

namespace CLI {
class App;
}

namespace keikan {

/// What the command line says of water.
struct WaterChoice {
    std::string mode = "variance", mixed = "exact", sampler = "sobol";
    double error = WaterOptions{}.error;
    int most = 0, fixed = WaterOptions{}.fixed;
    double k_w = PaperSampleCounts{}.k_w, k_r = PaperSampleCounts{}.k_r;
    bool trace_all_waves = false;
};

/// Adds --water and its companions to a command that draws pictures.
void add_water_options(CLI::App& command, WaterChoice& choice);

/// Errors: InputError naming the option.
WaterOptions water_options(const WaterChoice& choice);

}  // namespace keikan

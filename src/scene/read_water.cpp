// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <vector>

#include "degree.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/wave/wind_sea.hpp"
#include "scene_blocks.hpp"

namespace keikan {
namespace {

/// A compass bearing (0 north, 90 east) as an angle from +x towards +y.
double angle_of_bearing(double bearing_deg) {
    return (90 - bearing_deg) * kDegree;
}

WindSea read_wind(const JsonNode& node, double depth_m) {
    JsonObject object(node);
    WindSea sea;
    sea.depth_m = depth_m;
    sea.wind_speed_m_s = object.required("speed_m_s").number(between(0.5, 60));
    sea.wind_direction_rad = angle_of_bearing(object.required("from_deg").number(between(-360, 360)) + 180);
    sea.fetch_m = object.number_or("fetch_m", sea.fetch_m, between(1, 1e7));
    sea.count = object.integer_or("waves", sea.count, 1, static_cast<int>(WaveSurface::kMostWaves));
    sea.shortest_m = object.number_or("shortest_m", sea.shortest_m, between(0.005, 1e4));
    sea.seed = static_cast<std::uint32_t>(
        object.integer_or("seed", static_cast<int>(sea.seed), 0, std::numeric_limits<int>::max()));
    object.no_other_keys();
    return sea;
}

std::vector<StokesWave> read_waves(const JsonNode& node) {
    std::vector<StokesWave> waves(node.array_size(0, WaveSurface::kMostWaves));
    for (std::size_t i = 0; i < waves.size(); ++i) {
        JsonObject object(node.item(i));
        waves[i].amplitude_m = object.required("amplitude_m").number(between(0, 100));
        waves[i].length_m = object.required("length_m").number(positive_up_to(1e5));
        waves[i].direction_rad = angle_of_bearing(object.required("towards_deg").number(between(-360, 360)));
        waves[i].phase_rad = object.number_or("phase_deg", 0, between(-360, 360)) * kDegree;
        object.no_other_keys();
    }
    return waves;
}

/// Mean square slope of all waves of a surface.
double slope_variance(const WaveSurface& waves) {
    double sum = 0;
    for (std::size_t i = 0; i < waves.size(); ++i) sum += waves.slope_variance(i);
    return sum;
}

}  // namespace

WaterSurface read_water_surface(const JsonNode& node, double level_m) {
    JsonObject object(node);
    WaterSurface water;
    water.level_m = level_m;
    if (const auto depth = object.optional("depth_m")) water.depth_m = depth->number(positive_up_to(1e5));
    const int order = object.integer_or("order", kStokesOrders, 1, kStokesOrders);
    const double time_s = object.number_or("time_s", 0, between(-1e6, 1e6));
    const bool windy = object.exactly_one_of({"wind", "waves"}) == "wind";
    const JsonNode source = object.required(windy ? "wind" : "waves");
    try {
        if (windy) {
            const WindSea sea = read_wind(source, water.depth_m);
            water.waves = WaveSurface(wind_sea(sea), order, water.depth_m, time_s);
            // What the wind's waves lack of the slopes that were measured at sea.
            water.ripple_variance =
                std::max(water.ripple_variance,
                         cox_munk_slope_variance(sea.wind_speed_m_s) - slope_variance(water.waves));
        } else {
            water.waves = WaveSurface(read_waves(source), order, water.depth_m, time_s);
        }
    } catch (const InputError& error) {
        // A complaint of a key names its place already; one about waves does not know it.
        if (std::string(error.what()).starts_with(node.file())) throw;
        source.fail(error.what());
    }
    water.ripple_variance = object.number_or("ripple_variance", water.ripple_variance, between(0, 1));
    water.absorption_per_m = object.colour_or("absorption_per_m", water.absorption_per_m);
    water.scattering_per_m = object.colour_or("scattering_per_m", water.scattering_per_m);
    water.bed = object.colour_or("bed_colour", water.bed);
    object.no_other_keys();
    return water;
}

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#include "run_statistics.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "keikan/support/atomic_file.hpp"
#include "keikan/support/parallel.hpp"

namespace keikan {

void StageClock::ended(const std::string& stage) {
    const Clock::time_point now = Clock::now();
    note(stage, std::chrono::duration<double>(now - last_).count());
    last_ = now;
    const std::clock_t spent = std::clock();
    processor_stages_.emplace_back(stage, static_cast<double>(spent - last_spent_) / CLOCKS_PER_SEC);
    last_spent_ = spent;
}

double StageClock::total() const {
    return std::chrono::duration<double>(Clock::now() - begin_).count();
}

void write_statistics(const std::string& file, const std::string& command, ImageSize size,
                      const StageClock& clock, const ScanStatistics* scan, const WaterStatistics* water) {
    if (file.empty()) return;
    nlohmann::ordered_json json;
    json["command"] = command;
    json["size"] = {size.width, size.height};
    json["threads"] = thread_count();
    for (const auto& [stage, seconds] : clock.stages()) json["seconds"][stage] = seconds;
    json["seconds"]["total"] = clock.total();
    for (const auto& [stage, seconds] : clock.processor_stages()) json["processor_seconds"][stage] = seconds;
    if (scan != nullptr) {
        json["pixels"] = std::int64_t{size.width} * size.height;
        json["flagged_pixels"] = scan->divided_pixels;
        json["scanline_pixels"] = scan->scanline_pixels;
        json["multi_object_pixels"] = scan->multi_object_pixels;
        json["polygons"] = scan->faces;
        json["parts"] = scan->parts;
        json["samples"] = scan->samples;
    }
    if (water != nullptr && water->pixels > 0) {
        const auto pixels = static_cast<double>(water->pixels);
        json["samples"] = json["samples"].get<std::uint64_t>() + water->samples;
        nlohmann::ordered_json& own = json["water"];
        own["pixels"] = water->pixels;
        own["mixed_pixels"] = water->mixed_pixels;
        own["samples_per_pixel"] = static_cast<double>(water->samples) / pixels;
        own["measuring_samples"] = water->measuring_samples;
        own["most_samples"] = water->most_samples;
        own["histogram_by_powers_of_2"] = water->histogram;
        own["face_rays"] = water->face_rays;
        own["wave_rays"] = water->wave_rays;
        own["wave_steps"] = water->wave_steps;
        own["missed"] = water->missed;
        own["seconds"] = water->seconds;
        own["rays_per_second"] = static_cast<double>(water->wave_rays + water->face_rays) / water->seconds;
    }
    write_whole_file(file, json.dump(2) + "\n");
}

void tell_done(bool quiet, const std::string& file, ImageSize size, const StageClock& clock) {
    if (quiet) return;
    fmt::print(stderr, "keikan: wrote {}, {}x{} pixels, in {:.2f} s\n",
               file == "-" ? "standard output" : file, size.width, size.height, clock.total());
}

}  // namespace keikan

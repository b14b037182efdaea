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
}

double StageClock::total() const {
    return std::chrono::duration<double>(Clock::now() - begin_).count();
}

void write_statistics(const std::string& file, const std::string& command, ImageSize size,
                      const StageClock& clock, const ScanStatistics* scan) {
    if (file.empty()) return;
    nlohmann::ordered_json json;
    json["command"] = command;
    json["size"] = {size.width, size.height};
    json["threads"] = thread_count();
    for (const auto& [stage, seconds] : clock.stages()) json["seconds"][stage] = seconds;
    json["seconds"]["total"] = clock.total();
    if (scan != nullptr) {
        json["pixels"] = std::int64_t{size.width} * size.height;
        json["flagged_pixels"] = scan->divided_pixels;
        json["scanline_pixels"] = scan->scanline_pixels;
        json["multi_object_pixels"] = scan->multi_object_pixels;
        json["polygons"] = scan->faces;
        json["parts"] = scan->parts;
        json["samples"] = 0;  // areas are exact: nothing is sampled
    }
    write_whole_file(file, json.dump(2) + "\n");
}

void tell_done(bool quiet, const std::string& file, ImageSize size, const StageClock& clock) {
    if (quiet) return;
    fmt::print(stderr, "keikan: wrote {}, {}x{} pixels, in {:.2f} s\n",
               file == "-" ? "standard output" : file, size.width, size.height, clock.total());
}

}  // namespace keikan

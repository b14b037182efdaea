// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "keikan/render/water_options.hpp"
#include "keikan/scan/scan_scene.hpp"

namespace keikan {

/// Seconds of each stage of a run, in the order of the flow.
class StageClock {
  public:
    /// The stage since the last call (or since the clock was made) was this one.
    void ended(const std::string& stage);
    /// A part of a stage that measures itself.
    void note(const std::string& stage, double seconds) { stages_.emplace_back(stage, seconds); }
    double total() const;
    const std::vector<std::pair<std::string, double>>& stages() const { return stages_; }
    /// Of all threads together, of the stages that `ended`.
    const std::vector<std::pair<std::string, double>>& processor_stages() const { return processor_stages_; }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_ = begin_;
    std::clock_t last_spent_ = std::clock();
    std::vector<std::pair<std::string, double>> stages_, processor_stages_;
};

/// Writes the statistics of a run as JSON (--stats); does nothing for an empty name.
/// Errors: InputError naming the file.
void write_statistics(const std::string& file, const std::string& command, ImageSize size,
                      const StageClock& clock, const ScanStatistics* scan,
                      const WaterStatistics* water = nullptr);

/// Tells on standard error what a run has made, in one line.
void tell_done(bool quiet, const std::string& file, ImageSize size, const StageClock& clock);

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace keikan {

/// A progress bar on standard error: drawn only where that is a terminal and `wanted`, at most ten times a
/// second, and wiped when it ends. Otherwise it does nothing at all. May be advanced from any thread.
class Progress {
  public:
    Progress(std::string what, std::size_t total, bool wanted);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void advance(std::size_t steps = 1) { to_at_least(steps, true); }
    /// Says that `done` steps of the total are done; going back is ignored.
    void reach(std::size_t done) { to_at_least(done, false); }
    /// Says `text` behind the bar from the next step on.
    void note(std::string text);

  private:
    void to_at_least(std::size_t steps, bool relative);
    void draw() const;

    std::string what_;
    std::string note_;
    std::size_t total_;
    bool shown_;
    std::size_t done_ = 0;
    std::chrono::steady_clock::time_point next_draw_;
    std::mutex mutex_;
};

}  // namespace keikan

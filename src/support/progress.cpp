// SPDX-License-Identifier: Apache-2.0
#include "keikan/support/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace keikan {

namespace {
constexpr std::chrono::milliseconds kRedrawAfter(100);
constexpr std::size_t kBarWidth = 40;
}  // namespace

Progress::Progress(std::string what, std::size_t total, bool wanted)
    : what_(std::move(what)),
      total_(total),
      shown_(wanted && total > 0 && isatty(STDERR_FILENO) == 1),
      next_draw_(std::chrono::steady_clock::now() + kRedrawAfter) {}

Progress::~Progress() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::to_at_least(std::size_t steps, bool relative) {
    if (!shown_) return;
    const std::lock_guard lock(mutex_);
    done_ = std::min(total_, relative ? done_ + steps : std::max(done_, steps));
    const auto now = std::chrono::steady_clock::now();
    if (now < next_draw_) return;
    next_draw_ = now + kRedrawAfter;
    draw();
}

void Progress::note(std::string text) {
    const std::lock_guard lock(mutex_);
    note_ = std::move(text);
}

void Progress::draw() const {
    const std::size_t filled = kBarWidth * done_ / total_;
    const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
    std::fprintf(stderr, "\r%s [%s] %3zu %% %s\033[K", what_.c_str(), bar.c_str(), 100 * done_ / total_,
                 note_.c_str());
    std::fflush(stderr);
}

}  // namespace keikan

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <ctime>
#include <exception>
#include <memory>
#include <new>
#include <span>
#include <system_error>

#include "peers/contestant.hpp"

namespace keikan::peers {
namespace {

constexpr rlim_t kMostMemory = rlim_t{4} << 30;
constexpr std::size_t kReasonLength = 240;
/// Pixels between two looks at the processor's clock, which costs as much as a tenth of a fast pixel.
constexpr std::size_t kTimedTogether = 32;

struct Slot {
    Outcome outcome = Outcome::NotAsked;
    char reason[kReasonLength] = {};
    std::size_t first_number = 0;  ///< where its areas, and then its background, stand among the numbers
};

/// What the process that asks and the one that answers both see.
struct Board {
    std::atomic<std::size_t> done = 0;  ///< questions ended
    double seconds = 0;
    std::size_t timed_pixels = 0;
};

/// Memory shared with processes forked after it was made.
class SharedMemory {
  public:
    explicit SharedMemory(std::size_t bytes)
        : bytes_(bytes),
          start_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
        if (start_ == MAP_FAILED) throw std::bad_alloc();
    }
    ~SharedMemory() { munmap(start_, bytes_); }
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;
    void* start() const { return start_; }

  private:
    std::size_t bytes_;
    void* start_;
};

/// A batch on its way through forked processes.
class ForkedRound {
  public:
    ForkedRound(const Peer& peer, const Batch& batch, const Watchdog& watchdog, int& hangs)
        : peer_(peer), batch_(batch), watchdog_(watchdog), hangs_(hangs), memory_(bytes_for(batch)) {
        board_ = new (memory_.start()) Board;
        Slot* const slots = reinterpret_cast<Slot*>(board_ + 1);
        std::uninitialized_default_construct_n(slots, batch.cases.size());
        slots_ = std::span(slots, batch.cases.size());
        numbers_ = reinterpret_cast<double*>(slots + batch.cases.size());
        std::size_t number = 0;
        for (std::size_t i = 0; i < slots_.size(); ++i) {
            slots_[i].first_number = number;
            number += batch.cases[i].polygons.size() + 1;
        }
    }

    Round run() {
        while (board_->done < slots_.size() && hangs_ < watchdog_.most_hangs) run_one_process();
        Round round{{}, board_->seconds, board_->timed_pixels};
        for (const Slot& slot : slots_) round.replies.push_back(reply_in(slot));
        return round;
    }

  private:
    static std::size_t bytes_for(const Batch& batch) {
        std::size_t numbers = 0;
        for (const PixelCase& pixel_case : batch.cases) numbers += pixel_case.polygons.size() + 1;
        return sizeof(Board) + batch.cases.size() * sizeof(Slot) + numbers * sizeof(double);
    }

    void run_one_process() {
        int alive[2];  // its reading end hangs up when the process, which holds the other, is gone
        if (pipe2(alive, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
        const pid_t process = fork();
        if (process < 0) throw std::system_error(errno, std::generic_category(), "fork");
        if (process == 0) {
            answer_the_rest();
            _exit(0);
        }
        close(alive[1]);
        const bool stopped = !ends_in_time(alive[0]);
        if (stopped) kill(process, SIGKILL);
        int status = 0;
        while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
        }
        close(alive[0]);
        if (board_->done < slots_.size()) blame(stopped, status);
    }

    /// Waits until the process is gone; false when one question has taken longer than the watchdog allows.
    bool ends_in_time(int alive) const {
        using Clock = std::chrono::steady_clock;
        std::size_t seen = board_->done;
        Clock::time_point since = Clock::now();
        for (;;) {
            pollfd hang_up{alive, 0, 0};
            const int looked_every_ms = std::clamp(static_cast<int>(watchdog_.seconds * 100), 1, 100);
            if (poll(&hang_up, 1, looked_every_ms) > 0) return true;
            if (const std::size_t done = board_->done; done != seen) {
                seen = done;
                since = Clock::now();
            } else if (std::chrono::duration<double>(Clock::now() - since).count() > watchdog_.seconds) {
                return false;
            }
        }
    }

    /// The question that was being asked is the one that ended the process.
    void blame(bool stopped, int status) {
        Slot& slot = slots_[board_->done];
        std::string reason = "exited in the middle";
        if (stopped)
            reason = "stopped at the time limit";
        else if (WIFSIGNALED(status))
            reason = signal_in_words(WTERMSIG(status));
        slot.outcome = stopped ? Outcome::Hang : Outcome::Crash;
        set_reason(slot, reason.c_str());
        hangs_ += stopped;
        ++board_->done;
    }

    Reply reply_in(const Slot& slot) const {
        Reply reply{slot.outcome, slot.reason, {}};
        if (slot.outcome != Outcome::Answered) return reply;
        const double* const first = numbers_ + slot.first_number;
        const std::size_t faces =
            batch_.cases[static_cast<std::size_t>(&slot - slots_.data())].polygons.size();
        reply.answer = {std::vector<double>(first, first + faces), first[faces]};
        return reply;
    }

    // What follows runs in the forked process.

    [[gnu::noinline]] void answer_the_rest() {
        live_modestly();
        Ask ask;
        try {
            ask = peer_.start();
        } catch (...) {
            _exit(1);
        }
        Answer answer;
        std::size_t timed_from = board_->done;
        double clock = processor_seconds();
        for (std::size_t i = board_->done; i < slots_.size(); ++i) {
            answer_one(i, ask, answer);
            board_->done = i + 1;
            if (i + 1 - timed_from < kTimedTogether && i + 1 < slots_.size()) continue;
            const double now = processor_seconds();
            board_->seconds += now - clock;
            board_->timed_pixels += asked_between(timed_from, i + 1);
            timed_from = i + 1;
            clock = now;
        }
    }

    std::size_t asked_between(std::size_t begin, std::size_t end) const {
        return static_cast<std::size_t>(
            std::ranges::count_if(slots_.subspan(begin, end - begin),
                                  [](const Slot& s) { return s.outcome != Outcome::NotAsked; }));
    }

    void answer_one(std::size_t i, const Ask& ask, Answer& answer) {
        const PreparedPixel& pixel = batch_.prepared[i];
        Slot& slot = slots_[i];
        if (pixel.nearness == Nearness::ByDepth && !peer_.by_depth) return;
        try {
            ask(pixel, answer);
            slot.outcome = Outcome::Answered;
        } catch (const std::exception& error) {
            slot.outcome = Outcome::Exception;
            set_reason(slot, error.what());
        } catch (...) {
            slot.outcome = Outcome::Exception;
            set_reason(slot, "threw something that is no std::exception");
        }
        if (slot.outcome == Outcome::Answered) store(answer, slot, pixel.faces.size());
    }

    void store(const Answer& answer, Slot& slot, std::size_t faces) {
        const bool sound = answer.areas.size() == faces && std::isfinite(answer.background) &&
                           std::ranges::all_of(answer.areas, [](double a) { return std::isfinite(a); });
        if (!sound) {
            slot.outcome = Outcome::Exception;
            set_reason(slot, "an area is missing or not finite");
            return;
        }
        std::ranges::copy(answer.areas, numbers_ + slot.first_number);
        numbers_[slot.first_number + faces] = answer.background;
    }

    static void live_modestly() {
        const rlimit no_core{0, 0};
        setrlimit(RLIMIT_CORE, &no_core);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they reserve more than that
        const rlimit memory{kMostMemory, kMostMemory};
        setrlimit(RLIMIT_AS, &memory);
#endif
        const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
    }

    static double processor_seconds() {
        timespec now{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    }

    static void set_reason(Slot& slot, const char* reason) {
        std::strncpy(slot.reason, reason, kReasonLength - 1);
    }

    const Peer& peer_;
    const Batch& batch_;
    const Watchdog& watchdog_;
    int& hangs_;
    SharedMemory memory_;
    Board* board_ = nullptr;
    std::span<Slot> slots_;
    double* numbers_ = nullptr;
};

}  // namespace

Contestant in_a_fork(const Peer& peer, const Watchdog& watchdog) {
    const auto ask = [peer, watchdog, hangs = std::make_shared<int>(0)](const Batch& batch) {
        return ForkedRound(peer, batch, watchdog, *hangs).run();
    };
    return {peer.name, peer.version, !peer.by_depth, {}, ask};
}

std::string signal_in_words(int signal) {
    const char* const name = strsignal(signal);
    return "signal " + std::to_string(signal) + (name ? std::string(" (") + name + ")" : "");
}

}  // namespace keikan::peers

// SPDX-License-Identifier: Apache-2.0
// The contract of parallel.hpp once more, on std::thread, for builds under the thread sanitizer. oneTBB as it
// is installed is not built with the sanitizer, which cannot see how it hands work over and reports races
// where there are none. Here every hand-over is seen, so a race in the work that the rooms give us is found.
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "keikan/support/parallel.hpp"

namespace keikan {

struct ThreadLimit::Control {
    int threads = 1;
    Control* outer = nullptr;

    static std::atomic<Control*>& innermost() {
        static std::atomic<Control*> control = nullptr;
        return control;
    }
};

ThreadLimit::ThreadLimit(int threads) : control_(std::make_unique<Control>()) {
    const int machine = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    control_->threads = threads > 0 ? threads : machine;
    control_->outer = Control::innermost().exchange(control_.get());
}

ThreadLimit::~ThreadLimit() {
    Control::innermost().store(control_->outer);
}

int thread_count() {
    if (const ThreadLimit::Control* control = ThreadLimit::Control::innermost().load())
        return control->threads;
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

namespace {

thread_local bool inside_team = false;

/// Runs `member` in thread_count() threads at a time, the caller among them; throws again what the first
/// threw.
template <typename Member>
void run_team(const Member& member) {
    std::exception_ptr thrown;
    std::mutex guard;
    const auto body = [&] {
        const bool outer = std::exchange(inside_team, true);
        try {
            member();
        } catch (...) {
            const std::lock_guard lock(guard);
            if (!thrown) thrown = std::current_exception();
        }
        inside_team = outer;
    };
    std::vector<std::thread> others;
    for (int i = 1; i < thread_count(); ++i) others.emplace_back(body);
    body();
    for (std::thread& other : others) other.join();
    if (thrown) std::rethrow_exception(thrown);
}

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work) {
    parallel_ranges(count, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) work(i);
    });
}

void parallel_ranges(std::size_t count, std::size_t grain,
                     const std::function<void(std::size_t begin, std::size_t end)>& work) {
    if (count == 0) return;
    grain = std::max<std::size_t>(grain, 1);
    if (thread_count() == 1 || count <= grain || inside_team) return work(0, count);
    const std::size_t pieces = count / grain;
    std::atomic<std::size_t> next = 0;
    run_team([&] {
        for (std::size_t piece = next++; piece < pieces; piece = next++)
            work(piece * grain, piece + 1 == pieces ? count : (piece + 1) * grain);
    });
}

void parallel_in_order(std::size_t count, std::size_t in_flight,
                       const std::function<void(std::size_t i, std::size_t slot)>& make,
                       const std::function<void(std::size_t i, std::size_t slot)>& take) {
    in_flight = std::max<std::size_t>(in_flight, 1);
    if (thread_count() == 1 || in_flight == 1 || count <= 1 || inside_team) {
        for (std::size_t i = 0; i < count; ++i) {
            make(i, 0);
            take(i, 0);
        }
        return;
    }
    std::mutex guard;
    std::condition_variable moved_on;
    std::size_t next = 0;
    std::size_t taken = 0;
    bool failed = false;
    run_team([&] {
        std::unique_lock lock(guard);
        try {
            while (true) {
                moved_on.wait(lock, [&] { return failed || next == count || next < taken + in_flight; });
                if (failed || next == count) return;
                const std::size_t i = next++;
                lock.unlock();
                make(i, i % in_flight);
                lock.lock();
                moved_on.wait(lock, [&] { return failed || taken == i; });
                if (failed) return;
                lock.unlock();  // only the owner of item `taken` gets here: one at a time, in order
                take(i, i % in_flight);
                lock.lock();
                ++taken;
                moved_on.notify_all();
            }
        } catch (...) {
            if (!lock.owns_lock()) lock.lock();
            failed = true;
            moved_on.notify_all();
            throw;
        }
    });
}

}  // namespace keikan

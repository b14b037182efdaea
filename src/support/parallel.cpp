// SPDX-License-Identifier: Apache-2.0
#include "keikan/support/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

namespace keikan {

/// The arena has exactly as many places as threads were asked for, even if the machine has fewer cores;
/// the global control lets that many threads exist.
struct ThreadLimit::Control {
    explicit Control(int wanted)
        : threads(wanted > 0 ? wanted : tbb::info::default_concurrency()),
          allowed(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
          arena(threads) {}

    int threads;
    tbb::global_control allowed;
    tbb::task_arena arena;
    Control* outer = nullptr;

    static std::atomic<Control*>& innermost() {
        static std::atomic<Control*> control = nullptr;
        return control;
    }

    /// Runs `work` where at most `thread_count()` threads join in. Already inside, this is a plain call.
    template <typename Work>
    static void run(const Work& work) {
        if (Control* control = innermost().load()) {
            control->arena.execute(work);
        } else {
            work();
        }
    }
};

ThreadLimit::ThreadLimit(int threads) : control_(std::make_unique<Control>(threads)) {
    control_->outer = Control::innermost().exchange(control_.get());
}

ThreadLimit::~ThreadLimit() {
    Control::innermost().store(control_->outer);
}

void on_one_thread(const std::function<void()>& work) {
    tbb::task_arena arena(1);
    arena.execute(work);
}

int thread_count() {
    if (const ThreadLimit::Control* control = ThreadLimit::Control::innermost().load())
        return control->threads;
    return std::max(1, tbb::info::default_concurrency());
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work) {
    parallel_ranges(count, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) work(i);
    });
}

void parallel_ranges(std::size_t count, std::size_t grain,
                     const std::function<void(std::size_t begin, std::size_t end)>& work) {
    if (count == 0) return;
    grain = std::max<std::size_t>(grain, 1);
    if (thread_count() == 1 || count <= grain) return work(0, count);
    // Pieces are numbered, rather than left to TBB's halving, so that each is at least `grain` long.
    const std::size_t pieces = count / grain;
    ThreadLimit::Control::run([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pieces), [&](const auto& some) {
            const std::size_t end = some.end() == pieces ? count : some.end() * grain;
            work(some.begin() * grain, end);
        });
    });
}

void parallel_in_order(std::size_t count, std::size_t in_flight,
                       const std::function<void(std::size_t i, std::size_t slot)>& make,
                       const std::function<void(std::size_t i, std::size_t slot)>& take) {
    in_flight = std::max<std::size_t>(in_flight, 1);
    if (thread_count() == 1 || in_flight == 1 || count <= 1) {
        for (std::size_t i = 0; i < count; ++i) {
            make(i, 0);
            take(i, 0);
        }
        return;
    }
    // The pipeline lets in_flight items live at a time and they leave in order, so when item i enters,
    // item i - in_flight has left: i modulo in_flight is a free slot.
    std::size_t next = 0;
    const auto number = tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order,
                                                            [&](tbb::flow_control& flow) -> std::size_t {
                                                                if (next == count) {
                                                                    flow.stop();
                                                                    return count;
                                                                }
                                                                return next++;
                                                            });
    const auto made = tbb::make_filter<std::size_t, std::size_t>(
        tbb::filter_mode::parallel, [&](std::size_t i) { return make(i, i % in_flight), i; });
    const auto taken = tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order,
                                                           [&](std::size_t i) { take(i, i % in_flight); });
    ThreadLimit::Control::run([&] { tbb::parallel_pipeline(in_flight, number & made & taken); });
}

}  // namespace keikan

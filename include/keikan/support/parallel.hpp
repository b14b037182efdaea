// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>
#include <memory>

namespace keikan {

/// While it lives, the work below runs in at most `threads` threads (0: as many as the machine has).
/// The only place of the project where threads are made; nothing is summed across them, so their number
/// cannot change a result. Of several that live, the youngest counts; made and ended by one thread, outside
/// of the work itself.
class ThreadLimit {
  public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

    struct Control;

  private:
    std::unique_ptr<Control> control_;
};

/// Threads that the work below may use at this moment, at least 1.
int thread_count();

/// Calls `work` so that libraries that use oneTBB's threads of their own accord keep to this one meanwhile:
/// what they build does not depend on the number of threads. Others are not held up.
void on_one_thread(const std::function<void()>& work);

/// Calls `work(i)` once for every i in [0, count), in any order, side by side. An exception of any call is
/// thrown again here, when no other call runs any more; calls that had not begun by then are left out. The
/// same holds for the functions below. With one thread, all calls come in rising order on this thread.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work);

/// Calls `work(begin, end)` for ranges that divide [0, count), each at least `grain` long (the last may
/// be shorter). For loops whose single step is too small to be worth a call.
void parallel_ranges(std::size_t count, std::size_t grain,
                     const std::function<void(std::size_t begin, std::size_t end)>& work);

/// Calls `make(i)` side by side and `take(i)` one at a time in rising order of i, each after its own
/// `make(i)`. At most `in_flight` items are made and not yet taken: memory stays bounded. `slot`, in
/// [0, in_flight), is the item's place for intermediate data, from its `make` to the end of its `take`.
void parallel_in_order(std::size_t count, std::size_t in_flight,
                       const std::function<void(std::size_t i, std::size_t slot)>& make,
                       const std::function<void(std::size_t i, std::size_t slot)>& take);

}  // namespace keikan

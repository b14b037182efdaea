// SPDX-License-Identifier: Apache-2.0
#include "keikan/support/parallel.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace keikan;

namespace {
const std::vector<int> kThreadCounts = {1, 2, 3, 8};
}

TEST_CASE("ThreadLimit: the youngest counts, and the machine decides again when all have ended",
          "[support]") {
    const int machine = thread_count();
    CHECK(machine >= 1);
    {
        const ThreadLimit outer(3);
        CHECK(thread_count() == 3);
        {
            const ThreadLimit inner(2);
            CHECK(thread_count() == 2);
        }
        CHECK(thread_count() == 3);
    }
    CHECK(thread_count() == machine);
    CHECK((ThreadLimit(0), thread_count()) == machine);
}

TEST_CASE("parallel_for: every index is worked on once, for any number of threads", "[support]") {
    for (const int threads : kThreadCounts) {
        const ThreadLimit limit(threads);
        for (const std::size_t count : {0u, 1u, 2u, 1000u}) {
            std::vector<std::atomic<int>> calls(count);
            parallel_for(count, [&](std::size_t i) { ++calls[i]; });
            for (const auto& n : calls) CHECK(n == 1);
        }
    }
}

TEST_CASE("parallel_for: no more threads take part than are allowed", "[support]") {
    for (const int threads : kThreadCounts) {
        const ThreadLimit limit(threads);
        std::atomic<int> at_work = 0, most = 0;
        parallel_for(64, [&](std::size_t) {
            const int now = ++at_work;
            for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            --at_work;
        });
        CHECK(most <= threads);
    }
}

TEST_CASE("parallel_for: may be called inside itself", "[support]") {
    const ThreadLimit limit(4);
    std::vector<std::atomic<int>> calls(100);
    parallel_for(10, [&](std::size_t i) { parallel_for(10, [&](std::size_t j) { ++calls[10 * i + j]; }); });
    for (const auto& n : calls) CHECK(n == 1);
}

TEST_CASE("parallel_for: an exception is thrown again where it was called", "[support]") {
    for (const int threads : kThreadCounts) {
        const ThreadLimit limit(threads);
        CHECK_THROWS_AS(parallel_for(100,
                                     [](std::size_t i) {
                                         if (i == 57) throw std::out_of_range("57");
                                     }),
                        std::out_of_range);
    }
}

TEST_CASE("parallel_ranges: ranges divide the whole and are at least the grain long", "[support]") {
    for (const int threads : kThreadCounts) {
        const ThreadLimit limit(threads);
        for (const std::size_t count : {0u, 1u, 7u, 8u, 15u, 16u, 1003u}) {
            std::vector<std::atomic<int>> calls(count);
            std::atomic<int> short_ranges = 0;
            parallel_ranges(count, 8, [&](std::size_t begin, std::size_t end) {
                if (end - begin < 8 && end != count) ++short_ranges;
                for (std::size_t i = begin; i < end; ++i) ++calls[i];
            });
            CHECK(short_ranges == 0);
            for (const auto& n : calls) CHECK(n == 1);
        }
    }
}

TEST_CASE("parallel_in_order: items are taken in rising order, each once, after they were made",
          "[support]") {
    for (const int threads : kThreadCounts) {
        const ThreadLimit limit(threads);
        std::vector<int> made(500, 0);
        std::vector<std::size_t> taken;
        parallel_in_order(
            made.size(), 5, [&](std::size_t i, std::size_t) { made[i] = 1; },
            [&](std::size_t i, std::size_t) {
                CHECK(made[i] == 1);
                taken.push_back(i);
            });
        REQUIRE(taken.size() == made.size());
        for (std::size_t i = 0; i < taken.size(); ++i) CHECK(taken[i] == i);
    }
}

TEST_CASE("parallel_in_order: no more than `in_flight` items wait, each alone in its slot", "[support]") {
    for (const int threads : kThreadCounts) {
        const ThreadLimit limit(threads);
        constexpr std::size_t kInFlight = 3;
        std::vector<std::atomic<long>> owner(kInFlight);
        for (auto& o : owner) o = -1;
        std::atomic<int> alive = 0, most = 0, clashes = 0;
        parallel_in_order(
            200, kInFlight,
            [&](std::size_t i, std::size_t slot) {
                const int now = ++alive;
                for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
                }
                if (owner.at(slot).exchange(static_cast<long>(i)) != -1) ++clashes;
            },
            [&](std::size_t i, std::size_t slot) {
                if (owner.at(slot).exchange(-1) != static_cast<long>(i)) ++clashes;
                --alive;
            });
        CHECK(most <= static_cast<int>(kInFlight));
        CHECK(clashes == 0);
    }
}

TEST_CASE("parallel_in_order: an exception of make or take is thrown again where it was called",
          "[support]") {
    for (const int threads : kThreadCounts) {
        const ThreadLimit limit(threads);
        const auto nothing = [](std::size_t, std::size_t) {};
        const auto fails = [](std::size_t i, std::size_t) {
            if (i == 40) throw std::out_of_range("40");
        };
        CHECK_THROWS_AS(parallel_in_order(100, 4, fails, nothing), std::out_of_range);
        CHECK_THROWS_AS(parallel_in_order(100, 4, nothing, fails), std::out_of_range);
    }
}

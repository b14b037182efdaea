// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <limits>
#include <stdexcept>

#include "planted.hpp"

using namespace keikan;
using namespace keikan::peers;
using namespace keikan::peers::test;

namespace {

[[noreturn]] void never_return() {
    for (;;) pause();
}

}  // namespace

TEST_CASE("in_a_fork: what goes wrong in one pixel is told, and all others are answered", "[peers]") {
    const Peer peer = planted_peer([](int i, Answer& answer) {
        if (i == 2) throw std::runtime_error("no such luck");
        if (i == 3) raise(SIGSEGV);
        if (i == 4) std::terminate();
        if (i == 5) never_return();
        if (i == 6) _exit(0);
        if (i == 7) answer.areas[0] = std::numeric_limits<double>::quiet_NaN();
        if (i == 8) answer.areas.clear();
        if (i == 9) throw 17;
        if (i == 10) answer.areas[0] = 0.75;
    });
    const Batch batch(half_covered_pixels(12));
    const Round round = in_a_fork(peer, {.seconds = 0.2}).ask(batch);

    using enum Outcome;
    const std::vector<Outcome> expected{Answered, Answered,  Exception, Crash,     Crash,    Hang,
                                        Crash,    Exception, Exception, Exception, Answered, Answered};
    REQUIRE(round.replies.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        INFO("pixel " << i << ": " << round.replies[i].reason);
        CHECK(round.replies[i].outcome == expected[i]);
    }
    CHECK(round.replies[1].answer == Answer{{0.5}, 0.5});
    CHECK(round.replies[10].answer == Answer{{0.75}, 0.5});
    CHECK(round.replies[11].answer == Answer{{0.5}, 0.5});
    CHECK(round.replies[2].reason == "no such luck");
    CHECK(round.replies[3].reason.starts_with("signal 11"));
    CHECK(round.replies[4].reason.starts_with("signal 6"));
    CHECK(round.replies[6].reason == "exited in the middle");
    CHECK(round.timed_pixels == 5);  // those behind the last process's end
}

TEST_CASE("in_a_fork: memory without bound is an exception, not the machine's end", "[peers]") {
    const Peer hungry = planted_peer([](int i, Answer& answer) {
        if (i == 1) answer.areas.resize(std::size_t{1} << 30);  // 8 GiB
    });
    const Batch batch(half_covered_pixels(3));
    const Round round = in_a_fork(hungry, {}).ask(batch);
    CHECK(round.replies[1].outcome == Outcome::Exception);
    CHECK(round.replies[2].outcome == Outcome::Answered);
    CHECK(round.timed_pixels == 3);
}

TEST_CASE("in_a_fork: after too many hangs nothing more is asked, in this batch and the next", "[peers]") {
    const Contestant stuck =
        in_a_fork(planted_peer([](int, Answer&) { never_return(); }), {.seconds = 0.05, .most_hangs = 2});
    const Batch batch(half_covered_pixels(4));
    const Round round = stuck.ask(batch);
    CHECK(round.replies[0].outcome == Outcome::Hang);
    CHECK(round.replies[1].outcome == Outcome::Hang);
    CHECK(round.replies[2].outcome == Outcome::NotAsked);
    CHECK(stuck.ask(batch).replies[0].outcome == Outcome::NotAsked);
}

TEST_CASE("in_a_fork: a pixel with depth planes is put to those that know depth", "[peers]") {
    std::vector<PixelCase> cases = half_covered_pixels(2);
    cases[1].depth = {{0, 0, 1}};
    const Batch batch(std::move(cases));
    const Round library = in_a_fork(clipper(), {}).ask(batch), ours = in_a_fork(splitting(), {}).ask(batch);
    CHECK(library.replies[0].outcome == Outcome::Answered);
    CHECK(library.replies[1].outcome == Outcome::NotAsked);
    CHECK(ours.replies[1].answer == Answer{{0.5}, 0.5});
}

TEST_CASE("in_a_fork: a peer that cannot even start is a crash each time", "[peers]") {
    Peer peer = planted_peer([](int, Answer&) {});
    peer.start = []() -> Ask { throw std::runtime_error("not today"); };
    const Batch batch(half_covered_pixels(2));
    const Round round = in_a_fork(peer, {}).ask(batch);
    CHECK(round.replies[0].outcome == Outcome::Crash);
    CHECK(round.replies[1].outcome == Outcome::Crash);
}

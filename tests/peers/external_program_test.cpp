// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "keikan/support/input_error.hpp"
#include "planted.hpp"

using namespace keikan;
using namespace keikan::peers;
using namespace keikan::peers::test;
using Catch::Matchers::Contains;

namespace {

/// An awk program that answers 1/2 to whatever it reads, after `rules` have seen the line. awk writes to a
/// pipe in large pieces: when it is killed, answers it has given are lost.
std::string answering(const std::string& rules = "") {
    return "awk '{ match($0, /\"id\": \"[^\"]*\"/); id = substr($0, RSTART, RLENGTH) } " + rules +
           " { print \"{\" id \", \\\"areas\\\": [0.5], \\\"background\\\": 0.5}\" }'";
}

Round asked(const std::string& program, int pixels, const Watchdog& watchdog = {}) {
    const Batch batch(half_covered_pixels(pixels));
    return external_program("exec", program, watchdog).ask(batch);
}

std::size_t count_of(const Round& round, Outcome outcome) {
    std::size_t count = 0;
    for (const Reply& reply : round.replies) count += reply.outcome == outcome;
    return count;
}

}  // namespace

TEST_CASE("external_program: answers come back in order, over several runs of the program", "[peers]") {
    const Round round = asked(answering(), 600);
    REQUIRE(round.replies.size() == 600);
    CHECK(count_of(round, Outcome::Answered) == 600);
    CHECK(round.replies[599].answer == Answer{{0.5}, 0.5});
    CHECK(round.timed_pixels == 600);
    CHECK(round.seconds > 0);
}

TEST_CASE("external_program: of a crash, the pixel that causes it is blamed, though output was lost",
          "[peers]") {
    const Round round = asked(answering("/half\\/1\\/13\"/ { system(\"kill -SEGV $PPID\") }"), 40);
    for (std::size_t i = 0; i < 40; ++i) {
        INFO("pixel " << i << ": " << round.replies[i].reason);
        CHECK(round.replies[i].outcome == (i == 13 ? Outcome::Crash : Outcome::Answered));
    }
    CHECK_THAT(round.replies[13].reason, Contains("signal 11"));
}

TEST_CASE("external_program: a pixel that makes it hang is stopped at the limit", "[peers]") {
    const Round round = asked(answering("/half\\/1\\/5\"/ { system(\"sleep 60\") }"), 8, {.seconds = 0.25});
    for (std::size_t i = 0; i < 8; ++i)
        CHECK(round.replies[i].outcome == (i == 5 ? Outcome::Hang : Outcome::Answered));
}

TEST_CASE("external_program: a line that is no answer counts, and the next lines are read", "[peers]") {
    const Round round = asked(
        answering(
            "/half\\/1\\/2\"/ { print \"I do not know\"; next }"
            "/half\\/1\\/4\"/ { print \"{\" id \", \\\"areas\\\": []}\"; next }"
            "/half\\/1\\/6\"/ { id = \"\\\"id\\\": \\\"another\\\"\" }"
            "/half\\/1\\/7\"/ { print \"{\" id \", \\\"areas\\\": [1e999], \\\"background\\\": 0}\"; next }"),
        9);
    for (const std::size_t i : {0U, 1U, 3U, 5U, 8U}) CHECK(round.replies[i].outcome == Outcome::Answered);
    for (const std::size_t i : {2U, 4U, 6U, 7U}) CHECK(round.replies[i].outcome == Outcome::Exception);
    CHECK_THAT(round.replies[2].reason, Contains("'I do not know'"));
    CHECK_THAT(round.replies[6].reason, Contains("another case"));
}

TEST_CASE("external_program: garbage, silence and an exit code are no answers, and it is given up",
          "[peers]") {
    for (const char* const program :
         {"echo hello", "true", "cat", "exit 3", "echo out of ideas >&2; exit 1"}) {
        INFO(program);
        const Round round = asked(program, 70);
        REQUIRE(round.replies.size() == 70);
        CHECK(count_of(round, Outcome::Answered) == 0);
        CHECK(count_of(round, Outcome::Exception) >= 64);
        CHECK(count_of(round, Outcome::Crash) + count_of(round, Outcome::Hang) == 0);
    }
    CHECK_THAT(asked("echo out of ideas >&2; exit 1", 1).replies[0].reason,
               Contains("exit code 1: out of ideas"));
}

TEST_CASE("external_program: one that never stops writing is stopped", "[peers]") {
    CHECK(asked("yes", 2, {.seconds = 5}).replies[1].outcome == Outcome::Hang);
}

TEST_CASE("external_program: a crash after the last answer is a crash", "[peers]") {
    CHECK(asked("read line; echo '{\"areas\": [0.5], \"background\": 0.5}'; kill -ABRT $$", 1)
              .replies[0]
              .outcome == Outcome::Crash);
    CHECK(asked("read line; echo '{\"areas\": [0.5], \"background\": 0.5}'", 1).replies[0].outcome ==
          Outcome::Answered);
}

TEST_CASE("external_program: the stated exact answers are kept from it", "[peers]") {
    std::vector<PixelCase> cases = half_covered_pixels(1);
    cases[0].areas = {"1/2"};
    cases[0].background = "1/2";
    const Batch batch(std::move(cases));
    const Round round =
        external_program("exec",
                         "grep -q background && echo seen || echo '{\"areas\": [0], \"background\": 1}'", {})
            .ask(batch);
    CHECK(round.replies[0].answer == Answer{{0}, 1});
}

TEST_CASE("external_program: a command that the shell cannot run is the user's mistake", "[peers]") {
    CHECK_THROWS_AS(asked("no_such_program_anywhere", 1), InputError);
    CHECK_THROWS_AS(asked("/dev/null", 1), InputError);
}

// SPDX-License-Identifier: Apache-2.0
#include "keikan/support/check.hpp"

#include <catch2/catch.hpp>
#include <new>

#include "keikan/support/input_error.hpp"
#include "keikan/support/program.hpp"

using namespace keikan;

TEST_CASE("KEIKAN_CHECK: a failure tells the file, the message and the condition", "[support]") {
    try {
        KEIKAN_CHECK(1 + 1 == 3, "the sum is " << 1 + 1);
        FAIL("a false condition went through");
    } catch (const CheckFailure& failure) {
        const std::string text = failure.what();
        CHECK(text.starts_with("check_test.cpp:"));
        CHECK(text.ends_with(": the sum is 2 (1 + 1 == 3)"));
    }
    int built = 0;
    KEIKAN_CHECK(built == 0, "a message is built only when it is needed: " << ++built);
    CHECK(built == 0);
}

TEST_CASE("InputError: file, place and reason make one line", "[support]") {
    CHECK(std::string(InputError("a.json", "/camera", "no such key").what()) ==
          "a.json:/camera: no such key");
    CHECK(std::string(InputError("a.json", "", "empty").what()) == "a.json: empty");
}

TEST_CASE("run_program: done is 0, a mistake of ours 1, bad input 2", "[support][program]") {
    CHECK(run_program("test", [] { return kDone; }) == 0);
    CHECK(run_program("test", []() -> int { throw InputError("planted: bad input"); }) == 2);
    CHECK(run_program("test", []() -> int {
              KEIKAN_CHECK(1 + 1 == 3, "planted: a mistake");
              return kDone;
          }) == 1);
    CHECK(run_program("test", []() -> int { throw std::bad_alloc(); }) == 1);
}

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>

namespace keikan {

/// What a program's exit code says.
inline constexpr int kDone = 0, kCheckFailed = 1, kBadInput = 2;

/// Runs `body` and returns its exit code. What it throws is told on standard error in one line, after the
/// program's name: an InputError is kBadInput, anything else a mistake of ours, kCheckFailed.
int run_program(const char* name, const std::function<int()>& body);

}  // namespace keikan

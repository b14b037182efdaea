// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "../support/file_contents.hpp"

/// What a run of the program left behind.
struct Run {
    int exit_code = -1;  ///< 128 + the signal's number where one ended it
    std::string out;
    std::string err;
    /// Complaints are one line that begins with "keikan: ".
    bool complains_in_one_line() const;
};

/// Runs `keikan` with these arguments, as a shell would read them, and this text on its standard input.
Run run_keikan(const std::string& arguments, const std::string& input = "");

/// data/scenes/hill.json, the smallest scene.
std::string hill();

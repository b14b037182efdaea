// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdexcept>
#include <string>

namespace keikan {

/// Bad input: a file, an option, a number out of range. Its text is one line: the file, the place in it
/// and what is wrong. Caught once, in `main`, which prints it and exits with 2.
class InputError : public std::runtime_error {
  public:
    InputError(const std::string& file, const std::string& place, const std::string& reason)
        : std::runtime_error(file + (place.empty() ? "" : ":" + place) + ": " + reason) {}
    explicit InputError(const std::string& reason) : std::runtime_error(reason) {}
};

}  // namespace keikan

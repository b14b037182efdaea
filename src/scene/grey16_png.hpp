// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace keikan {

/// The values of a 16-bit grey PNG, row by row from the top.
struct Grey16 {
    int columns = 0;
    int rows = 0;
    std::vector<std::uint16_t> values;
};

/// Errors: InputError for anything but a whole 16-bit grey PNG of at most 2^26 samples.
Grey16 read_grey16_png(const std::string& file);

}  // namespace keikan

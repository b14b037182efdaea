// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace keikan {

/// The bytes of a 16-bit grey PNG; `values` row by row from the top.
std::string grey16_png(int columns, int rows, std::span<const std::uint16_t> values);

}  // namespace keikan

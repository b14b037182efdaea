// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace keikan::scan_file {

/// XXH3-64 of the bytes.
std::uint64_t checksum(std::span<const std::byte> bytes);

}  // namespace keikan::scan_file

// SPDX-License-Identifier: Apache-2.0
#include "scan_file_checksum.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace keikan::scan_file {

std::uint64_t checksum(std::span<const std::byte> bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace keikan::scan_file

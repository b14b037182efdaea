// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_size.hpp"

#include <charconv>
#include <cstdint>

#include "keikan/support/input_error.hpp"

namespace keikan {

std::optional<ImageSize> picture_size(const std::string& text) {
    if (text.empty()) return std::nullopt;
    ImageSize size;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.height);
        const bool sound = height.ec == std::errc() && height.ptr == end && size.width > 0 &&
                           size.height > 0 &&
                           static_cast<std::int64_t>(size.width) * size.height <= std::int64_t{1} << 28;
        if (sound) return size;
    }
    throw InputError("--size " + text + ": is not WIDTHxHEIGHT with at most 2^28 pixels");
}

}  // namespace keikan

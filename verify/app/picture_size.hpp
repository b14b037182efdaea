// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

#include "keikan/model/pixel.hpp"

namespace keikan {

/// "1000x650" as columns and rows; nothing for an empty text. Errors: InputError.
std::optional<ImageSize> picture_size(const std::string& text);

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>

#include "keikan/image/image.hpp"

namespace keikan::compare {

inline constexpr int kLetterWidth = 5, kLetterHeight = 9;

/// Writes into a picture, with (x, y) the upper left corner: small letters, digits and . , : - / % + = ( ),
/// each dot `scale` pixels wide. Other characters are blanks; what lies outside of the picture is left out.
void letter(Image<Rgb>& image, int x, int y, std::string_view text, Rgb colour, int scale = 1);

}  // namespace keikan::compare

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "keikan/image/image.hpp"
#include "scene_check.hpp"

namespace keikan::crosscheck {

/// Errors as colours: the decimal logarithm from `lowest` to `highest` along the colour map viridis, dark to
/// bright; black where the error is 0 and red where the pixel is a disagreement.
struct ErrorScale {
    int lowest = -18;
    int highest = -12;
};

/// The scale that reaches from 1e-18 to the largest of `errors`, at least to 1e-12.
ErrorScale scale_for(const Image<float>& errors);

/// The false-colour picture, with a bar of the scale below it: a tick and the exponent at every decade.
Image<Rgb> error_picture(const Image<float>& errors, const Image<std::uint8_t>& wrong, ErrorScale scale);

/// The same scale in words, for a text beside the picture.
std::string error_legend(ErrorScale scale);

/// White where a pixel is divided by exact areas, grey where along the scanline, black where it shows one
/// face.
Image<Rgb> flag_picture(const Image<Flag>& flags);

}  // namespace keikan::crosscheck

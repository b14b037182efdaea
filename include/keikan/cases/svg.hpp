// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string>

#include "keikan/model/pixel_case.hpp"

namespace keikan {

/// A drawing of pixel cases, side by side, for people: the pixel and half a pixel around it, the polygons
/// translucent with their numbers, the nearest (or, with depth planes, the first) on top. What lies farther
/// out is cut off. The drawing is rounded; no reader takes it back.
std::string svg_from_cases(std::span<const PixelCase> cases);

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>

#include "keikan/baseline/faces_in_view.hpp"
#include "keikan/render/render_bands.hpp"

namespace keikan::baseline {

/// Exact clipping in every pixel: no pixel is flagged, every pixel that any face's outline may reach is
/// divided by VisibleAreas among all faces there. Its areas are those that keikan-verify proves, so it is
/// also what `keikan compare` measures the others against. Water is looked at once in each visible part, at
/// its centroid.
///
/// Properties:
///   (1) Weights are within kVisibleAreaError of the exact areas.
/// Cost:     O(F + sum over the pixels of f log f .. f^2) for the f faces whose extent in the pixel's row
/// meets
///           the pixel; a face that covers the pixel throws out what lies behind it.
/// Source:   Catmull 1978 (paper: reference 4). Departure: nearness of pairs instead of a sorted list (D5).
std::function<BandMaker()> exact_everywhere(const FacesInView& view);

}  // namespace keikan::baseline

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>

#include "keikan/baseline/faces_in_view.hpp"
#include "keikan/render/render_bands.hpp"

namespace keikan::baseline {

/// No anti-aliasing: one scanline through the pixels' centres, and of it the centres alone. A pixel is the
/// face seen at its centre; an edge that passes through it belongs to the face below or to the right of it.
/// Water is looked at there, once.
///
/// Cost: O(F + C log C + P) for F faces in view, P pixels, and C crossings of a face with a scanline; what
///       begins at a scanline is sorted, the rest is kept in order.
std::function<BandMaker()> point_sampling(const FacesInView& view);

/// Multi-scanning: `lines` scanlines in each row of pixels, at the heights (k + 1/2) / lines. Each gives
/// exact lengths along x (its own intersections with the faces); a face's share of a pixel is the mean of its
/// lengths there. The face is shaded once in a pixel, in the middle of its stretches. Water is looked at once
/// in every stretch: `lines` times in a pixel that is all water.
///
/// Properties:
///   (1) Exact where every edge in the pixel is vertical.
///   (2) A horizontal edge at the height h gives the share round(h lines) / lines: off by at most
///       1 / (2 lines), and a strip thinner than 1 / lines may be missed.
/// Requires: lines >= 1.
/// Cost:     O(F + C log C + S) with C, crossings, and S, stretches times the pixels they reach over, both
///           proportional to `lines`. Error O(1 / lines) at near-horizontal edges, O(1 / lines^2) at others.
/// Source:   Nishita, Nakamae 1984 (paper: reference 2). Assumed: sub-scanlines at equal distances.
std::function<BandMaker()> multi_scanning(const FacesInView& view, int lines);

}  // namespace keikan::baseline

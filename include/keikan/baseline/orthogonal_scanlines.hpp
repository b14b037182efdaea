// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>

#include "keikan/baseline/faces_in_view.hpp"
#include "keikan/render/render_bands.hpp"

namespace keikan::baseline {

/// Scanlines in both directions. In each row of pixels, `lines` + 1 level ones at the heights k / lines (the
/// outermost lie on the pixels' borders and serve two rows); in each pixel that they show to be divided,
/// `lines` upright ones at (k + 1/2) / lines. The upright ones know the faces that a level one has shown in
/// the pixel, and those with a vertex in it.
///
/// Each direction measures lengths exactly along its lines: level lines what upright edges bound, upright
/// lines what level edges bound. A face's share is the mean of both, each weighted by how many borders its
/// lines have met in the pixel; the level lines count by the trapezoid rule.
///
/// Properties:
///   (1) Exact where all edges in the pixel are vertical, and where all are horizontal and every face is
///   known. (2) A level strip thinner than 1 / lines, that lies between two level lines and has no vertex in
///   the
///       pixel, is missed.
/// Water is looked at once in every stretch of a level line, with its share of the water in the pixel.
///
/// Requires: lines >= 1.
/// Cost:     that of multi_scanning, and for each divided pixel O(lines k log k), k known faces.
/// Source:   Tanaka, Takahashi 1991 (paper: reference 3), of which the paper says: level and upright
/// scanlines,
///           the polygons' vertices are considered, areas are more exact than multi-scanning's, but not those
///           of level objects thinner than the scanlines' distance. All else is assumed: where the lines lie,
///           what the upright ones know, how both are combined.
std::function<BandMaker()> orthogonal_scanlines(const FacesInView& view, int lines);

}  // namespace keikan::baseline

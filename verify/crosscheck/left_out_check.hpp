// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

#include "check_summary.hpp"
#include "keikan/scan/projected_faces.hpp"

namespace keikan::crosscheck {

/// How much may be seen, in a pixel, of faces that truly cannot be: where a back meets the front that hides
/// it, at the silhouette, the rounding of corners and planes by the projection decides which is nearer. That
/// rounding moves coverages by some 3e-11 at most (docs/ground_truth.md); half a step of 16 bits is 8e-6.
constexpr double kSeenByRounding = 1e-9;

/// Lets the oracle decide whether the projection was right: in one of `one_in` pixels, all faces are in
/// question, those that the product never asks about too (`all` is the projection with backs kept). Where
/// more than kSeenByRounding is seen of faces that are not in `asked`, `summary` gets a disagreement of kind
/// LeftOut; and it gets the counts.
///
/// Requires: `all` holds every face of `asked`, with the same doubles.
void check_left_out(const ProjectedFaces& asked, const ProjectedFaces& all, ImageSize size,
                    std::uint64_t seed, std::uint64_t one_in, CheckSummary& summary);

}  // namespace keikan::crosscheck

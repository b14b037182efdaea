// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "partition.hpp"

namespace keikan::clip {

/// Whether no two of the faces overlap: each pair has an edge of one of them that leaves the other on its
/// outer side, or within one step of the 2^-53 grid of it. Then each face shows all of itself, and neither
/// depth nor cells are needed: the common case of a pixel on one surface.
bool pairwise_apart(const Entrants& entrants);

}  // namespace keikan::clip

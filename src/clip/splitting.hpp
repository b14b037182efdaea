// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "entrants.hpp"
#include "keikan/model/coverage.hpp"
#include "measure.hpp"
#include "partition.hpp"

namespace keikan::clip {

/// The engine `splitting`: faces that overlap no other are measured as they are; the others divide the pixel
/// into convex cells among them (Partition), and what no face takes is the background.
class Splitting {
  public:
    /// Measures what each of entrants.faces shows, in their order, which it changes: measures[i] belongs to
    /// entrants.faces[i]. Returns the area of the background.
    double measure(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness, Entrants& entrants,
                   std::vector<Measure>& measures);

    /// The visible regions of the last call as convex pieces. The entrants are those of that call.
    std::span<const VisiblePiece> pieces(const Entrants& entrants);

  private:
    Partition partition_;
    std::size_t first_alone_ = 0;  ///< those after it are not in the partition
    std::vector<VisiblePiece> pieces_;
};

}  // namespace keikan::clip

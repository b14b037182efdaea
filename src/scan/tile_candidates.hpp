// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "face_facts.hpp"
#include "tile_bins.hpp"

namespace keikan {

/// A face that may be seen in a pixel.
struct Candidate {
    double w_min = 0;  ///< what the face shows of itself in the pixel, if anything, is no farther ...
    double w_max = 0;  ///< ... and no nearer
    std::uint32_t face = 0;
    std::uint16_t pixel = 0;  ///< row * kTileSize + column, in the tile
    std::uint8_t inside = 0;  ///< bit e: the pixel lies wholly on the inner side of edge e, for certain
    bool covers = false;      ///< the face covers the pixel wholly, for certain
};

/// The faces that may be seen in each pixel of one tile.
///
/// "Certain" means: after allowing for every rounding error. What is left out is certainly not seen: it does
/// not meet the pixel, or lies behind a face that covers the pixel. What is kept may still show nothing.
class TileCandidates {
  public:
    /// Looks at `tile` (its faces, rising) whose pixels are [x, x + columns) x [y, y + rows).
    void look(const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
              std::span<const std::uint32_t> tile, int x, int y, int columns, int rows);

    /// Candidates of the pixel in that row and column of the tile, by rising face.
    std::span<const Candidate> at(int row, int column) const {
        const auto p = static_cast<std::size_t>(row * kTileSize + column);
        return std::span(kept_).subspan(begin_[p], begin_[p + 1] - begin_[p]);
    }

  private:
    template <std::size_t kEdges>
    void look_at_convex(const FaceView& face, const FaceFacts& facts, std::uint32_t index);
    void look_at_box(const FaceView& face, const FaceFacts& facts, std::uint32_t index);
    void add(Candidate candidate);
    void keep_what_may_be_seen();

    static constexpr std::size_t kPixels = static_cast<std::size_t>(kTileSize) * kTileSize;
    int x_ = 0, y_ = 0, columns_ = 0, rows_ = 0;
    std::vector<Candidate> found_;
    std::vector<Candidate> kept_;
    std::array<std::uint32_t, kPixels + 1> begin_{};
    std::array<double, kPixels> nearest_cover_{};
};

}  // namespace keikan

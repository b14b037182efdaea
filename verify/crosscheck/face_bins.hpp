// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/scan/projected_faces.hpp"

namespace keikan::crosscheck {

/// Which faces can be in which pixel, found from the bounding boxes of the projected faces alone: written
/// apart from the scan's own tiling, so that a face that the scan loses is still asked about here.
///
/// A face is listed for every pixel whose open square its open bounding box meets; in any other pixel it has
/// no area. Comparisons of doubles only, so nothing is lost to rounding.
class FaceBins {
  public:
    /// `faces` must outlive the bins.
    FaceBins(const ProjectedFaces& faces, ImageSize size);

    /// For each pixel of row `y`, the positions of its faces in rising order: those of pixel x are
    /// `face[begin[x]] ... face[begin[x + 1] - 1]`.
    struct Row {
        std::vector<std::uint32_t> begin;
        std::vector<std::uint32_t> face;
        std::span<const std::uint32_t> at(int x) const {
            const auto i = static_cast<std::size_t>(x);
            return std::span(face).subspan(begin[i], begin[i + 1] - begin[i]);
        }
    };
    Row row(int y) const;

  private:
    struct Columns {
        std::int32_t begin = 0;
        std::int32_t end = 0;
    };
    ImageSize size_;
    std::vector<Columns> columns_;        ///< of each face
    std::vector<std::size_t> row_begin_;  ///< rows + 1 values, into `row_face_`
    std::vector<std::uint32_t> row_face_;
};

}  // namespace keikan::crosscheck

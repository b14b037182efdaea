// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "crosscheck/claimed_row.hpp"
#include "crosscheck/scene_check.hpp"
#include "keikan/image/image.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scan/scan_band.hpp"
#include "keikan/scene/mesh.hpp"

namespace keikan::report {

/// What the scan claims of every pixel of a picture, kept for a page, and the page's pictures of numbers.
/// Memory: 24 bytes for each pixel, and 16 for each part of a divided one.
class SceneLayers {
  public:
    /// The references must outlive this.
    SceneLayers(const ProjectedFaces& faces, const Geometry& geometry, ImageSize size);

    /// Bands come in order from the top.
    void take(const ScanBand& band);

    /// The row as claimed. Requires: it has been taken.
    const crosscheck::ClaimedRow& row(int y) const { return rows_[static_cast<std::size_t>(y)]; }

    /// The name of the object that a projected face belongs to.
    const std::string& object_of(std::uint32_t face) const;

    /// {"width", "height", "objects": [...], "layers": {...}}: each layer is packed
    /// (report/packed_bytes.hpp), as docs/inspector.md describes.
    std::string json(const Image<Rgb>& picture, const crosscheck::SceneCheck& check) const;

  private:
    std::uint16_t object_index(std::uint32_t face) const;

    const ProjectedFaces& faces_;
    const Geometry& geometry_;
    ImageSize size_;
    std::vector<crosscheck::ClaimedRow> rows_;
};

}  // namespace keikan::report

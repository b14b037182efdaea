// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "keikan/scan/projected_faces.hpp"

namespace keikan::crosscheck {

/// What can be said of a pixel with certainty and without the oracle: which faces do not reach into it, which
/// one covers it whole, and which are hidden behind that one. It spares the oracle most of its work and
/// decides most pixels, so it only ever drops a face on an inequality that holds beyond its own rounding
/// errors; what is uncertain stays in question. A sample of the pixels is put to the oracle undiminished, to
/// check this as well.
class CertainHiding {
  public:
    /// `faces` must outlive this.
    explicit CertainHiding(const ProjectedFaces& faces);

    struct Remaining {
        std::vector<std::uint32_t> faces;    ///< those that may be seen, in the order of the candidates
        std::optional<std::uint32_t> cover;  ///< one of them, which certainly covers the whole pixel
        /// Nothing is left to ask: `cover` fills the pixel alone, or there is nothing but background.
        bool decided() const { return faces.empty() || (cover && faces.size() == 1); }
    };
    void operator()(PixelIndex pixel, std::span<const std::uint32_t> candidates, Remaining& out) const;

  private:
    enum class Relation { Outside, Covers, Unknown };
    Relation relation(std::uint32_t face, PixelIndex pixel) const;
    bool hides(std::uint32_t cover, std::uint32_t face, PixelIndex pixel) const;

    const ProjectedFaces& faces_;
    std::vector<std::int8_t> orientation_;  ///< +1 or -1: certainly convex and of that turn; 0: not certain
};

}  // namespace keikan::crosscheck

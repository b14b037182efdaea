// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/model/pixel.hpp"
#include "keikan/model/point.hpp"
#include "keikan/scene/scene.hpp"

namespace keikan {

/// Where the mirror images of thin conductors may be in the water: strips of the picture, so that samples can
/// be put on them. A conductor that covers a hundredth of a pixel is met by one sample in a hundred, so that
/// without them its image is dots.
///
/// A strip is what a conductor's face, mirrored at the mean plane of a water, covers in the picture, made
/// wider on every side by what the water's slopes may shift it by.
///
/// Properties:
///   (1) On still water a mirror image of such a face is nowhere outside of its strip.
///   (2) Elsewhere it is inside for slopes of up to kSlopes standard deviations.
/// Left out: faces that are kThin pixels or more across, whose images single samples do not miss; faces whose
/// images the slopes shift by more than kWidest pixels: an image of less than a pixel's width is spread over
/// so many there that its coverage is below 1 / (2 kWidest).
class MirroredWires {
  public:
    static constexpr double kSlopes = 3, kThin = 1, kWidest = 8;
    /// Strips are wider than the faces by this, at least: more than faces are rounded by for rays [pixels].
    static constexpr double kLeastMargin = 0x1p-8;

    /// None.
    explicit MirroredWires(ImageSize size) : size_(size) {}
    MirroredWires(const Scene& scene, const Geometry& geometry);

    /// A strip: where every edge's distance is at most 0.
    struct Strip {
        struct Edge {
            double x = 0, y = 0, at = 0;  ///< distance = x p.x + y p.y - at, outwards, (x, y) of unit length
        };
        static constexpr std::size_t kMostEdges = 12;
        std::array<Edge, kMostEdges> edges{};
        std::uint8_t count = 0;
        std::uint16_t water = 0;

        bool holds(Point p) const {
            for (std::size_t i = 0; i < count; ++i)
                if (edges[i].x * p.x + edges[i].y * p.y > edges[i].at) return false;
            return true;
        }
        bool may_meet(PixelIndex pixel) const;
    };

    /// Replaces `strips` by those of this water that may meet the pixel.
    void at(PixelIndex pixel, std::uint16_t water, std::vector<const Strip*>& strips) const;

    std::size_t size() const { return strips_.size(); }

  private:
    void add_water(const Scene& scene, const Geometry& geometry, std::uint16_t water);
    void add_strip(std::span<const Point> outline, double margin, std::uint16_t water);

    struct Entry {
        std::uint32_t pixel = 0, strip = 0;
    };
    ImageSize size_;
    std::vector<Strip> strips_;
    std::vector<Entry> entries_;  ///< rising by pixel, then by strip
};

}  // namespace keikan

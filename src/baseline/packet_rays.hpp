// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <memory>

#include "keikan/baseline/faces_in_view.hpp"

namespace keikan::baseline {

/// A packet is 4 x 2 neighbouring pixels.
inline constexpr int kPacketColumns = 4;
inline constexpr int kPacketRows = 2;
inline constexpr std::size_t kPacket = kPacketColumns * kPacketRows;
inline constexpr std::uint32_t kNoFace = 0xFFFFFFFFu;

using PacketPlaces = std::array<Point, kPacket>;  ///< pixel-local
using PacketHits = std::array<std::uint32_t, kPacket>;

inline PixelIndex pixel_of_lane(PixelIndex first, std::size_t lane) {
    return {first.x + static_cast<int>(lane) % kPacketColumns,
            first.y + static_cast<int>(lane) / kPacketColumns};
}

/// The projected faces in a hierarchy for packets of eight view rays (Embree 3, robust: no ray slips through
/// between two faces). May be asked from several threads at once.
class PacketRays {
  public:
    explicit PacketRays(const FacesInView& view);
    ~PacketRays();
    PacketRays(const PacketRays&) = delete;
    PacketRays& operator=(const PacketRays&) = delete;

    /// For each wanted lane the face that the ray through its place meets first, or kNoFace.
    void meet(PixelIndex first, const PacketPlaces& places, const std::array<bool, kPacket>& wanted,
              PacketHits& hits) const;

  private:
    struct Hierarchy;
    std::unique_ptr<Hierarchy> hierarchy_;
};

}  // namespace keikan::baseline

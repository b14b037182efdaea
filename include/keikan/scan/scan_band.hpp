// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "keikan/model/face.hpp"
#include "keikan/model/point.hpp"

namespace keikan {

/// What shading must know of a face that is seen. Self-contained: no geometry is needed beside it.
struct SeenFace {
    FaceId id = 0;
    std::uint16_t object = 0;
    std::uint16_t material = 0;
    DepthPlane plane;
    /// Shading normal in world coordinates, not normalised, towards the viewer's side: affine on the screen,
    /// n(x, y) = normal[0] + normal[1] (x - x0) + normal[2] (y - y0), with (x0, y0) = `normal_at`.
    std::array<std::array<float, 3>, 3> normal{};
    Point normal_at;
    std::array<float, 3> flat_normal{};  ///< unit normal of the plane itself, towards the viewer
    friend bool operator==(const SeenFace&, const SeenFace&) = default;
};

/// Pixels [x_begin, x_end) of a row that show one face only (or the background only), wholly.
struct Span {
    static constexpr std::uint32_t kBackground = 0xFFFFFFFFu;
    std::int32_t x_begin = 0;
    std::int32_t x_end = 0;
    std::uint32_t face = kBackground;  ///< into ScanBand::faces
    friend bool operator==(const Span&, const Span&) = default;
};

/// Where the weights of a divided pixel come from.
enum class Division : std::uint8_t {
    ExactAreas,  ///< flagged: visible areas (3.1)
    Scanline,    ///< not flagged by the paper's rule: lengths along the scanline through the centre (2.1)
};

/// A pixel that is divided among several faces.
struct DividedPixel {
    std::int32_t x = 0;
    Division division = Division::ExactAreas;
    std::uint32_t part_begin = 0;  ///< into ScanBand::parts
    std::uint32_t part_end = 0;
    double background = 0;
    friend bool operator==(const DividedPixel&, const DividedPixel&) = default;
};

/// One face's share of a divided pixel.
struct SeenPart {
    std::uint32_t face = 0;  ///< into ScanBand::faces
    float x = 0;             ///< centroid of the visible region, pixel-local
    float y = 0;
    double weight = 0;  ///< fraction of the pixel
    friend bool operator==(const SeenPart&, const SeenPart&) = default;
};

/// Some rows of the scanned picture: every pixel is in exactly one span or is one divided pixel.
struct ScanBand {
    int first_row = 0;
    int rows = 0;
    std::vector<SeenFace> faces;
    std::vector<Span> spans;                   ///< row by row, by rising x
    std::vector<std::uint32_t> span_begin;     ///< rows + 1 values, into `spans`
    std::vector<DividedPixel> divided;         ///< row by row, by rising x
    std::vector<std::uint32_t> divided_begin;  ///< rows + 1 values, into `divided`
    std::vector<SeenPart> parts;
    friend bool operator==(const ScanBand&, const ScanBand&) = default;
};

}  // namespace keikan

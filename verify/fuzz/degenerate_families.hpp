// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "keikan/model/pixel_case.hpp"

namespace keikan::fuzz {

/// What is degenerate about a random pixel. Two to seven polygons each, convex by exact signs.
enum class Family : std::uint8_t {
    Random,            ///< nothing: convex polygons of 3 to 6 corners, some beyond the pixel
    Grid8,             ///< coordinates are multiples of 1/8
    Grid4,             ///< coordinates are multiples of 1/4
    Fan,               ///< triangles around one vertex, neighbours sharing an edge
    MeshLayers,        ///< two triangulations of the same vertices, one before the other
    TJunction,         ///< vertices on other polygons' edges, exactly
    RoundedTJunction,  ///< the same, rounded: beside the edge by less than an ulp or so
    Sliver,            ///< 1e-3 to 1e-9 pixel thick
    NearParallel,      ///< edges at 1e-4 to 1e-15 rad to each other
    Collinear,         ///< edges that overlap in part, along a few lines
    UlpTwins,          ///< the same polygon with vertices moved by -1, 0 or +1 ulp
    Nested,            ///< one inside the other; holes in holes
    Border,            ///< vertices and edges on the pixel's border and corners
    Identical,         ///< the same polygon again, rotated start, either orientation
    TouchingInside,    ///< a polygon touches another's border from inside
    Notch,             ///< polygons that fill the notch others leave
    Duplicates,        ///< repeated points, collinear corners, polygons without area
    Denormal,          ///< coordinates of 1e-300, denormal numbers, signed zeros
    Huge,              ///< 1e6 pixels long, at pixel (4095, 2159)
    Cyclic,            ///< depth planes: bars that overlap in a cycle
    Interpenetrating,  ///< depth planes: faces through each other
    Coplanar,          ///< depth planes that agree to an ulp, or wholly
    Mixed,             ///< polygons from several of the families above
    GridUlp,           ///< two or three polygons of a 3 x 3 or 4 x 4 grid, vertices moved by -1, 0 or +1 ulp
    FarPowers,         ///< coordinates of any power of two that doubles have, beside usual ones
};

inline constexpr std::array<std::string_view, 25> kFamilyNames = {"random",
                                                                  "grid8",
                                                                  "grid4",
                                                                  "fan",
                                                                  "mesh-layers",
                                                                  "t-junction",
                                                                  "t-junction-rounded",
                                                                  "sliver",
                                                                  "near-parallel",
                                                                  "collinear",
                                                                  "ulp-twins",
                                                                  "nested",
                                                                  "border",
                                                                  "identical",
                                                                  "touching-inside",
                                                                  "notch",
                                                                  "duplicates",
                                                                  "denormal",
                                                                  "huge",
                                                                  "cyclic",
                                                                  "interpenetrating",
                                                                  "coplanar",
                                                                  "mixed",
                                                                  "grid-ulp",
                                                                  "far-powers"};

inline constexpr std::string_view name_of(Family family) {
    return kFamilyNames[static_cast<std::size_t>(family)];
}
std::optional<Family> family_of(std::string_view name);

/// The pixel case number `index` of a family under `seed`: the same for ever, on every machine, in any order.
/// About a quarter of the cases of families without planes of their own get random ones (not GridUlp). Its id
/// is "family/seed/index".
PixelCase degenerate_case(Family family, std::uint64_t seed, std::uint64_t index);

}  // namespace keikan::fuzz

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "keikan/scene/mesh.hpp"

namespace keikan {

/// Rows of equal windows on every wall that has room for them.
struct WindowDesign {
    int rows = 0;  ///< storeys with windows; 0: none
    double width_m = 1.2;
    double height_m = 1.4;
    double spacing_m = 2.6;  ///< between the centres of neighbours, at least
    double sill_m = 0.9;     ///< of the lowest row, above the floor
    double storey_m = 3.0;   ///< from row to row
    double recess_m = 0.12;  ///< how deep the pane lies behind the wall
};

/// A footprint extruded upwards.
struct BuildingDesign {
    enum class Roof {
        Flat,
        Gabled,  ///< ridge along the longer sides; rectangles only
    };
    std::string name = "building";
    std::vector<glm::dvec2>
        footprint_m;          ///< simple polygon, of either orientation, may be concave; not closed
    double floor_m = 0;       ///< world height of the floor: what height_m and sills are measured from
    double foundation_m = 0;  ///< how far the walls go on below the floor, into sloping ground
    double height_m = 8;      ///< floor to eaves
    Roof roof = Roof::Flat;
    double roof_height_m = 2.5;  ///< Gabled: eaves to ridge
    WindowDesign windows;
};

struct BuildingMaterials {
    std::uint16_t wall = 0;
    std::uint16_t roof = 0;
    std::uint16_t window = 0;
};

/// Builds a house as one closed mesh: walls divided around the windows, panes and reveals behind them, the
/// roof triangulated.
///
/// Walls are divided at the sides, sills and heads of their windows, on one grid for the wall and at the same
/// heights all around, so that faces meet only in whole edges. A wall has as many windows as bays of
/// spacing_m fit into it, each in the middle of its bay.
///
/// Properties:
///   (1) Closed: every edge belongs to two faces that run along it in opposite directions.
///   (2) Every face is convex and planar within kPlanarity.
///   (3) Without windows and foundation the volume is the footprint's area times the height (plus the roof).
///   (4) The footprint's orientation and first corner do not change what is seen.
///
/// Errors: InputError (reason only) for a footprint with fewer than three corners, without area, with two
///         equal corners or crossing or touching itself; sizes not positive and finite; windows that do not
///         fit; a gable on what is no rectangle (corners more than kRightAngleSlack off).
Object build_building(const BuildingDesign& design, const BuildingMaterials& materials);

/// Cosine of the angle between neighbouring sides of what still counts as a rectangle: 1 cm over 10 m, the
/// precision of surveyed outlines.
inline constexpr double kRightAngleSlack = 1e-3;

}  // namespace keikan

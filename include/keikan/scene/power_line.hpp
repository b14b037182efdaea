// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "keikan/scene/camera.hpp"
#include "keikan/scene/lattice_tower.hpp"
#include "keikan/scene/mesh.hpp"

namespace keikan {

/// A wire, or a bundle of equal ones, and how tightly it is strung.
///
/// Strung in one go, a line has the same horizontal tension in all its spans. `sag_m` states it by the sag of
/// the longest span (were its supports level); without a sag, tension over weight is used.
struct WireDesign {
    /// ACSR of 160, 240, 330, 410, 610, 810 mm2: 18.2, 22.4, 25.3, 28.5, 34.2, 38.4 mm.
    double diameter_m = 0.0285;
    int sub_conductors = 1;                      ///< 1, 2 (side by side) or 4 (in a square)
    double bundle_spacing_m = 0.5;               ///< between neighbouring sub-conductors
    double spacer_every_m = 50;                  ///< bundles only; 0: none
    double weight_n_per_m = 16.4;                ///< of one sub-conductor
    double horizontal_tension_n = 30'000;        ///< of one sub-conductor
    std::optional<double> sag_m = std::nullopt;  ///< replaces weight and tension
};

/// One tower of a line, where it differs from the line's.
struct RouteTower {
    double x_m = 0;
    double y_m = 0;
    /// Instead of the design's height: the body grows or shrinks below the waist, its legs keep their slope.
    std::optional<double> height_m = std::nullopt;
};

struct PowerLineMaterials {
    TowerMaterials tower;
    std::uint16_t conductor = 0;
    std::uint16_t ground_wire = 0;
    std::uint16_t spacer = 0;
};

struct PowerLineDesign {
    std::string name = "line";
    TowerDesign tower;
    std::vector<RouteTower> route;  ///< at least one; conductors need two
    WireDesign conductor{.sub_conductors = 4};
    WireDesign ground_wire{.diameter_m = 0.018, .weight_n_per_m = 8.5, .horizontal_tension_n = 20'000};
    PowerLineMaterials materials;
    /// None: Angles for towers whose legs show at least kAngleWidthPx, else Boxes.
    std::optional<TowerDetail> detail = std::nullopt;
};

/// What was built of one span, for notes and tests.
struct SpanSummary {
    int from_tower = 1;  ///< numbered from 1
    double span_m = 0;   ///< of the first conductor
    double rise_m = 0;
    double sag_m = 0;
    double lowest_above_ground_m = 0;  ///< the least clearance of any conductor at its segment ends
};

struct PowerLine {
    std::vector<Object> objects;
    std::vector<SpanSummary> spans;
    std::vector<std::size_t> members;  ///< for each tower
    std::vector<std::string> notes;    ///< levels of detail with their facets, spans with their sags
};

/// Ground height [m] at world (x, y).
using GroundHeight = std::function<double(double x_m, double y_m)>;

/// Stands the towers along the route, each turned along the bisector of its two spans, on legs that reach the
/// ground, and hangs the wires between them.
///
/// The base plane of a tower passes through the highest of its four feet; the other legs are extended, each
/// along its own slope, until they meet the ground.
///
/// Conductors are polygons in several levels of detail after Kaneda et al. 1991, chosen segment by segment
/// for `camera`: see WireLevel. Segments are so short that the chord stays within kChordErrorPx of the
/// catenary.
///
/// Objects, in order along the route:
///   "<name>/tower 3"                          Tower       steel and foundations
///   "<name>/tower 3 insulators"               Insulator
///   "<name>/span 3-4 circuit 1 phase 2"       Conductor   all sub-conductors; prisms, closed
///   "<name>/span 3-4 circuit 1 phase 2 far"   Conductor   ribbons, open
///   "<name>/span 3-4 ground wire 1"           Conductor   likewise
///   "<name>/span 3-4 spacers"                 Insulator
/// An object without faces is left out.
///
/// Properties:
///   (1) Every face is convex and its corners are within kPlanarity of one plane; prisms are closed.
///   (2) Segments are mitred: neighbours share their vertices (the same index) and every side is parallel to
///       its segment. Where the level changes, or a prism is turned anew, both end in the mitre's plane.
///   (3) The thickness seen is the true one within kThicknessError, however small it is on the screen.
///   (4) A wire's axis ends at the towers' attachment points; the axes of a bundle end around them.
///
/// Errors: InputError (reason only; the caller knows the place) for a design out of range, towers that stand
///         on the same spot, a route that turns by more than 120 degrees, ground that falls too steeply for
///         legs, or ground without a height (NaN).
PowerLine build_power_line(const PowerLineDesign& design, const GroundHeight& ground, const Camera& camera);

/// A wire as polygons: a prism with so many sides, or a ribbon that faces the viewer.
struct WireLevel {
    int sides;                ///< 0: ribbon
    double from_diameter_px;  ///< used where the diameter measures at least this on the screen
};
inline constexpr std::array<WireLevel, 5> kWireLevels{{{12, 8.0}, {8, 4.0}, {6, 2.0}, {4, 1.0}, {0, 0.0}}};

/// Chords stay within this of the catenary, in pixels at the segment's nearest point (no nearer than 1 m),
/// wherever in the picture that is.
inline constexpr double kChordErrorPx = 0.01;

/// Relative error of the thickness seen. The eye sees a straight segment from the same side all along. A
/// prism shows its full diameter across the direction that it was turned to, and is turned anew after
/// kPrismTurn: cos 10 deg = 0.985; a ribbon after kRibbonTurn: cos 2.5 deg = 0.999. Where a ribbon turns, in
/// two triangles, it does so by at most the sum of both, since segments are so short that the view turns by
/// no more than kPrismTurn from one to the next (down to 1/4096 of the span: only an eye within centimetres
/// of the wire's own line sees more).
inline constexpr double kThicknessError = 0.02;
inline constexpr double kPrismTurn = 0.1745;   ///< rad: 10 degrees
inline constexpr double kRibbonTurn = 0.0436;  ///< rad: 2.5 degrees

/// Towers whose legs are at least this thick on the screen are drawn as angle steel rather than boxes.
inline constexpr double kAngleWidthPx = 4;

}  // namespace keikan

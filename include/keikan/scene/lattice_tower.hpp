// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "keikan/scene/mesh.hpp"

namespace keikan {

/// How the conductors hang from the cross-arms.
struct InsulatorDesign {
    enum class Kind {
        I,  ///< one string straight down from the arm's tip
        V,  ///< two strings that meet under the arm: the conductor cannot swing
    };
    Kind kind = Kind::I;
    double length_m = 4.6;  ///< of one string, from the arm to the yoke
    int discs = 28;         ///< of one string
    double disc_diameter_m = 0.28;
    double v_half_width_m = 2.6;  ///< Kind::V: half the distance of the two upper ends
};

/// A suspension tower for two circuits of three phases: four battered legs up to a waist at the lowest
/// cross-arms, a slender cage above, three cross-arms on each side, and a peak (or a pair of short arms) for
/// the ground wire. Heights are above the base plane, on which the highest foot stands.
///
/// The defaults are a 500 kV tower of 80 m. (RENDERING.md 5: 60 to 110 m, legs 100 to 250 mm, bracing 50 to
/// 100 mm.)
struct TowerDesign {
    double height_m = 80;        ///< base plane to the top of the peak, body extension included
    double base_width_m = 14;    ///< distance of neighbouring legs at the base plane
    double waist_width_m = 3.6;  ///< the same at the lowest cross-arms
    double top_width_m = 2.0;    ///< the same at the upper chord of the highest cross-arms

    double peak_above_arm_m = 10;  ///< top of the tower above the lower chord of the highest arms
    double arm_spacing_m = 11.5;   ///< between the lower chords of the arms
    std::array<double, 3> arm_length_m{11.0, 12.5, 10.0};  ///< axis to tip: lowest, middle, highest arm
    double arm_depth_m = 2.6;                              ///< height of an arm at the body
    double ground_arm_m = 0;  ///< 0: one ground wire on the peak; else two, this far from the axis

    double leg_width_base_m = 0.25;  ///< flange of the angle steel, at the base ...
    double leg_width_top_m = 0.12;   ///< ... and at the peak; linear between
    double brace_width_base_m = 0.10;
    double brace_width_top_m = 0.06;
    double secondary_width_m = 0.05;  ///< redundant bracing

    InsulatorDesign insulator;
};

/// How much of a tower is drawn. Thickness is always the true one.
enum class TowerDetail {
    Angles,   ///< members are L-shaped angle steel with flanges a tenth of their width thick (10 faces each)
    Boxes,    ///< members are square boxes as wide as the angle's flange (6 faces each)
    Primary,  ///< as Boxes, without the secondary bracing; for those who ask for it
};

/// Where a tower stands.
struct TowerStand {
    glm::dvec3 base{0, 0, 0};  ///< the axis at the base plane
    double yaw_rad = 0;        ///< 0: the line runs along +y and the arms along x; positive turns x towards y
    /// How far each leg goes on below the base plane, along its own slope (leg extensions), at least 0.
    /// Feet in the order (-x -y), (+x -y), (+x +y), (-x +y) of the tower's own frame.
    std::array<double, 4> foot_drop_m{0, 0, 0, 0};
    TowerDetail detail = TowerDetail::Boxes;
    /// Insulator discs are frusta of so many sides; 0: the whole string is one slim prism.
    int disc_sides = 8;
};

struct TowerMaterials {
    std::uint16_t steel = 0;
    std::uint16_t insulator = 0;
    std::uint16_t foundation = 0;
};

/// A point that a wire is clamped to, in world coordinates.
struct Attachment {
    enum class Side { Left, Right, Centre };  ///< as seen along +y of the tower: Left is -x
    Side side = Side::Left;
    int circuit = 1;  ///< 1 left, 2 right; 0 for a ground wire
    int phase = 1;    ///< 1 lowest arm, 2 middle, 3 highest; for ground wires 1, 2 from left to right
    glm::dvec3 point{0, 0, 0};

    bool is_ground_wire() const { return circuit == 0; }
    /// "circuit 1 phase 3 (left)", "ground wire 1 (centre)".
    std::string name() const;
};

struct LatticeTower {
    Object steel;       ///< ObjectKind::Tower, with the foundations
    Object insulators;  ///< ObjectKind::Insulator
    /// Six conductors (circuit 1 phase 1, 2, 3, circuit 2 phase 1, 2, 3), then one or two ground wires.
    std::vector<Attachment> attachments;
    std::size_t members = 0;    ///< pieces of steel drawn
    std::size_t secondary = 0;  ///< of these, redundant bracing
    std::size_t panels = 0;     ///< of the body, feet and peak included
};

/// Builds a tower. Object names are `name` and `name + " insulators"`.
///
/// Members are straight prisms: every face is a parallelogram (the ends of an angle: two quads), planar by
/// construction. They end on the axes of the members that carry them, so they pass through each other, and
/// crossing diagonals touch back to back, as steel does.
///
/// Properties:
///   (1) Both meshes are closed: every edge belongs to two faces that run along it in opposite directions.
///   (2) Every face is convex, and its corners are within kPlanarity of one plane.
///   (3) Seen along the line, attachments are mirror images of each other.
///   (4) The same design with longer legs has the same steel above the base plane's leg panel.
///
/// Errors: InputError (reason only; the caller knows the place) for a design that cannot stand: sizes that
/// are
///         not positive and finite, widths that do not shrink upwards, arms below the waist panels, legs that
///         drop by more than half the height.
LatticeTower build_lattice_tower(const std::string& name, const TowerDesign& design, const TowerStand& stand,
                                 const TowerMaterials& materials);

/// Half the distance of a foot from the axis, along x and along y, at `drop_m` below the base plane: a leg
/// keeps its slope.
double foot_half_width_m(const TowerDesign& design, double drop_m);

/// What "planar" is worth after placing [m]: coordinates up to 1e5 m have a unit in the last place of 1.5e-11
/// m; a corner's three coordinates, and the plane's, are each off by a few of those.
inline constexpr double kPlanarity = 1e-9;

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#include "tower_steel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace keikan {

namespace {

/// The steel goes on so far into the ground, and the foundation so far around it: no gap opens where the
/// terrain is a little lower than its grid says.
constexpr double kFootDepth = 0.3;
constexpr double kFoundationBelow = 1.2;
constexpr double kFoundationAbove = 0.35;
/// Half the distance of an arm's chords at its tip, where the hanger's plates are.
constexpr double kArmTipHalf = 0.2;
/// Foundation width over leg width, as chimneys of pad foundations have.
constexpr double kFoundationShare = 3.5;

glm::dvec3 mix(glm::dvec3 a, glm::dvec3 b, double share) {
    return a + (b - a) * share;
}

/// How many equal parts the secondary bracing makes of a diagonal: bracing keeps angles of such widths from
/// buckling over about four metres.
int stiffened_parts(double height_m) {
    constexpr double kFreeLength = 4.2;
    return std::clamp(static_cast<int>(std::lround(height_m / kFreeLength)), 1, 4);
}

/// Builds members one by one, in the tower's frame.
class SteelWorks {
  public:
    SteelWorks(const TowerDesign& design, const TowerShape& shape, const TowerStand& stand,
               const TowerMaterials& materials)
        : design_(design),
          shape_(shape),
          stand_(stand),
          materials_(materials),
          profile_(stand.detail == TowerDetail::Angles ? SteelProfile::Angle : SteelProfile::Square) {}

    TowerSteel build() {
        legs();
        for (std::size_t i = 1; i < shape_.leg_levels().size(); ++i)
            leg_panel(shape_.leg_levels()[i], shape_.leg_levels()[i - 1]);
        for (std::size_t i = 1; i < shape_.cage_levels().size(); ++i)
            cage_panel(shape_.cage_levels()[i - 1], shape_.cage_levels()[i]);
        foot_panel();
        diaphragms();
        for (int arm = 0; arm < 3; ++arm)
            for (const double side : {-1.0, 1.0}) {
                const double z = shape_.arm_m(arm),
                             length = design_.arm_length_m[static_cast<std::size_t>(arm)];
                cross_arm(side, length, z, z + design_.arm_depth_m, z);
                if (design_.insulator.kind == InsulatorDesign::Kind::V)
                    hanger(side, length, z, length - 2 * design_.insulator.v_half_width_m);
            }
        if (shape_.has_ground_arms())
            for (const double side : {-1.0, 1.0})
                cross_arm(side, design_.ground_arm_m, design_.height_m - shape_.ground_arm_depth_m(),
                          design_.height_m, design_.height_m);
        foundations();
        return std::move(steel_);
    }

  private:
    void member(glm::dvec3 from, glm::dvec3 to, glm::dvec3 outward, double width, bool mirrored = false) {
        add_member(steel_.mesh, profile_, from, to, outward, width, materials_.steel, mirrored);
        ++steel_.members;
    }

    void secondary(glm::dvec3 from, glm::dvec3 to, glm::dvec3 outward) {
        if (stand_.detail == TowerDetail::Primary) return;
        member(from, to, outward, design_.secondary_width_m);
        ++steel_.secondary;
    }

    double foot_z(int leg) const { return -stand_.foot_drop_m[static_cast<std::size_t>(leg)]; }

    /// Outward normal of the face between legs k and k + 1, from its corners at two heights.
    glm::dvec3 face_normal(int k, double low, double high) const {
        const glm::dvec3 a = shape_.node(k, low), b = shape_.node((k + 1) % 4, low);
        return glm::normalize(glm::cross(b - a, shape_.node(k, high) - a));
    }

    /// One piece of leg between two heights; pieces meet at splices, each as thick as its place asks for.
    void leg_piece(int leg, double low, double high) {
        const glm::dvec3 from = shape_.node(leg, low), to = shape_.node(leg, high);
        // The heel looks out: flanges lie along the two faces. u = v x axis points to -y for v = +x.
        const bool x_positive = leg == 1 || leg == 2, y_positive = leg >= 2;
        member(from, to, {x_positive ? 1 : -1, 0, 0}, shape_.leg_width((low + high) / 2),
               x_positive != y_positive);
    }

    void legs() {
        const auto& below = shape_.leg_levels();
        const auto& above = shape_.cage_levels();
        for (int leg = 0; leg < 4; ++leg) {
            leg_piece(leg, foot_z(leg) - kFootDepth, below.back());
            for (std::size_t i = below.size() - 1; i > 0; --i) leg_piece(leg, below[i], below[i - 1]);
            for (std::size_t i = 1; i < above.size(); ++i) leg_piece(leg, above[i - 1], above[i]);
        }
    }

    /// Two diagonals back to back: one outside, one inside of the face's plane, touching in it.
    void crossed_diagonals(int k, double low, double high) {
        const int next = (k + 1) % 4;
        const glm::dvec3 normal = face_normal(k, low, high);
        const double width = shape_.brace_width((low + high) / 2);
        const glm::dvec3 aside = normal * (width / 2);
        member(shape_.node(k, low) + aside, shape_.node(next, high) + aside, -normal, width);
        member(shape_.node(next, low) - aside, shape_.node(k, high) - aside, normal, width);
    }

    void cage_panel(double low, double high) {
        ++steel_.panels;
        for (int k = 0; k < 4; ++k) crossed_diagonals(k, low, high);
    }

    /// An X in each face; in tall panels, short struts from the diagonals to the legs.
    void leg_panel(double low, double high) {
        ++steel_.panels;
        const int parts = stiffened_parts((high - low) / 2 * 1.25);
        for (int k = 0; k < 4; ++k) {
            crossed_diagonals(k, low, high);
            if (parts < 2) continue;
            const glm::dvec3 normal = face_normal(k, low, high);
            // The diagonals of a trapezoid cross where the widths divide its height.
            const double cross = low + (high - low) * shape_.half_width(low) /
                                           (shape_.half_width(low) + shape_.half_width(high));
            const glm::dvec3 centre = mix(shape_.node(k, cross), shape_.node((k + 1) % 4, cross), 0.5);
            for (const int leg : {k, (k + 1) % 4})
                for (const double end : {low, high}) strut_half_diagonal(leg, end, centre, parts, normal);
        }
    }

    /// Divides a half diagonal, from the leg's node at height `end` to `centre`, and struts it against the
    /// leg: from every point one horizontally, and one on towards the centre's height.
    void strut_half_diagonal(int leg, double end, glm::dvec3 centre, int parts, glm::dvec3 normal) {
        const glm::dvec3 foot = shape_.node(leg, end);
        for (int j = 1; j < parts; ++j) {
            const glm::dvec3 on_diagonal = mix(foot, centre, double(j) / parts);
            const double next_z = end + (centre.z - end) * (j + 1) / parts;
            secondary(shape_.node(leg, on_diagonal.z), on_diagonal, normal);
            secondary(shape_.node(leg, next_z), on_diagonal, normal);
        }
    }

    /// The lowest panel: a K in each face, its arms from the feet to the middle of the horizontal above. Each
    /// leg may end at its own depth.
    void foot_panel() {
        ++steel_.panels;
        const double top = shape_.leg_levels().back();
        const double width = shape_.brace_width(0) * 1.2;
        for (int k = 0; k < 4; ++k) {
            const int next = (k + 1) % 4;
            const glm::dvec3 normal = face_normal(k, 0, top);
            const glm::dvec3 middle = mix(shape_.node(k, top), shape_.node(next, top), 0.5);
            for (const int leg : {k, next}) {
                const glm::dvec3 foot = shape_.node(leg, foot_z(leg));
                const int parts = stiffened_parts(top - foot.z) + 1;
                member(foot, middle, normal, width, leg == k);
                for (int j = 1; j < parts; ++j) {
                    const glm::dvec3 on_diagonal = mix(foot, middle, double(j) / parts);
                    const double next_z = foot.z + (top - foot.z) * (j + 1) / parts;
                    secondary(shape_.node(leg, on_diagonal.z), on_diagonal, normal);
                    secondary(shape_.node(leg, next_z), on_diagonal, normal);
                }
            }
        }
        // Hips: across each corner, between the K arms of its two faces.
        for (int leg = 0; leg < 4; ++leg) {
            const glm::dvec3 foot = shape_.node(leg, foot_z(leg));
            const glm::dvec3 one = mix(shape_.node(leg, top), shape_.node((leg + 1) % 4, top), 0.5);
            const glm::dvec3 other = mix(shape_.node(leg, top), shape_.node((leg + 3) % 4, top), 0.5);
            const int parts = stiffened_parts(top - foot.z) + 1;
            for (int j = 1; j < parts; ++j)
                secondary(mix(foot, one, double(j) / parts), mix(foot, other, double(j) / parts), {0, 0, 1});
        }
    }

    /// The four horizontals at a height; and inside them a diamond between their middles, or a cross.
    enum class Inside { Nothing, Diamond, Cross };
    void ring(double z, Inside inside) {
        const double width = shape_.brace_width(z);
        for (int k = 0; k < 4; ++k)
            member(shape_.node(k, z), shape_.node((k + 1) % 4, z), face_normal(k, z - 1, z), width);
        if (inside == Inside::Diamond)
            for (int k = 0; k < 4; ++k)
                member(mix(shape_.node(k, z), shape_.node((k + 1) % 4, z), 0.5),
                       mix(shape_.node((k + 1) % 4, z), shape_.node((k + 2) % 4, z), 0.5), {0, 0, 1}, width);
        if (inside == Inside::Cross) {
            const glm::dvec3 aside{0, 0, width / 2};
            member(shape_.node(0, z) + aside, shape_.node(2, z) + aside, {0, 0, -1}, width);
            member(shape_.node(1, z) - aside, shape_.node(3, z) - aside, {0, 0, 1}, width);
        }
    }

    void diaphragms() {
        const auto& below = shape_.leg_levels();
        ring(below.back(), Inside::Diamond);
        for (std::size_t i = 1; i + 1 < below.size(); ++i)
            ring(below[i], i % 2 == 0 ? Inside::Cross : Inside::Nothing);
        for (int arm = 0; arm < 3; ++arm) {
            ring(shape_.arm_m(arm), Inside::Cross);
            ring(shape_.arm_m(arm) + design_.arm_depth_m, Inside::Nothing);
        }
        if (shape_.has_ground_arms()) {
            ring(design_.height_m - shape_.ground_arm_depth_m(), Inside::Nothing);
            ring(design_.height_m, Inside::Cross);
        }
    }

    /// A three-dimensional truss that narrows to its tip: two lower chords from height `low`, two upper
    /// chords from `high`, all four meeting at height `tip_z`; struts and diagonals in its four sides.
    void cross_arm(double side, double length, double low, double high, double tip_z) {
        const double chord = shape_.leg_width(high) * 0.8, lattice = shape_.brace_width(low) * 0.9;
        const std::array<double, 2> edge{-1, 1};
        const double low_half = shape_.half_width(low), high_half = shape_.half_width(high);
        const int panels = std::clamp(static_cast<int>(std::lround((length - low_half) / 1.9)), 2, 8);
        const auto at = [&](bool upper, std::size_t e, int i) {
            const double half = upper ? high_half : low_half;
            return mix({side * half, edge[e] * half, upper ? high : low},
                       {side * length, edge[e] * kArmTipHalf, tip_z}, double(i) / panels);
        };
        const glm::dvec3 up{0, 0, 1};
        for (std::size_t e = 0; e < 2; ++e) {
            const glm::dvec3 out{0, edge[e], 0};
            // Heels along the truss's edges: -u or +u as the chord runs outwards on the one or the other
            // side.
            member(at(false, e, 0), at(false, e, panels), out, chord, side * edge[e] > 0);
            member(at(true, e, 0), at(true, e, panels), out, chord, side * edge[e] < 0);
            for (int i = 1; i < panels; ++i) {
                member(at(false, e, i), at(true, e, i), out, lattice);
                member(at(true, e, i - 1), at(false, e, i), out, lattice);
            }
        }
        for (int i = 1; i <= panels; ++i) {
            const std::size_t zig = static_cast<std::size_t>(i) % 2;
            member(at(false, 0, i), at(false, 1, i), -up, lattice);
            member(at(false, zig, i - 1), at(false, 1 - zig, i), -up, lattice);
            if (i == panels) break;
            member(at(true, 0, i), at(true, 1, i), up, lattice);
            member(at(true, 1 - zig, i - 1), at(true, zig, i), up, lattice);
        }
    }

    /// Carries the inner ends of V-strings: a strut between the lower chords at `x`.
    void hanger(double side, double length, double low, double x) {
        const double half = shape_.half_width(low), share = (x - half) / (length - half);
        const double y = half + (kArmTipHalf - half) * share;
        member({side * x, -y, low}, {side * x, y, low}, {0, 0, -1}, shape_.brace_width(low));
    }

    void foundations() {
        const double width = kFoundationShare * design_.leg_width_base_m;
        for (int leg = 0; leg < 4; ++leg) {
            const glm::dvec3 foot = shape_.node(leg, foot_z(leg));
            add_member(steel_.mesh, SteelProfile::Square, foot - glm::dvec3(0, 0, kFoundationBelow),
                       foot + glm::dvec3(0, 0, kFoundationAbove), {1, 0, 0}, width, materials_.foundation);
        }
    }

    const TowerDesign& design_;
    const TowerShape& shape_;
    const TowerStand& stand_;
    const TowerMaterials& materials_;
    SteelProfile profile_;
    TowerSteel steel_;
};

}  // namespace

TowerSteel tower_steel(const TowerDesign& design, const TowerShape& shape, const TowerStand& stand,
                       const TowerMaterials& materials) {
    return SteelWorks(design, shape, stand, materials).build();
}

}  // namespace keikan

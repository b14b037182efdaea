// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/lattice_tower.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "keikan/support/input_error.hpp"
#include "prism_parts.hpp"
#include "tower_shape.hpp"
#include "tower_steel.hpp"

namespace keikan {

namespace {

/// Link between arm and string, and between string and yoke.
constexpr double kLinkLength = 0.25;
constexpr double kLinkWidth = 0.06;
/// Shank between two discs, over the disc's diameter.
constexpr double kShankShare = 0.3;

/// The silhouette of `discs` discs along [from_m, to_m]: for each a cone that opens, an underside, a shank.
std::vector<LatheRing> disc_rings(const InsulatorDesign& design, double from_m, double to_m,
                                  double to_polygon) {
    const double pitch = (to_m - from_m) / design.discs;
    const double disc = design.disc_diameter_m / 2 * to_polygon, shank = disc * kShankShare;
    std::vector<LatheRing> rings;
    rings.reserve(static_cast<std::size_t>(design.discs) * 3 + 1);
    for (int i = 0; i < design.discs; ++i) {
        const double start = from_m + pitch * i;
        rings.push_back({start, shank});
        rings.push_back({start + 0.55 * pitch, disc});
        rings.push_back({start + 0.75 * pitch, shank});
    }
    rings.push_back({to_m, shank});
    return rings;
}

/// A string from the arm to the yoke, with its links.
void add_string(Mesh& mesh, const InsulatorDesign& design, glm::dvec3 from, glm::dvec3 to, int disc_sides,
                const TowerMaterials& materials) {
    const glm::dvec3 along = to - from;
    const double length = glm::length(along), link = std::min(kLinkLength, length / 4);
    const glm::dvec3 axis = along / length, across{0, 1, 0};
    add_member(mesh, SteelProfile::Square, from, from + axis * link, across, kLinkWidth, materials.steel);
    add_member(mesh, SteelProfile::Square, to - axis * link, to, across, kLinkWidth, materials.steel);
    if (disc_sides > 0) {
        add_lathe(mesh, from, axis,
                  disc_rings(design, link, length - link, radius_of_equal_width(disc_sides)), disc_sides,
                  materials.insulator);
    } else {
        // As wide as the discs' silhouette in the mean: 0.75 of the pitch tapers, 0.25 is shank.
        constexpr int kSides = 4;
        const double mean = 0.75 * (1 + kShankShare) / 2 + 0.25 * kShankShare;
        const double radius = design.disc_diameter_m / 2 * mean * radius_of_equal_width(kSides);
        add_lathe(mesh, from, axis, std::array<LatheRing, 2>{{{link, radius}, {length - link, radius}}},
                  kSides, materials.insulator);
    }
}

/// The tower's own frame to the world: a turn about the vertical, then the base.
struct WorldFromTower {
    explicit WorldFromTower(const TowerStand& stand)
        : base(stand.base), cosine(std::cos(stand.yaw_rad)), sine(std::sin(stand.yaw_rad)) {}
    glm::dvec3 operator()(glm::dvec3 p) const {
        return base + glm::dvec3(cosine * p.x - sine * p.y, sine * p.x + cosine * p.y, p.z);
    }
    glm::dvec3 base;
    double cosine, sine;
};

}  // namespace

std::string Attachment::name() const {
    const char* where = side == Side::Left ? " (left)" : side == Side::Right ? " (right)" : " (centre)";
    if (is_ground_wire()) return "ground wire " + std::to_string(phase) + where;
    return "circuit " + std::to_string(circuit) + " phase " + std::to_string(phase) + where;
}

LatticeTower build_lattice_tower(const std::string& name, const TowerDesign& design, const TowerStand& stand,
                                 const TowerMaterials& materials) {
    const TowerShape shape(design);
    const WorldFromTower world_from_tower(stand);
    for (const double drop : stand.foot_drop_m)
        if (!(drop >= 0 && drop <= design.height_m / 2))
            throw InputError("tower: the ground falls too steeply under its legs");
    if (stand.disc_sides != 0 && stand.disc_sides < 3)
        throw InputError("tower: insulator discs need three sides");

    TowerSteel steel = tower_steel(design, shape, stand, materials);
    LatticeTower tower;
    tower.members = steel.members;
    tower.secondary = steel.secondary;
    tower.panels = steel.panels;
    tower.steel = {name, ObjectKind::Tower, std::move(steel.mesh)};
    tower.insulators = {name + " insulators", ObjectKind::Insulator, {}};
    Mesh& strings = tower.insulators.mesh;

    using Side = Attachment::Side;
    const InsulatorDesign& insulator = design.insulator;
    for (int circuit = 1; circuit <= 2; ++circuit) {
        const double side = circuit == 1 ? -1 : 1;
        for (int arm = 0; arm < 3; ++arm) {
            const double tip = design.arm_length_m[static_cast<std::size_t>(arm)], z = shape.arm_m(arm);
            glm::dvec3 yoke;
            if (insulator.kind == InsulatorDesign::Kind::I) {
                yoke = {side * tip, 0, z - insulator.length_m};
                add_string(strings, insulator, {side * tip, 0, z}, yoke, stand.disc_sides, materials);
            } else {
                const double half = insulator.v_half_width_m;
                yoke = {side * (tip - half), 0,
                        z - std::sqrt(insulator.length_m * insulator.length_m - half * half)};
                for (const double x : {tip - 2 * half, tip})
                    add_string(strings, insulator, {side * x, 0, z}, yoke, stand.disc_sides, materials);
            }
            tower.attachments.push_back(
                {side < 0 ? Side::Left : Side::Right, circuit, arm + 1, world_from_tower(yoke)});
        }
    }
    if (shape.has_ground_arms()) {
        for (const double side : {-1.0, 1.0})
            tower.attachments.push_back({side < 0 ? Side::Left : Side::Right, 0, side < 0 ? 1 : 2,
                                         world_from_tower({side * design.ground_arm_m, 0, design.height_m})});
    } else {
        tower.attachments.push_back({Side::Centre, 0, 1, world_from_tower({0, 0, design.height_m})});
    }

    for (Mesh* mesh : {&tower.steel.mesh, &strings}) {
        for (glm::dvec3& p : mesh->positions) p = world_from_tower(p);
        mesh->closed = true;
    }
    return tower;
}

double foot_half_width_m(const TowerDesign& design, double drop_m) {
    return TowerShape(design).half_width(-drop_m);
}

}  // namespace keikan

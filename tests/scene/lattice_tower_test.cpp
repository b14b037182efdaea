// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/lattice_tower.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "keikan/support/input_error.hpp"
#include "mesh_facts.hpp"
#include "tower_shape.hpp"

using namespace keikan;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

LatticeTower tower_of(const TowerDesign& design, const TowerStand& stand = {}) {
    return build_lattice_tower("tower", design, stand, {.steel = 1, .insulator = 2, .foundation = 3});
}

TowerDesign design_of_height(double height_m) {
    TowerDesign design;
    design.height_m = height_m;
    design.base_width_m = 14.0 * height_m / 80;
    return design;
}

void check_solid(const Mesh& mesh) {
    REQUIRE(is_well_formed(mesh));
    CHECK(mesh.closed);
    CHECK(open_edges(mesh) == 0);
    CHECK(largest_distance_from_plane(mesh) < kPlanarity);
    CHECK(smallest_turn(mesh) > 0);
    const std::vector<double> volumes = sixfold_volumes(mesh);
    CHECK(*std::min_element(volumes.begin(), volumes.end()) > 0);
}

/// How many edges of the mesh cross the height z within `reach` of a point, seen from above.
int edges_across(const Mesh& mesh, glm::dvec3 near, double reach) {
    int count = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto corners = mesh.face(f);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec3 p = mesh.positions[corners[i]],
                             q = mesh.positions[corners[i + 1 < corners.size() ? i + 1 : 0]];
            if (!(p.z < near.z && near.z <= q.z)) continue;  // upwards: of two faces with the edge, in one
            const glm::dvec3 at = p + (near.z - p.z) / (q.z - p.z) * (q - p);
            count += std::abs(at.x - near.x) <= reach && std::abs(at.y - near.y) <= reach;
        }
    }
    return count;
}

}  // namespace

TEST_CASE("lattice_tower: between two levels each leg is one piece, and stands where it should",
          "[scene][tower]") {
    const TowerDesign design;
    const TowerShape shape(design);
    const Mesh mesh = tower_of(design, {.detail = TowerDetail::Primary}).steel.mesh;
    const double reach = 1.2 * design.leg_width_base_m;
    int held = 0;
    const auto holds = [&](double low, double high) {
        if (shape.half_width(high) < 2 * reach) return;  // at the peak the legs come together
        ++held;
        for (int leg = 0; leg < 4; ++leg) {
            // A quarter of the way up diagonals are far from the legs. A box has four edges along it.
            const glm::dvec3 place = shape.node(leg, low + (high - low) / 4);
            INFO("leg " << leg << " from " << low << " to " << high);
            CHECK(edges_across(mesh, place, reach) == 4);
        }
    };
    for (std::size_t i = 1; i < shape.leg_levels().size(); ++i) {
        const double a = shape.leg_levels()[i - 1], b = shape.leg_levels()[i];
        holds(std::min(a, b), std::max(a, b));
    }
    for (std::size_t i = 1; i < shape.cage_levels().size(); ++i)
        holds(shape.cage_levels()[i - 1], shape.cage_levels()[i]);
    CHECK(held >= 12);
}

TEST_CASE("lattice_tower: every member is a closed, convex-faced, planar solid that looks outwards",
          "[scene][tower]") {
    for (const double height : {60.0, 80.0, 110.0})
        for (const auto detail : {TowerDetail::Angles, TowerDetail::Boxes, TowerDetail::Primary})
            for (const auto kind : {InsulatorDesign::Kind::I, InsulatorDesign::Kind::V}) {
                INFO("height " << height << " detail " << static_cast<int>(detail));
                TowerDesign design = design_of_height(height);
                design.insulator.kind = kind;
                design.ground_arm_m = kind == InsulatorDesign::Kind::V ? 6 : 0;
                TowerStand stand{.base = {48'211.3, -71'003.7, 1834.2}, .yaw_rad = 0.7};
                stand.foot_drop_m = {0, 3.25, 7.5, 1.125};
                stand.detail = detail;
                stand.disc_sides = detail == TowerDetail::Primary ? 0 : 6;
                const LatticeTower tower = tower_of(design, stand);
                check_solid(tower.steel.mesh);
                check_solid(tower.insulators.mesh);
            }
}

TEST_CASE("lattice_tower: 60 to 110 m of tower take 300 to 1,000 members", "[scene][tower]") {
    for (const double height : {60.0, 80.0, 103.0, 110.0}) {
        const LatticeTower tower = tower_of(design_of_height(height));
        INFO("height " << height << " members " << tower.members << " secondary " << tower.secondary);
        CHECK(tower.members >= 300);
        CHECK(tower.members <= 1000);
        CHECK(tower.secondary >= tower.members / 20);
        // Each member is a part of its own; the four foundations come on top.
        CHECK(sixfold_volumes(tower.steel.mesh).size() == tower.members + 4);
        CHECK(tower.steel.mesh.face_count() == (tower.members + 4) * 6);
    }
}

TEST_CASE("lattice_tower: angle steel has ten faces a member, a tenth of the box's steel, and the same reach",
          "[scene][tower]") {
    const LatticeTower boxes = tower_of({});
    const LatticeTower angles = tower_of({}, {.detail = TowerDetail::Angles});
    CHECK(angles.members == boxes.members);
    CHECK(angles.steel.mesh.face_count() == boxes.members * 10 + 4 * 6);
    const Box one = bounding_box(boxes.steel.mesh), other = bounding_box(angles.steel.mesh);
    CHECK(glm::length(one.low - other.low) < 0.06);
    CHECK(glm::length(one.high - other.high) < 0.06);
}

TEST_CASE("lattice_tower: the primary detail leaves out the secondary bracing and nothing else",
          "[scene][tower]") {
    const LatticeTower full = tower_of({});
    const LatticeTower primary = tower_of({}, {.detail = TowerDetail::Primary});
    CHECK(primary.secondary == 0);
    CHECK(primary.members == full.members - full.secondary);
}

TEST_CASE("lattice_tower: it is as high and as wide as designed, and stands below its base plane",
          "[scene][tower]") {
    const TowerDesign design;
    const Box box = bounding_box(tower_of(design).steel.mesh);
    CHECK_THAT(box.high.z, WithinAbs(design.height_m, design.leg_width_top_m));
    CHECK(box.low.z < 0);
    const double longest = *std::max_element(design.arm_length_m.begin(), design.arm_length_m.end());
    CHECK_THAT(box.high.x, WithinAbs(longest, 0.2));
    CHECK_THAT(box.low.x, WithinAbs(-longest, 0.2));
    const double foot = foot_half_width_m(design, 0);
    CHECK_THAT(foot, WithinAbs(design.base_width_m / 2, 1e-12));
    CHECK_THAT(box.high.y, WithinAbs(foot, 2.5 * design.leg_width_base_m));
}

TEST_CASE("lattice_tower: attachments are mirror images of each other about the line", "[scene][tower]") {
    for (const auto kind : {InsulatorDesign::Kind::I, InsulatorDesign::Kind::V})
        for (const double ground_arm : {0.0, 5.0}) {
            TowerDesign design;
            design.insulator.kind = kind;
            design.ground_arm_m = ground_arm;
            const auto attachments = tower_of(design).attachments;
            REQUIRE(attachments.size() == (ground_arm > 0 ? 8u : 7u));
            for (std::size_t phase = 0; phase < 3; ++phase) {
                const Attachment &left = attachments[phase], &right = attachments[phase + 3];
                CHECK(left.circuit == 1);
                CHECK(right.circuit == 2);
                CHECK(left.phase == right.phase);
                CHECK(left.point.x == -right.point.x);
                CHECK(left.point.y == 0);
                CHECK(left.point.z == right.point.z);
                CHECK(right.point.x <= design.arm_length_m[phase]);
            }
            if (ground_arm > 0)
                CHECK(attachments[6].point.x == -attachments[7].point.x);
            else
                CHECK(attachments[6].point == glm::dvec3(0, 0, design.height_m));
            std::set<std::string> names;
            for (const Attachment& attachment : attachments) names.insert(attachment.name());
            CHECK(names.size() == attachments.size());
            CHECK(names.count("circuit 2 phase 3 (right)") == 1);
        }
}

TEST_CASE("lattice_tower: an I-string hangs its conductor one string below the tip of the arm",
          "[scene][tower]") {
    const TowerDesign design;
    const Attachment top = tower_of(design).attachments[5];
    const double arm = design.height_m - design.peak_above_arm_m;
    CHECK_THAT(top.point.x, WithinAbs(design.arm_length_m[2], 1e-12));
    CHECK_THAT(top.point.z, WithinAbs(arm - design.insulator.length_m, 1e-12));
}

TEST_CASE(
    "lattice_tower: insulator discs measure what they should, and the slim string is as wide in the mean",
    "[scene][tower]") {
    const TowerDesign design;
    const LatticeTower discs = tower_of(design), slim = tower_of(design, {.disc_sides = 0});
    // Per string: two links of 6 faces, 28 discs of 3 bands of 8 sides, and two ends.
    CHECK(discs.insulators.mesh.face_count() == 6 * (12 + 28 * 3 * 8 + 2));
    CHECK(slim.insulators.mesh.face_count() == 6 * (12 + 4 + 2));
    const double tip = design.arm_length_m[1];
    const double reach = bounding_box(discs.insulators.mesh).high.x - tip;
    CHECK_THAT(reach,
               WithinAbs(design.insulator.disc_diameter_m / 2, 0.05 * design.insulator.disc_diameter_m));
}

TEST_CASE("lattice_tower: yaw turns the arms, and a turn by 90 degrees swaps the axes", "[scene][tower]") {
    const auto straight = tower_of({}).attachments;
    const auto turned = tower_of({}, {.base = {100, 200, 30}, .yaw_rad = std::acos(-1.0) / 2}).attachments;
    for (std::size_t i = 0; i < straight.size(); ++i) {
        CHECK_THAT(turned[i].point.x, WithinAbs(100 - straight[i].point.y, 1e-12));
        CHECK_THAT(turned[i].point.y, WithinAbs(200 + straight[i].point.x, 1e-12));
        CHECK_THAT(turned[i].point.z, WithinAbs(30 + straight[i].point.z, 1e-12));
    }
}

TEST_CASE("lattice_tower: a leg extension reaches its foot and leaves the steel above the leg panel alone",
          "[scene][tower]") {
    const TowerDesign design;
    const LatticeTower level = tower_of(design);
    TowerStand stand;
    stand.foot_drop_m = {0, 0, 6, 0};  // the leg at +x +y
    const LatticeTower extended = tower_of(design, stand);
    const double foot = foot_half_width_m(design, 6);
    CHECK(foot > foot_half_width_m(design, 0));
    const Box box = bounding_box(extended.steel.mesh);
    CHECK(box.low.z < -6);
    CHECK(box.high.x >= foot);
    CHECK_THAT(bounding_box(level.steel.mesh).low.z - box.low.z, WithinAbs(6, 0.05));
    const auto above = [](const Mesh& mesh) {
        std::multiset<double> heights;
        for (const glm::dvec3& p : mesh.positions)
            if (p.z > 20) heights.insert(p.z);
        return heights;
    };
    CHECK(above(level.steel.mesh) == above(extended.steel.mesh));
}

TEST_CASE("lattice_tower: panels grow downwards, to the base plane, and are about as tall as wide",
          "[scene][tower]") {
    for (const double height : {60.0, 80.0, 110.0}) {
        const TowerShape shape(design_of_height(height));
        std::vector<double> levels = shape.leg_levels();
        CHECK(levels.front() == shape.waist_m());
        levels.push_back(0);
        for (std::size_t i = 1; i < levels.size(); ++i) {
            const double panel = levels[i - 1] - levels[i];
            if (i > 1) CHECK(panel > levels[i - 2] - levels[i - 1]);
            const double width = 2 * shape.half_width(levels[i - 1]);
            CHECK(panel / width > 0.9);
            CHECK(panel / width < 1.5);
        }
        CHECK(shape.cage_levels().front() == shape.waist_m());
        CHECK(shape.cage_levels().back() == height);
        CHECK(tower_of(design_of_height(height)).panels ==
              levels.size() - 1 + shape.cage_levels().size() - 1);
    }
}

TEST_CASE("lattice_tower: what cannot stand is bad input", "[scene][tower]") {
    const auto broken = [](auto change) {
        TowerDesign design;
        change(design);
        return design;
    };
    CHECK_THROWS_AS(tower_of(broken([](auto& d) { d.height_m = -1; })), InputError);
    CHECK_THROWS_AS(tower_of(broken([](auto& d) { d.height_m = 30; })), InputError);
    CHECK_THROWS_AS(tower_of(broken([](auto& d) { d.height_m = NAN; })), InputError);
    CHECK_THROWS_AS(tower_of(broken([](auto& d) { d.top_width_m = 20; })), InputError);
    CHECK_THROWS_AS(tower_of(broken([](auto& d) { d.arm_length_m[1] = 0; })), InputError);
    CHECK_THROWS_AS(tower_of(broken([](auto& d) { d.insulator.discs = 0; })), InputError);
    CHECK_THROWS_AS(tower_of(broken([](auto& d) { d.insulator.length_m = 50; })), InputError);
    CHECK_THROWS_WITH(tower_of(broken([](auto& d) { d.arm_spacing_m = 2; })), Contains("arm_spacing_m"));
    CHECK_THROWS_AS(tower_of({}, {.foot_drop_m = {0, 0, 0, -1}}), InputError);
    CHECK_THROWS_AS(tower_of({}, {.foot_drop_m = {0, 60, 0, 0}}), InputError);
}

// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/building.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "keikan/scene/lattice_tower.hpp"
#include "keikan/support/input_error.hpp"
#include "mesh_facts.hpp"

using namespace keikan;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;

namespace {

constexpr BuildingMaterials kMaterials{.wall = 1, .roof = 2, .window = 3};

BuildingDesign on(std::vector<glm::dvec2> footprint) {
    BuildingDesign design;
    design.footprint_m = std::move(footprint);
    return design;
}

const std::vector<glm::dvec2> kRectangle{{0, 0}, {18, 0}, {18, 9}, {0, 9}};
const std::vector<glm::dvec2> kLetterL{{0, 0}, {20, 0}, {20, 8}, {9, 8}, {9, 15}, {0, 15}};

double volume(const Object& house) {
    const std::vector<double> parts = sixfold_volumes(house.mesh);
    return std::accumulate(parts.begin(), parts.end(), 0.0) / 6;
}

std::size_t faces_of(const Object& house, std::uint16_t material) {
    return static_cast<std::size_t>(
        std::count(house.mesh.face_material.begin(), house.mesh.face_material.end(), material));
}

void check_house(const Object& house) {
    REQUIRE(is_well_formed(house.mesh));
    CHECK(house.kind == ObjectKind::Building);
    CHECK(house.mesh.closed);
    CHECK(open_edges(house.mesh) == 0);
    CHECK(largest_distance_from_plane(house.mesh) < kPlanarity);
    CHECK(smallest_turn(house.mesh) > 0);
    CHECK(volume(house) > 0);
}

}  // namespace

TEST_CASE("building: closed, planar and convex, with and without windows and gables, of either orientation",
          "[scene][building]") {
    for (const auto& footprint : {kRectangle, kLetterL})
        for (const bool reversed : {false, true})
            for (const int rows : {0, 1, 2})
                for (const auto roof : {BuildingDesign::Roof::Flat, BuildingDesign::Roof::Gabled}) {
                    if (roof == BuildingDesign::Roof::Gabled && footprint.size() != 4) continue;
                    BuildingDesign design = on(footprint);
                    if (reversed) std::reverse(design.footprint_m.begin(), design.footprint_m.end());
                    const double c = std::cos(0.6), s = std::sin(0.6);
                    for (glm::dvec2& p : design.footprint_m)
                        p = glm::dvec2(81'234.5, -44'321.7) +
                            glm::dvec2(c * p.x - s * p.y, s * p.x + c * p.y);
                    design.roof = roof;
                    design.windows.rows = rows;
                    design.floor_m = 731.25;
                    design.foundation_m = 2.5;
                    check_house(build_building(design, kMaterials));
                }
}

TEST_CASE("building: the volume is footprint times height, and a gable adds half a box",
          "[scene][building]") {
    CHECK_THAT(volume(build_building(on(kRectangle), kMaterials)), WithinRel(18.0 * 9 * 8, 1e-12));
    CHECK_THAT(volume(build_building(on(kLetterL), kMaterials)), WithinRel((20.0 * 8 + 9 * 7) * 8, 1e-12));
    BuildingDesign gabled = on(kRectangle);
    gabled.roof = BuildingDesign::Roof::Gabled;
    CHECK_THAT(volume(build_building(gabled, kMaterials)), WithinRel(18.0 * 9 * (8 + 2.5 / 2), 1e-12));
    BuildingDesign deep = on(kRectangle);
    deep.foundation_m = 3;
    CHECK_THAT(volume(build_building(deep, kMaterials)), WithinRel(18.0 * 9 * 11, 1e-12));
}

TEST_CASE("building: each window is a pane behind four reveals, and takes its recess from the volume",
          "[scene][building]") {
    BuildingDesign design = on(kRectangle);
    design.windows.rows = 2;
    const Object house = build_building(design, kMaterials);
    // Bays of at least 2.6 m: 6 in 18 m, 3 in 9 m; two rows of 18.
    CHECK(faces_of(house, 3) == 36);
    const double recessed = 36 * 1.2 * 1.4 * 0.12;
    CHECK_THAT(volume(house), WithinRel(18.0 * 9 * 8 - recessed, 1e-12));
}

TEST_CASE("building: walls too short for a window have none", "[scene][building]") {
    BuildingDesign design = on({{0, 0}, {2.5, 0}, {2.5, 9}, {0, 9}});
    design.windows.rows = 2;
    const Object house = build_building(design, kMaterials);
    check_house(house);
    CHECK(faces_of(house, 3) == 2 * 2 * 3);
}

TEST_CASE("building: a gable stands over the shorter sides, wherever the footprint starts",
          "[scene][building]") {
    for (std::size_t first = 0; first < 4; ++first) {
        BuildingDesign design = on(kRectangle);
        std::rotate(design.footprint_m.begin(),
                    design.footprint_m.begin() + static_cast<std::ptrdiff_t>(first),
                    design.footprint_m.end());
        design.roof = BuildingDesign::Roof::Gabled;
        const Object house = build_building(design, kMaterials);
        check_house(house);
        CHECK(faces_of(house, 2) == 2);
        double ridge_span = 0, high = design.height_m + design.roof_height_m;
        for (const glm::dvec3& p : house.mesh.positions)
            for (const glm::dvec3& q : house.mesh.positions)
                if (p.z == high && q.z == high) ridge_span = std::max(ridge_span, std::abs(p.x - q.x));
        CHECK(ridge_span == 18);
    }
}

TEST_CASE("building: a rectangle surveyed to a centimetre still gets its gable, folded where it must be",
          "[scene][building]") {
    BuildingDesign design = on({{0, 0}, {18, 0.005}, {18, 9}, {0, 9.004}});
    design.roof = BuildingDesign::Roof::Gabled;
    const Object house = build_building(design, kMaterials);
    check_house(house);
    CHECK(faces_of(house, 2) == 4);
}

TEST_CASE("building: footprints that are none are bad input", "[scene][building]") {
    CHECK_THROWS_AS(build_building(on({}), kMaterials), InputError);
    CHECK_THROWS_AS(build_building(on({{0, 0}, {1, 0}}), kMaterials), InputError);
    CHECK_THROWS_AS(build_building(on({{0, 0}, {1, 0}, {2, 0}}), kMaterials), InputError);
    CHECK_THROWS_WITH(build_building(on({{0, 0}, {9, 9}, {9, 0}, {0, 9}}), kMaterials),
                      Contains("footprint"));
    CHECK_THROWS_AS(build_building(on({{0, 0}, {9, 0}, {9, 9}, {9, 0}, {0, 9}}), kMaterials), InputError);
    CHECK_THROWS_AS(build_building(on({{0, 0}, {9, 0}, {NAN, 9}}), kMaterials), InputError);
}

TEST_CASE("building: sizes that make no house are bad input", "[scene][building]") {
    const auto broken = [](auto change) {
        BuildingDesign design = on(kRectangle);
        design.windows.rows = 2;
        change(design);
        return design;
    };
    CHECK_THROWS_AS(build_building(broken([](auto& d) { d.height_m = 0; }), kMaterials), InputError);
    CHECK_THROWS_AS(build_building(broken([](auto& d) { d.foundation_m = -1; }), kMaterials), InputError);
    CHECK_THROWS_AS(build_building(broken([](auto& d) { d.windows.rows = 3; }), kMaterials), InputError);
    CHECK_THROWS_AS(build_building(broken([](auto& d) { d.windows.spacing_m = 1.3; }), kMaterials),
                    InputError);
    CHECK_THROWS_AS(build_building(broken([](auto& d) { d.windows.recess_m = 0; }), kMaterials), InputError);
    CHECK_THROWS_AS(build_building(broken([](auto& d) {
                                       d.footprint_m = kLetterL;
                                       d.roof = BuildingDesign::Roof::Gabled;
                                   }),
                                   kMaterials),
                    InputError);
}

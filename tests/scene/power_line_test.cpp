// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/power_line.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "keikan/scene/catenary.hpp"
#include "keikan/support/input_error.hpp"
#include "mesh_facts.hpp"
#include "wire_mesh.hpp"

using namespace keikan;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double flat_ground(double, double) {
    return 120;
}
double slope(double x, double y) {
    return 300 + 0.3 * x - 0.2 * y + 5 * std::sin(x / 40);
}

/// Looks along +y from `position`, 1000 x 650 pixels, focal length 1000 pixels.
Camera camera_at(glm::dvec3 position) {
    Camera camera;
    camera.position = position;
    return camera;
}

PowerLineDesign line_of(std::vector<RouteTower> route) {
    PowerLineDesign design;
    design.route = std::move(route);
    design.materials = {.tower = {1, 2, 3}, .conductor = 4, .ground_wire = 5, .spacer = 6};
    return design;
}

const std::vector<RouteTower> kBent{{.x_m = 0, .y_m = 0},
                                    {.x_m = 40, .y_m = 330},
                                    {.x_m = 200, .y_m = 640},
                                    {.x_m = 190, .y_m = 1000, .height_m = 95.0}};

const Object& named(const PowerLine& line, const std::string& name) {
    for (const Object& object : line.objects)
        if (object.name == name) return object;
    FAIL("no object " << name);
    return line.objects.front();
}

/// The thickness of the wire that a face's segment shows to the eye, over its diameter: extent across the
/// segment and the view.
double seen_width(const Mesh& mesh, std::span<const std::uint32_t> corners, glm::dvec3 along,
                  glm::dvec3 eye) {
    const glm::dvec3 across = glm::normalize(glm::cross(along, eye - mesh.positions[corners[0]]));
    double low = INFINITY, high = -INFINITY;
    for (const auto corner : corners) {
        const double at = glm::dot(mesh.positions[corner] - mesh.positions[corners[0]], across);
        low = std::min(low, at);
        high = std::max(high, at);
    }
    return high - low;
}

std::vector<glm::dvec3> hanging_axis(const Camera& camera, double span, double rise, glm::dvec3 from,
                                     glm::dvec3 along) {
    const Catenary curve = catenary_from_sag(span, rise, span / 40);
    const auto at = [&](double s) { return from + along * s + glm::dvec3(0, 0, curve.height_at(s)); };
    std::vector<glm::dvec3> axis;
    for (const double s : catenary_stations(curve, [&](double a, double b) {
             const double m = (a + b) / 2;
             const double turn =
                 view_angle_rad(camera, at(m), at(b), along) - view_angle_rad(camera, at(a), at(m), along);
             return std::abs(std::remainder(turn, std::acos(-1.0))) > kPrismTurn
                        ? 0
                        : kChordErrorPx / pixels_per_metre(camera, at(a), at(b));
         }))
        axis.push_back(at(s));
    return axis;
}

}  // namespace

TEST_CASE("power_line: every face is planar and convex, solids are closed, over flat and sloping ground",
          "[scene][power_line]") {
    for (const int bundle : {1, 2, 4})
        for (const bool sloping : {false, true}) {
            PowerLineDesign design = line_of(kBent);
            design.conductor.sub_conductors = bundle;
            const Camera camera = camera_at({-30, -60, sloping ? 310.0 : 130.0});
            const PowerLine line = build_power_line(design, sloping ? slope : flat_ground, camera);
            std::set<std::string> names;
            for (const Object& object : line.objects) {
                INFO(object.name);
                names.insert(object.name);
                REQUIRE(is_well_formed(object.mesh));
                CHECK(object.mesh.face_count() > 0);
                CHECK(largest_distance_from_plane(object.mesh) < kPlanarity);
                CHECK(smallest_turn(object.mesh) > 0);
                const bool ribbon = object.name.ends_with(" far");
                CHECK(object.mesh.closed != ribbon);
                if (ribbon) continue;
                CHECK(open_edges(object.mesh) == 0);
                const std::vector<double> volumes = sixfold_volumes(object.mesh);
                CHECK(*std::min_element(volumes.begin(), volumes.end()) > 0);
            }
            CHECK(names.size() == line.objects.size());
            CHECK(line.members.size() == 4);
            CHECK(line.spans.size() == 3);
        }
}

TEST_CASE("power_line: towers stand on the bisector of their spans, and wires end at their strings",
          "[scene][power_line]") {
    PowerLineDesign design =
        line_of({{.x_m = 0, .y_m = 0}, {.x_m = 0, .y_m = 300}, {.x_m = 300, .y_m = 300}});
    design.conductor.sub_conductors = 1;
    const Camera camera = camera_at({0, -500, 150});
    const PowerLine line = build_power_line(design, flat_ground, camera);
    // At the corner the arms lie along the diagonal (1, -1).
    const Box arms = bounding_box(named(line, "line/tower 2 insulators").mesh);
    const double reach = design.tower.arm_length_m[1] / std::sqrt(2.0);
    CHECK_THAT(arms.high.x, WithinAbs(reach, 0.3));
    CHECK_THAT(arms.low.y, WithinAbs(300 - reach, 0.3));
    // Each wire's end lies in its attachment point.
    const LatticeTower corner =
        build_lattice_tower("t", design.tower, {.base = {0, 300, 120}, .yaw_rad = -std::acos(-1.0) / 4}, {});
    for (const Attachment& attachment : corner.attachments) {
        const std::string wire = attachment.is_ground_wire()
                                     ? "ground wire 1"
                                     : "circuit " + std::to_string(attachment.circuit) + " phase " +
                                           std::to_string(attachment.phase);
        const double diameter =
            attachment.is_ground_wire() ? design.ground_wire.diameter_m : design.conductor.diameter_m;
        for (const std::string span : {"1-2", "2-3"}) {
            double nearest = INFINITY;
            for (const Object& object : line.objects)
                if (object.name.starts_with("line/span " + span + " " + wire))
                    for (const glm::dvec3& p : object.mesh.positions)
                        nearest = std::min(nearest, glm::distance(p, attachment.point));
            CHECK_THAT(nearest, WithinAbs(diameter / 2, 1e-3 * diameter));
        }
    }
}

TEST_CASE("power_line: feet reach the ground wherever it falls", "[scene][power_line]") {
    const PowerLineDesign design = line_of({{.x_m = 0, .y_m = 0}, {.x_m = 0, .y_m = 300}});
    const PowerLine line = build_power_line(design, slope, camera_at({0, -500, 350}));
    // Foundations are 1.2 m deep and 0.35 m high around the foot: the ground passes between, on every leg.
    for (const std::string name : {"line/tower 1", "line/tower 2"}) {
        const Mesh& mesh = named(line, name).mesh;
        std::map<std::uint32_t, std::vector<glm::dvec3>> boxes;
        int legs = 0;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            if (mesh.face_material[f] == 3) {
                auto& box = boxes[*std::min_element(mesh.face(f).begin(), mesh.face(f).end()) / 8];
                for (const auto corner : mesh.face(f)) box.push_back(mesh.positions[corner]);
            }
        for (const auto& [first, corners] : boxes) {
            glm::dvec3 middle{0};
            double low = INFINITY, high = -INFINITY;
            for (const glm::dvec3& p : corners) {
                middle += p / double(corners.size());
                low = std::min(low, p.z);
                high = std::max(high, p.z);
            }
            ++legs;
            CHECK(low < slope(middle.x, middle.y));
            CHECK(high > slope(middle.x, middle.y));
        }
        CHECK(legs == 4);
    }
}

TEST_CASE("power_line: one tension for all spans, stated by the sag of the longest", "[scene][power_line]") {
    PowerLineDesign design = line_of(
        {{.x_m = 0, .y_m = 0}, {.x_m = 0, .y_m = 200}, {.x_m = 0, .y_m = 600}, {.x_m = 0, .y_m = 900}});
    design.conductor.sag_m = 11.0;
    const PowerLine line = build_power_line(design, flat_ground, camera_at({0, -500, 150}));
    REQUIRE(line.spans.size() == 3);
    CHECK_THAT(line.spans[1].sag_m, WithinRel(11.0, 1e-9));
    // Sags go with the square of the span, within the difference between catenary and parabola.
    CHECK_THAT(line.spans[0].sag_m, WithinRel(11.0 / 4, 5e-3));
    CHECK_THAT(line.spans[2].sag_m, WithinRel(11.0 * 9 / 16, 5e-3));
    const double yoke = design.tower.height_m - 10 - 2 * 11.5 - 4.6;
    CHECK_THAT(line.spans[1].lowest_above_ground_m, WithinAbs(yoke - 0.25 - 11, 0.01));

    design.conductor.sag_m.reset();
    const PowerLine taut = build_power_line(design, flat_ground, camera_at({0, -500, 150}));
    CHECK_THAT(taut.spans[1].sag_m, WithinRel(catenary_from_tension(400, 0, 30'000, 16.4).sag_m(), 1e-6));
}

TEST_CASE("power_line: spacers stand every 50 m, in a square for four wires and as a bar for two",
          "[scene][power_line]") {
    PowerLineDesign design = line_of({{.x_m = 0, .y_m = 0}, {.x_m = 0, .y_m = 350}});
    const Camera camera = camera_at({0, -500, 150});
    CHECK(named(build_power_line(design, flat_ground, camera), "line/span 1-2 spacers").mesh.face_count() ==
          6 * 7 * 4 * 6);
    design.conductor.sub_conductors = 2;
    CHECK(named(build_power_line(design, flat_ground, camera), "line/span 1-2 spacers").mesh.face_count() ==
          6 * 7 * 1 * 6);
    design.conductor.sub_conductors = 1;
    for (const Object& object : build_power_line(design, flat_ground, camera).objects)
        CHECK_FALSE(object.name.ends_with("spacers"));
}

TEST_CASE("power_line: wires are prisms near the eye and ribbons far from it", "[scene][power_line][wire]") {
    const PowerLineDesign design =
        line_of({{.x_m = 0, .y_m = 0}, {.x_m = 0, .y_m = 300}, {.x_m = 0, .y_m = 600}});
    const PowerLine near = build_power_line(design, flat_ground, camera_at({-14, 150, 155}));
    CHECK(named(near, "line/span 1-2 circuit 1 phase 1").mesh.closed);
    const PowerLine far = build_power_line(design, flat_ground, camera_at({0, -5000, 155}));
    for (const Object& object : far.objects) {
        if (object.kind != ObjectKind::Conductor) continue;
        CHECK(object.name.ends_with(" far"));
        CHECK_FALSE(object.mesh.closed);
    }
}

TEST_CASE("add_wire: a ribbon shows the true thickness, from any side and at any distance",
          "[scene][power_line][wire]") {
    const double diameter = 0.0384;
    for (const double rise : {0.0, 60.0, -140.0})
        for (const glm::dvec3 eye :
             {glm::dvec3(3, 170, 1), glm::dvec3(1.5, -20, -3), glm::dvec3(60, 100, -30),
              glm::dvec3(0, -2000, 4), glm::dvec3(1, -900, 60), glm::dvec3(700, 5000, -200),
              glm::dvec3(0.4, -6, -2)}) {
            const Camera camera = camera_at(eye);
            const glm::dvec3 along{0, 1, 0};
            const std::vector<glm::dvec3> axis = hanging_axis(camera, 350, rise, {0, 0, 0}, along);
            WireMeshes meshes;
            add_wire(meshes, axis, along, diameter, 4, camera);
            INFO("rise " << rise << " eye " << eye.x << " " << eye.y << " " << eye.z << ", segments "
                         << axis.size());
            double thinnest = 1, thickest = 1;
            CHECK(meshes.ribbons.face_count() > 0);
            const Mesh& ribbons = meshes.ribbons;
            for (std::size_t f = 0; f < ribbons.face_count(); ++f) {
                const auto face = ribbons.face(f);
                if (face.size() != 4) continue;  // a turn: between two widths that are looked at
                const glm::dvec3 run = ribbons.positions[face[2]] - ribbons.positions[face[1]];
                const double seen = seen_width(ribbons, face.first(2), run, eye) / diameter;
                thinnest = std::min(thinnest, seen);
                thickest = std::max(thickest, seen);
            }
            CHECK(thinnest >= 1 - kThicknessError);
            CHECK(thickest <= 1 + 1e-3);
        }
}

TEST_CASE("add_wire: a prism shows its diameter, and keeps it over bends and on steep wires",
          "[scene][power_line][wire]") {
    const double diameter = 0.0285;
    std::set<std::size_t> levels;
    for (const double slope_m : {0.0, 1.5, -0.7})
        for (const double distance : {2.5, 5.0, 10.0, 20.0})
            for (const double above : {-2.0, 0.1, 3.0}) {
                // Six joints, 10 cm apart, bending by half a degree each; the eye beside the middle.
                const Camera camera = camera_at({distance, 0.25, above});
                std::vector<glm::dvec3> axis;
                for (int i = 0; i < 6; ++i) axis.emplace_back(0, 0.1 * i, 0.1 * i * slope_m + 0.0004 * i * i);
                WireMeshes meshes;
                add_wire(meshes, axis, {0, 1, 0}, diameter, 4, camera);
                const Mesh& mesh = meshes.prisms;
                const std::size_t sides = mesh.positions.size() / axis.size();
                levels.insert(sides);
                REQUIRE(mesh.positions.size() == sides * axis.size());  // one run
                REQUIRE(mesh.face_count() == 5 * sides + 2);
                CHECK(meshes.ribbons.face_count() == 0);
                CHECK(open_edges(mesh) == 0);
                CHECK(largest_distance_from_plane(mesh) < 1e-15);
                for (std::uint32_t joint = 0; joint + 1 < axis.size(); ++joint) {
                    std::vector<std::uint32_t> ring(sides);
                    for (std::uint32_t k = 0; k < sides; ++k)
                        ring[k] = joint * static_cast<std::uint32_t>(sides) + k;
                    const double seen =
                        seen_width(mesh, ring, axis[joint + 1] - axis[joint], camera.position);
                    CHECK(seen / diameter >= 1 - kThicknessError);
                    CHECK(seen / diameter <=
                          1 + 1e-4);  // the mitre of half a degree: 1 / cos(1/4 degree) - 1
                }
            }
    CHECK(levels == std::set<std::size_t>{4, 6, 8, 12});
}

TEST_CASE("add_wire: neighbouring segments share their vertices: a strip is one piece",
          "[scene][power_line][wire]") {
    const Camera camera = camera_at({5, -600, -20});
    const glm::dvec3 along{0, 1, 0};
    const std::vector<glm::dvec3> axis = hanging_axis(camera, 350, 20, {0, 0, 0}, along);
    WireMeshes meshes;
    add_wire(meshes, axis, along, 0.0285, 4, camera);
    REQUIRE(meshes.prisms.face_count() == 0);
    CHECK(meshes.ribbons.positions.size() == 2 * axis.size());
    CHECK(meshes.ribbons.normals.size() == meshes.ribbons.positions.size());
    CHECK(sixfold_volumes(meshes.ribbons).size() == 1);  // hangs together
    // Normals look at the eye.
    for (std::size_t v = 0; v < meshes.ribbons.positions.size(); ++v)
        CHECK(glm::dot(glm::dvec3(meshes.ribbons.normals[v]), camera.position - meshes.ribbons.positions[v]) >
              0);
}

TEST_CASE("power_line: what cannot be built is bad input, with a reason", "[scene][power_line]") {
    const Camera camera = camera_at({0, -500, 150});
    const auto refused = [&](PowerLineDesign design, const GroundHeight& ground = flat_ground) {
        try {
            build_power_line(design, ground, camera);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    const std::vector<RouteTower> straight{{.x_m = 0, .y_m = 0}, {.x_m = 0, .y_m = 300}};
    CHECK(refused(line_of(straight)) == "accepted");
    CHECK_THAT(refused(line_of({})), Contains("no tower"));
    CHECK_THAT(refused(line_of({straight[0], straight[0]})), Contains("same spot"));
    CHECK_THAT(refused(line_of({straight[0], straight[1], {.x_m = 1, .y_m = 0}})), Contains("120 degrees"));
    CHECK_THAT(refused(line_of(straight), [](double, double y) { return y > 10 ? NAN : 5.0; }),
               Contains("no height"));
    CHECK_THAT(refused(line_of(straight), [](double x, double) { return -20 * x; }), Contains("steep"));
    PowerLineDesign design = line_of(straight);
    design.conductor.sub_conductors = 3;
    CHECK_THAT(refused(design), Contains("1, 2 or 4"));
    design = line_of(straight);
    design.conductor.diameter_m = 0;
    CHECK_THAT(refused(design), Contains("diameter_m"));
    design = line_of(straight);
    design.ground_wire.horizontal_tension_n = 0;
    CHECK_THAT(refused(design), Contains("tension"));
    design = line_of(straight);
    design.conductor.sag_m = -2;
    CHECK_THAT(refused(design), Contains("sag"));
}

TEST_CASE("power_line: a single tower stands without wires", "[scene][power_line]") {
    const PowerLine line =
        build_power_line(line_of({{.x_m = 5, .y_m = 6}}), flat_ground, camera_at({0, -100, 150}));
    CHECK(line.objects.size() == 2);
    CHECK(line.spans.empty());
}

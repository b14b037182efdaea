// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/power_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "keikan/scene/catenary.hpp"
#include "keikan/support/input_error.hpp"
#include "prism_parts.hpp"
#include "tower_stand.hpp"
#include "wire_mesh.hpp"

namespace keikan {

namespace {

/// Bars of spacers and yokes, and how far they reach around the wires that they hold.
constexpr double kSpacerWidthM = 0.04;
constexpr double kSpacerReachM = 0.04;
/// Cosine of the sharpest turn of a route: at 120 degrees the arms already point half along the spans.
constexpr double kSharpestTurn = -0.5;
/// An insulator disc is drawn with this many sides from so many pixels; below the last the string is a slim
/// prism.
constexpr std::array<std::pair<double, int>, 4> kDiscSides{{{12.0, 12}, {3.0, 8}, {1.0, 6}, {0.3, 4}}};

glm::dvec2 place_of(const RouteTower& tower) {
    return {tower.x_m, tower.y_m};
}

/// The design with another height: the body grows or shrinks below the waist, its legs keep their slope.
TowerDesign with_height(TowerDesign design, double height_m) {
    const auto waist = [&](double height) {
        return height - design.peak_above_arm_m - 2 * design.arm_spacing_m;
    };
    const double old_waist = waist(design.height_m), new_waist = waist(height_m);
    if (!(old_waist > 0 && new_waist > 0)) throw InputError("a tower is too low for its arms");
    design.base_width_m =
        design.waist_width_m + (design.base_width_m - design.waist_width_m) * new_waist / old_waist;
    design.height_m = height_m;
    return design;
}

/// Along the line at a tower: the bisector of its two spans, horizontal.
glm::dvec2 bearing_at(const std::vector<RouteTower>& route, std::size_t i) {
    if (route.size() == 1) return {0, 1};
    const auto bearing = [&](std::size_t from) {
        return glm::normalize(place_of(route[from + 1]) - place_of(route[from]));
    };
    if (i == 0) return bearing(0);
    if (i + 1 == route.size()) return bearing(i - 1);
    const glm::dvec2 in = bearing(i - 1), out = bearing(i);
    if (glm::dot(in, out) < kSharpestTurn)
        throw InputError(fmt::format("the route turns by more than 120 degrees at tower {}", i + 1));
    return glm::normalize(in + out);
}

void check_route(const PowerLineDesign& design) {
    if (design.route.empty()) throw InputError("route: no tower");
    for (const RouteTower& tower : design.route)
        if (!std::isfinite(tower.x_m) || !std::isfinite(tower.y_m))
            throw InputError("route: a place is not finite");
    for (std::size_t i = 1; i < design.route.size(); ++i)
        if (place_of(design.route[i]) == place_of(design.route[i - 1]))
            throw InputError(fmt::format("towers {} and {} stand on the same spot", i, i + 1));
}

void check_wire(const WireDesign& wire, const char* which) {
    const auto require = [&](bool holds, const char* reason) {
        if (!holds) throw InputError(fmt::format("{}: {}", which, reason));
    };
    const auto is_positive = [](double value) { return value > 0 && std::isfinite(value); };
    require(is_positive(wire.diameter_m) && wire.diameter_m < 1, "diameter_m must be between 0 and 1");
    require(wire.sub_conductors == 1 || wire.sub_conductors == 2 || wire.sub_conductors == 4,
            "sub_conductors must be 1, 2 or 4");
    require(
        wire.sub_conductors == 1 || (wire.bundle_spacing_m > wire.diameter_m && wire.bundle_spacing_m < 10),
        "bundle_spacing_m must be more than diameter_m, and less than 10");
    require(wire.spacer_every_m >= 0 && std::isfinite(wire.spacer_every_m),
            "spacer_every_m must not be negative");
    require(wire.spacer_every_m == 0 || wire.spacer_every_m >= 1, "spacer_every_m must be 0, or 1 or more");
}

double longest_span_m(const std::vector<RouteTower>& route) {
    double longest = 0;
    for (std::size_t i = 1; i < route.size(); ++i)
        longest = std::max(longest, glm::distance(place_of(route[i]), place_of(route[i - 1])));
    return longest;
}

/// Horizontal tension over weight, the same in all spans.
double parameter_m(const WireDesign& wire, double longest_m) {
    if (wire.sag_m) return catenary_from_sag(longest_m, 0, *wire.sag_m).parameter_m;
    return wire.horizontal_tension_n / wire.weight_n_per_m;
}

/// Where the sub-conductors run, relative to the middle of the bundle.
std::vector<glm::dvec3> bundle_offsets(const WireDesign& wire, glm::dvec3 across) {
    const double half = wire.bundle_spacing_m / 2;
    const glm::dvec3 side = across * half, up{0, 0, half};
    switch (wire.sub_conductors) {
        case 1:
            return {glm::dvec3(0)};
        case 2:
            return {-side, side};
        default:
            return {-side - up, side - up, side + up, -side + up};
    }
}

/// A wire of one span.
struct Hanging {
    Catenary curve;
    glm::dvec3 from{0}, to{0};
    glm::dvec3 along{0, 1, 0};  ///< horizontal unit vector
    std::vector<double> stations;

    glm::dvec3 at(double s) const {
        if (s == 0) return from;
        if (s == curve.span_m) return to;
        return from + along * s + glm::dvec3(0, 0, curve.height_at(s));
    }
};

Hanging hang(double parameter, glm::dvec3 from, glm::dvec3 to, const Camera& camera) {
    Hanging hanging;
    const glm::dvec3 level(to.x - from.x, to.y - from.y, 0);
    const double span = glm::length(level);
    if (!(span > 0)) throw InputError("two attachment points lie above each other");
    hanging.from = from;
    hanging.to = to;
    hanging.along = level / span;
    hanging.curve = catenary_from_tension(span, to.z - from.z, parameter, 1);
    hanging.stations = catenary_stations(hanging.curve, [&](double a, double b) {
        const glm::dvec3 start = hanging.at(a), middle = hanging.at(a + (b - a) / 2), end = hanging.at(b);
        // One segment shows one side of the wire: where the eye goes around it, segments are shorter.
        const double turn = view_angle_rad(camera, middle, end, hanging.along) -
                            view_angle_rad(camera, start, middle, hanging.along);
        if (std::abs(std::remainder(turn, std::numbers::pi)) > kPrismTurn) return 0.0;
        return kChordErrorPx / pixels_per_metre(camera, start, end);
    });
    return hanging;
}

/// Bars that hold a bundle together: one between two wires, a frame around four.
void add_frame(Mesh& mesh, const std::vector<glm::dvec3>& wires, glm::dvec3 along, std::uint16_t material) {
    const std::size_t bars = wires.size() == 2 ? 1 : wires.size();
    for (std::size_t k = 0; k < bars; ++k) {
        const glm::dvec3 from = wires[k], to = wires[(k + 1) % wires.size()];
        const glm::dvec3 reach = glm::normalize(to - from) * kSpacerReachM;
        add_member(mesh, SteelProfile::Square, from - reach, to + reach, along, kSpacerWidthM, material);
    }
    mesh.closed = true;
}

void add_spacers(Mesh& mesh, const WireDesign& wire, const std::vector<Hanging>& bundle,
                 std::uint16_t material) {
    if (bundle.size() == 1 || !(wire.spacer_every_m > 0)) return;
    // In the middles of equal parts of the span, as nearly as long as asked for.
    const double parts = std::round(bundle.front().curve.span_m / wire.spacer_every_m);
    for (int i = 0; i < static_cast<int>(parts); ++i) {
        std::vector<glm::dvec3> wires;
        for (const Hanging& hanging : bundle)
            wires.push_back(hanging.at(hanging.curve.span_m * (i + 0.5) / parts));
        add_frame(mesh, wires, bundle.front().along, material);
    }
}

/// Builds a line from its towers outwards.
class LineBuilder {
  public:
    LineBuilder(const PowerLineDesign& design, const GroundHeight& ground, const Camera& camera)
        : design_(design), ground_(ground), camera_(camera) {}

    PowerLine build() {
        check_route(design_);
        check_wire(design_.conductor, "conductor");
        check_wire(design_.ground_wire, "ground wire");
        for (std::size_t i = 0; i < design_.route.size(); ++i) add_tower(i);
        const double longest = longest_span_m(design_.route);
        if (design_.route.size() > 1) {
            conductor_parameter_ = parameter_m(design_.conductor, longest);
            ground_parameter_ = parameter_m(design_.ground_wire, longest);
        }
        for (std::size_t i = 0; i + 1 < design_.route.size(); ++i) add_span(i);
        tell();
        return std::move(line_);
    }

  private:
    double ground_height(double x, double y) const {
        const double height = ground_(x, y);
        if (std::isnan(height))
            throw InputError(fmt::format("the ground has no height at ({:g}, {:g})", x, y));
        return height;
    }

    void add_tower(std::size_t i) {
        const RouteTower& tower = design_.route[i];
        const TowerDesign shape =
            tower.height_m ? with_height(design_.tower, *tower.height_m) : design_.tower;
        const glm::dvec2 bearing = bearing_at(design_.route, i);
        TowerStand stand = stand_on_ground(shape, place_of(tower), std::atan2(-bearing.x, bearing.y),
                                           [this](double x, double y) { return ground_height(x, y); });
        const double px_per_m =
            pixels_per_metre(camera_, stand.base, stand.base + glm::dvec3(0, 0, shape.height_m));
        stand.detail = design_.detail.value_or(
            shape.leg_width_base_m * px_per_m >= kAngleWidthPx ? TowerDetail::Angles : TowerDetail::Boxes);
        stand.disc_sides = 0;
        for (const auto& [from_px, sides] : kDiscSides)
            if (stand.disc_sides == 0 && shape.insulator.disc_diameter_m * px_per_m >= from_px)
                stand.disc_sides = sides;
        LatticeTower built = build_lattice_tower(fmt::format("{}/tower {}", design_.name, i + 1), shape,
                                                 stand, design_.materials.tower);
        line_.members.push_back(built.members);
        arm_direction_.emplace_back(bearing.y, -bearing.x, 0);
        for (const Attachment& point : built.attachments) add_yoke(built.insulators.mesh, point, bearing);
        line_.objects.push_back(std::move(built.steel));
        line_.objects.push_back(std::move(built.insulators));
        attachments_.push_back(std::move(built.attachments));
    }

    const WireDesign& wire_of(const Attachment& attachment) const {
        return attachment.is_ground_wire() ? design_.ground_wire : design_.conductor;
    }

    /// What the sub-conductors are clamped to.
    void add_yoke(Mesh& mesh, const Attachment& attachment, glm::dvec2 bearing) const {
        const WireDesign& wire = wire_of(attachment);
        if (wire.sub_conductors == 1) return;
        std::vector<glm::dvec3> wires = bundle_offsets(wire, arm_direction_.back());
        for (glm::dvec3& place : wires) place += attachment.point;
        add_frame(mesh, wires, glm::dvec3(bearing, 0), design_.materials.tower.steel);
    }

    void add_span(std::size_t i) {
        const std::string name = fmt::format("{}/span {}-{}", design_.name, i + 1, i + 2);
        Object spacers{name + " spacers", ObjectKind::Insulator, {}};
        SpanSummary summary;
        summary.from_tower = static_cast<int>(i) + 1;
        summary.lowest_above_ground_m = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < attachments_[i].size(); ++k) {
            const Attachment& from = attachments_[i][k];
            const bool is_ground = from.is_ground_wire();
            const WireDesign& wire = wire_of(from);
            const std::vector<Hanging> bundle =
                hang_bundle(wire, is_ground ? ground_parameter_ : conductor_parameter_, i, from.point,
                            attachments_[i + 1][k].point);
            add_wires(fmt::format("{} {}", name,
                                  is_ground ? fmt::format("ground wire {}", from.phase)
                                            : fmt::format("circuit {} phase {}", from.circuit, from.phase)),
                      wire, bundle, is_ground ? design_.materials.ground_wire : design_.materials.conductor);
            if (is_ground) continue;
            add_spacers(spacers.mesh, wire, bundle, design_.materials.spacer);
            const Hanging& lowest = bundle.front();
            if (k == 0) {
                summary.span_m = lowest.curve.span_m;
                summary.rise_m = lowest.curve.rise_m;
                summary.sag_m = lowest.curve.sag_m();
            }
            for (const double s : lowest.stations) {
                const glm::dvec3 p = lowest.at(s);
                summary.lowest_above_ground_m =
                    std::min(summary.lowest_above_ground_m, p.z - ground_height(p.x, p.y));
            }
        }
        if (spacers.mesh.face_count() > 0) line_.objects.push_back(std::move(spacers));
        line_.spans.push_back(summary);
    }

    /// Each sub-conductor from its place at the one tower to its place at the other, the lowest first.
    std::vector<Hanging> hang_bundle(const WireDesign& wire, double parameter, std::size_t i, glm::dvec3 from,
                                     glm::dvec3 to) const {
        const std::vector<glm::dvec3> here = bundle_offsets(wire, arm_direction_[i]);
        const std::vector<glm::dvec3> there = bundle_offsets(wire, arm_direction_[i + 1]);
        std::vector<Hanging> bundle;
        for (std::size_t k = 0; k < here.size(); ++k)
            bundle.push_back(hang(parameter, from + here[k], to + there[k], camera_));
        return bundle;
    }

    void add_wires(const std::string& name, const WireDesign& wire, const std::vector<Hanging>& bundle,
                   std::uint16_t material) {
        WireMeshes meshes;
        for (const Hanging& hanging : bundle) {
            std::vector<glm::dvec3> axis;
            for (const double s : hanging.stations) axis.push_back(hanging.at(s));
            add_wire(meshes, axis, hanging.along, wire.diameter_m, material, camera_);
        }
        for (std::size_t level = 0; level < facets_.size(); ++level) facets_[level] += meshes.facets[level];
        if (meshes.prisms.face_count() > 0) {
            meshes.prisms.closed = true;
            line_.objects.push_back({name, ObjectKind::Conductor, std::move(meshes.prisms)});
        }
        if (meshes.ribbons.face_count() > 0)
            line_.objects.push_back({name + " far", ObjectKind::Conductor, std::move(meshes.ribbons)});
    }

    void tell() {
        std::size_t fewest = std::numeric_limits<std::size_t>::max(), most = 0;
        for (const std::size_t members : line_.members) {
            fewest = std::min(fewest, members);
            most = std::max(most, members);
        }
        line_.notes.push_back(fmt::format("{}: {} towers of {} to {} members", design_.name,
                                          line_.members.size(), fewest, most));
        for (const SpanSummary& span : line_.spans)
            line_.notes.push_back(
                fmt::format("{}: span {}-{}: {:.1f} m, rise {:.1f} m, sag {:.2f} m, lowest {:.1f} m above "
                            "ground",
                            design_.name, span.from_tower, span.from_tower + 1, span.span_m, span.rise_m,
                            span.sag_m, span.lowest_above_ground_m));
        std::string levels;
        for (std::size_t level = 0; level < facets_.size(); ++level) {
            if (!levels.empty()) levels += ", ";
            levels += kWireLevels[level].sides > 0 ? fmt::format("{} of prisms with {} sides", facets_[level],
                                                                 kWireLevels[level].sides)
                                                   : fmt::format("{} of ribbons", facets_[level]);
        }
        line_.notes.push_back(fmt::format("{}: wire facets: {}", design_.name, levels));
    }

    const PowerLineDesign& design_;
    const GroundHeight& ground_;
    const Camera& camera_;
    PowerLine line_;
    std::vector<std::vector<Attachment>> attachments_;  ///< of each tower
    std::vector<glm::dvec3> arm_direction_;             ///< of each tower: along its arms, to the right
    double conductor_parameter_ = 1;
    double ground_parameter_ = 1;
    std::array<std::size_t, kWireLevels.size()> facets_{};
};

}  // namespace

PowerLine build_power_line(const PowerLineDesign& design, const GroundHeight& ground, const Camera& camera) {
    return LineBuilder(design, ground, camera).build();
}

}  // namespace keikan

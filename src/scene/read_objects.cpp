// SPDX-License-Identifier: Apache-2.0
#include "read_objects.hpp"
#include "degree.hpp"

#include <fmt/format.h>

#include <cmath>

namespace keikan {
namespace {

constexpr double kFarthestM = 1e7;  ///< coordinates beyond a quarter of the Earth's girth are mistakes

glm::dvec2 read_place(const JsonNode& node) {
    node.array_size(2, 2);
    const NumberRange range = between(-kFarthestM, kFarthestM);
    return {node.item(0).number(range), node.item(1).number(range)};
}

std::vector<glm::dvec2> read_outline(
    const JsonNode& node) {  // simple or not shows while building: that takes time
    std::vector<glm::dvec2> outline(node.array_size(3, 10'000));
    for (std::size_t i = 0; i < outline.size(); ++i) outline[i] = read_place(node.item(i));
    return outline;
}

void set_length(JsonObject& object, const char* key, double& value, NumberRange range = positive_up_to(1e5)) {
    value = object.number_or(key, value, range);
}

/// "height_above_ground_m" or "height_m" (above z = 0); on the ground if neither is given.
HeightAboveGround read_base(JsonObject& object) {
    const NumberRange range = between(-kFarthestM, kFarthestM);
    const auto relative = object.optional("height_above_ground_m");
    const auto absolute = object.optional("base_m");
    if (relative && absolute) absolute->fail("\"height_above_ground_m\" stands beside it; one is enough");
    if (absolute) return {absolute->number(range), false};
    return {relative ? relative->number(range) : 0, true};
}

std::optional<TowerDetail> read_detail(JsonObject& object) {
    const auto node = object.optional("detail");
    if (!node) return std::nullopt;
    const std::string text = node->text();
    if (text == "angles") return TowerDetail::Angles;
    if (text == "boxes") return TowerDetail::Boxes;
    if (text == "primary") return TowerDetail::Primary;
    node->fail("must be \"angles\", \"boxes\" or \"primary\"");
}

InsulatorDesign read_insulator(const JsonNode& node) {
    JsonObject object(node);
    InsulatorDesign insulator;
    const std::string kind = object.text_or("kind", "I");
    if (kind != "I" && kind != "V") object.required("kind").fail("must be \"I\" or \"V\"");
    insulator.kind = kind == "I" ? InsulatorDesign::Kind::I : InsulatorDesign::Kind::V;
    set_length(object, "length_m", insulator.length_m);
    insulator.discs = object.integer_or("discs", insulator.discs, 1, 200);
    set_length(object, "disc_diameter_m", insulator.disc_diameter_m);
    set_length(object, "v_half_width_m", insulator.v_half_width_m);
    object.no_other_keys();
    return insulator;
}

/// The "design" of a tower; what it leaves out keeps the default.
TowerDesign read_tower_design(const JsonNode& node) {
    JsonObject object(node);
    TowerDesign design;
    set_length(object, "height_m", design.height_m);
    set_length(object, "base_width_m", design.base_width_m);
    set_length(object, "waist_width_m", design.waist_width_m);
    set_length(object, "top_width_m", design.top_width_m);
    set_length(object, "peak_above_arm_m", design.peak_above_arm_m);
    set_length(object, "arm_spacing_m", design.arm_spacing_m);
    if (const auto arms = object.optional("arm_length_m")) {
        arms->array_size(3, 3);
        for (std::size_t i = 0; i < 3; ++i)
            design.arm_length_m[i] = arms->item(i).number(positive_up_to(1e5));
    }
    set_length(object, "arm_depth_m", design.arm_depth_m);
    set_length(object, "ground_arm_m", design.ground_arm_m, between(0, 1e5));
    set_length(object, "leg_width_base_m", design.leg_width_base_m);
    set_length(object, "leg_width_top_m", design.leg_width_top_m);
    set_length(object, "brace_width_base_m", design.brace_width_base_m);
    set_length(object, "brace_width_top_m", design.brace_width_top_m);
    set_length(object, "secondary_width_m", design.secondary_width_m);
    if (const auto insulator = object.optional("insulator")) design.insulator = read_insulator(*insulator);
    object.no_other_keys();
    return design;
}

TowerMaterials read_tower_materials(JsonObject& object, const MaterialNames& materials) {
    TowerMaterials tower;
    tower.steel = materials.index_of(object.required("steel"));
    const auto insulator = object.optional("insulator"), foundation = object.optional("foundation");
    tower.insulator = insulator ? materials.index_of(*insulator) : tower.steel;
    tower.foundation = foundation ? materials.index_of(*foundation) : tower.steel;
    return tower;
}

TowerBlock read_tower(JsonObject& object, const MaterialNames& materials) {
    TowerBlock tower;
    if (const auto design = object.optional("design")) tower.design = read_tower_design(*design);
    JsonObject names(object.required("materials"));
    tower.materials = read_tower_materials(names, materials);
    names.no_other_keys();
    tower.place = read_place(object.required("position_m"));
    tower.base = read_base(object);
    tower.yaw_rad = object.number_or("yaw_deg", 0, between(-360, 360)) * kDegree;
    tower.detail = read_detail(object);
    return tower;
}

WireDesign read_wire(const JsonNode& node, WireDesign wire) {
    JsonObject object(node);
    set_length(object, "diameter_m", wire.diameter_m, positive_up_to(10));
    wire.sub_conductors = object.integer_or("sub_conductors", wire.sub_conductors, 1, 4);
    if (wire.sub_conductors == 3) object.required("sub_conductors").fail("must be 1, 2 or 4");
    set_length(object, "bundle_spacing_m", wire.bundle_spacing_m, positive_up_to(100));
    set_length(object, "spacer_every_m", wire.spacer_every_m, between(0, 1e5));
    const bool by_tension = object.optional("weight_n_per_m") || object.optional("horizontal_tension_n");
    set_length(object, "weight_n_per_m", wire.weight_n_per_m, positive_up_to(1e5));
    set_length(object, "horizontal_tension_n", wire.horizontal_tension_n, positive_up_to(1e9));
    if (const auto sag = object.optional("sag_m")) {
        if (by_tension) sag->fail("weight or tension stands beside it; one is enough");
        wire.sag_m = sag->number(positive_up_to(1e5));
    }
    object.no_other_keys();
    return wire;
}

RouteTower read_route_tower(const JsonNode& node) {
    if (node.value().is_array()) {
        const glm::dvec2 place = read_place(node);
        return {.x_m = place.x, .y_m = place.y};
    }
    JsonObject object(node);
    const glm::dvec2 place = read_place(object.required("position_m"));
    RouteTower tower{.x_m = place.x, .y_m = place.y};
    if (const auto height = object.optional("height_m")) tower.height_m = height->number(positive_up_to(1e5));
    object.no_other_keys();
    return tower;
}

PowerLineMaterials read_line_materials(const JsonNode& node, const MaterialNames& materials) {
    JsonObject object(node);
    PowerLineMaterials line;
    line.tower = read_tower_materials(object, materials);
    line.conductor = materials.index_of(object.required("conductor"));
    const auto ground_wire = object.optional("ground_wire"), spacer = object.optional("spacer");
    line.ground_wire = ground_wire ? materials.index_of(*ground_wire) : line.conductor;
    line.spacer = spacer ? materials.index_of(*spacer) : line.tower.steel;
    object.no_other_keys();
    return line;
}

PowerLineBlock read_power_line(const std::string& name, JsonObject& object, const MaterialNames& materials) {
    PowerLineDesign line;
    line.name = name;
    if (const auto tower = object.optional("tower")) line.tower = read_tower_design(*tower);
    const JsonNode route = object.required("route");
    for (std::size_t i = 0; i < route.array_size(1, 10'000); ++i) {
        line.route.push_back(read_route_tower(route.item(i)));
    }
    if (const auto wire = object.optional("conductor")) line.conductor = read_wire(*wire, line.conductor);
    if (const auto wire = object.optional("ground_wire"))
        line.ground_wire = read_wire(*wire, line.ground_wire);
    line.materials = read_line_materials(object.required("materials"), materials);
    line.detail = read_detail(object);
    return {line};
}

WindowDesign read_windows(const JsonNode& node) {
    JsonObject object(node);
    WindowDesign windows;
    windows.rows = object.integer_or("rows", 1, 0, 500);
    set_length(object, "width_m", windows.width_m);
    set_length(object, "height_m", windows.height_m);
    set_length(object, "spacing_m", windows.spacing_m);
    set_length(object, "sill_m", windows.sill_m, between(0, 1e5));
    set_length(object, "storey_m", windows.storey_m);
    set_length(object, "recess_m", windows.recess_m);
    object.no_other_keys();
    return windows;
}

/// A footprint stated outright, or as a rectangle about a centre.
std::vector<glm::dvec2> read_footprint(JsonObject& object) {
    if (object.exactly_one_of({"footprint_m", "rectangle"}) == "footprint_m") {
        return read_outline(object.required("footprint_m"));
    }
    JsonObject rectangle(object.required("rectangle"));
    const glm::dvec2 centre = read_place(rectangle.required("centre_m"));
    const JsonNode size = rectangle.required("size_m");
    size.array_size(2, 2);
    const double half_x = size.item(0).number(positive_up_to(1e5)) / 2;
    const double half_y = size.item(1).number(positive_up_to(1e5)) / 2;
    const double yaw = rectangle.number_or("yaw_deg", 0, between(-360, 360)) * kDegree;
    rectangle.no_other_keys();
    const glm::dvec2 along(std::cos(yaw), std::sin(yaw)), across(-along.y, along.x);
    const glm::dvec2 a = half_x * along, b = half_y * across;
    return {centre - a - b, centre + a - b, centre + a + b, centre - a + b};
}

BuildingBlock read_building(const std::string& name, JsonObject& object, const MaterialNames& materials) {
    BuildingBlock building;
    BuildingDesign& design = building.design;
    design.name = name;
    design.footprint_m = read_footprint(object);
    if (const auto floor = object.optional("floor_m")) building.floor_m = floor->number(between(-1e5, 1e5));
    set_length(object, "foundation_m", design.foundation_m, between(0, 1e4));
    set_length(object, "height_m", design.height_m, positive_up_to(1e4));
    const std::string roof = object.text_or("roof", "flat");
    if (roof != "flat" && roof != "gabled") object.required("roof").fail("must be \"flat\" or \"gabled\"");
    design.roof = roof == "flat" ? BuildingDesign::Roof::Flat : BuildingDesign::Roof::Gabled;
    set_length(object, "roof_height_m", design.roof_height_m, positive_up_to(1e4));
    if (const auto windows = object.optional("windows")) design.windows = read_windows(*windows);
    JsonObject names(object.required("materials"));
    building.materials.wall = materials.index_of(names.required("wall"));
    const auto roof_name = names.optional("roof"), window_name = names.optional("window");
    building.materials.roof = roof_name ? materials.index_of(*roof_name) : building.materials.wall;
    building.materials.window = window_name ? materials.index_of(*window_name) : building.materials.wall;
    names.no_other_keys();
    return building;
}

MeshBlock read_mesh(JsonObject& object, const std::filesystem::path& folder, const MaterialNames& materials) {
    MeshBlock mesh;
    mesh.file = named_file(object.required("file"), folder);
    const glm::dvec2 place = read_place(object.required("position_m"));
    mesh.placement.position_m = {place.x, place.y, 0};
    mesh.base = read_base(object);
    mesh.placement.yaw_rad = object.number_or("yaw_deg", 0, between(-360, 360)) * kDegree;
    set_length(object, "scale", mesh.placement.scale, positive_up_to(1e6));
    const std::string up = object.text_or("up", "y");
    if (up != "y" && up != "z") object.required("up").fail("must be \"y\" or \"z\"");
    mesh.placement.y_up = up == "y";
    mesh.material = materials.index_of(object.required("material"));
    if (const auto names = object.optional("materials")) {
        JsonObject by_file_name(*names);
        for (const auto& entry : names->value().items()) {
            mesh.material_of[entry.key()] = materials.index_of(by_file_name.required(entry.key()));
        }
    }
    return mesh;
}

WaterBlock read_water(JsonObject& object, const MaterialNames& materials) {
    WaterBlock water;
    water.outline_m = read_outline(object.required("outline_m"));
    water.level_m = object.required("level_m").number(between(-1e5, 1e5));
    water.material = materials.index_of(object.required("material"));
    if (const auto surface = object.optional("surface"))
        water.surface = read_water_surface(*surface, water.level_m);
    return water;
}

ObjectBlock read_object(const JsonNode& node, std::size_t number, const std::filesystem::path& folder,
                        const MaterialNames& materials) {
    JsonObject object(node);
    const std::string type = object.required("type").text();
    ObjectBlock block{object.text_or("name", fmt::format("{} {}", type, number + 1)), node.path(), {}};
    if (type == "tower") {
        block.block = read_tower(object, materials);
    } else if (type == "power_line") {
        block.block = read_power_line(block.name, object, materials);
    } else if (type == "building") {
        block.block = read_building(block.name, object, materials);
    } else if (type == "mesh") {
        block.block = read_mesh(object, folder, materials);
    } else if (type == "water") {
        block.block = read_water(object, materials);
    } else {
        object.required("type").fail(
            "must be \"tower\", \"power_line\", \"building\", \"mesh\" or \"water\"");
    }
    object.no_other_keys();
    return block;
}

}  // namespace

std::vector<ObjectBlock> read_objects(const JsonNode& node, const std::filesystem::path& folder,
                                      const MaterialNames& materials) {
    std::vector<ObjectBlock> objects;
    const std::size_t count = node.array_size(0, 100'000);
    for (std::size_t i = 0; i < count; ++i)
        objects.push_back(read_object(node.item(i), i, folder, materials));
    return objects;
}

}  // namespace keikan

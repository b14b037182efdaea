// SPDX-License-Identifier: Apache-2.0
#include "build_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "keikan/scene/terrain.hpp"
#include "keikan/support/input_error.hpp"
#include "simple_polygon.hpp"
#include "tower_stand.hpp"

namespace keikan {
namespace {

/// A wall's foot looks at the ground this often; between, the ground is steeper than houses stand on.
constexpr double kFootStepM = 1;
constexpr double kFoundationBelowGroundM = 0.5;

double base_height(const HeightAboveGround& base, glm::dvec2 place, const Ground& ground) {
    return base.above_ground ? ground.height(place.x, place.y) + base.metres : base.metres;
}

void build(const TowerBlock& tower, const ObjectBlock& block, const Ground& ground, const Camera&,
           Geometry& geometry) {
    TowerStand stand;
    if (tower.base.above_ground && tower.base.metres == 0) {
        stand = stand_on_ground(tower.design, tower.place, tower.yaw_rad,
                                [&](double x, double y) { return ground.height(x, y); });
    } else {
        stand.base = {tower.place, base_height(tower.base, tower.place, ground)};
        stand.yaw_rad = tower.yaw_rad;
    }
    stand.detail = tower.detail.value_or(TowerDetail::Angles);
    LatticeTower built = build_lattice_tower(block.name, tower.design, stand, tower.materials);
    geometry.notes.push_back(fmt::format("{}: {} members, {} of them secondary, top at {:.2f} m", block.name,
                                         built.members, built.secondary,
                                         stand.base.z + tower.design.height_m));
    geometry.objects.push_back(std::move(built.steel));
    geometry.objects.push_back(std::move(built.insulators));
}

void build(const PowerLineBlock& line, const ObjectBlock&, const Ground& ground, const Camera& camera,
           Geometry& geometry) {
    PowerLine built = build_power_line(
        line.design, [&](double x, double y) { return ground.height_or_nan(x, y); }, camera);
    for (Object& object : built.objects) geometry.objects.push_back(std::move(object));
    geometry.notes.insert(geometry.notes.end(), built.notes.begin(), built.notes.end());
}

/// The lowest and the highest ground along a footprint.
std::pair<double, double> ground_along(const std::vector<glm::dvec2>& footprint, const Ground& ground) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < footprint.size(); ++i) {
        const glm::dvec2 from = footprint[i], to = footprint[(i + 1) % footprint.size()];
        const int steps =
            std::clamp(static_cast<int>(std::ceil(glm::distance(from, to) / kFootStepM)), 1, 10'000);
        for (int k = 0; k < steps; ++k) {
            const glm::dvec2 foot = from + (to - from) * (static_cast<double>(k) / steps);
            const double height = ground.height(foot.x, foot.y);
            low = std::min(low, height);
            high = std::max(high, height);
        }
    }
    return {low, high};
}

void build(const BuildingBlock& building, const ObjectBlock&, const Ground& ground, const Camera&,
           Geometry& geometry) {
    BuildingDesign design = building.design;
    if (building.floor_m) {
        design.floor_m = *building.floor_m;
    } else {
        const auto [low, high] = ground_along(design.footprint_m, ground);
        design.floor_m = high;
        design.foundation_m = std::max(design.foundation_m, high - low + kFoundationBelowGroundM);
    }
    geometry.objects.push_back(build_building(design, building.materials));
}

void build(const MeshBlock& mesh, const ObjectBlock& block, const Ground& ground, const Camera&,
           Geometry& geometry) {
    MeshPlacement placement = mesh.placement;
    placement.position_m.z = base_height(mesh.base, glm::dvec2(placement.position_m), ground);
    LoadedMesh loaded = read_mesh_file(mesh.file, placement, [&](const std::string& name) {
        const auto found = mesh.material_of.find(name);
        return found == mesh.material_of.end() ? mesh.material : found->second;
    });
    geometry.notes.push_back(loaded.note(block.name));
    geometry.objects.push_back({block.name, ObjectKind::Model, std::move(loaded.mesh)});
}

void build(const WaterBlock& water, const ObjectBlock& block, const Ground&, const Camera&,
           Geometry& geometry) {
    if (const auto reason = why_not_simple(water.outline_m)) throw InputError("outline_m: " + *reason);
    Mesh mesh;
    for (const glm::dvec2 corner : water.outline_m) mesh.add_position({corner, water.level_m});
    for (const auto& triangle : triangulate(water.outline_m)) mesh.add_face(triangle, water.material);
    geometry.objects.push_back({block.name, ObjectKind::Water, std::move(mesh)});
}

}  // namespace

double Ground::height_or_nan(double x, double y) const {
    if (grid_ == nullptr) return 0;
    return height_at(*grid_, x, y).value_or(std::numeric_limits<double>::quiet_NaN());
}

double Ground::height(double x, double y) const {
    const double height = height_or_nan(x, y);
    if (std::isnan(height)) throw InputError(fmt::format("({:g}, {:g}) lies beside the terrain", x, y));
    return height;
}

void build_object(const ObjectBlock& block, const Ground& ground, const Camera& camera, Geometry& geometry) {
    std::visit([&](const auto& kind) { build(kind, block, ground, camera, geometry); }, block.block);
}

}  // namespace keikan

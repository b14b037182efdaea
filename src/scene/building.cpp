// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/building.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "keikan/scene/lattice_tower.hpp"
#include "keikan/support/input_error.hpp"
#include "simple_polygon.hpp"

namespace keikan {

namespace {

void require(bool holds, const std::string& reason) {
    if (!holds) throw InputError(reason);
}

bool is_positive(double value) {
    return value > 0 && std::isfinite(value);
}

void require_windows_that_fit(const BuildingDesign& design) {
    const WindowDesign& w = design.windows;
    require(w.rows >= 0 && w.rows <= 500, "windows: rows must be 0 to 500");
    if (w.rows == 0) return;
    require(is_positive(w.width_m) && is_positive(w.height_m) && is_positive(w.sill_m) &&
                is_positive(w.storey_m) && is_positive(w.recess_m) && is_positive(w.spacing_m),
            "windows: every size must be positive");
    require(w.height_m < w.storey_m, "windows: height_m must be less than storey_m");
    // Two windows beside a right-angled corner are half the gap away from it: their recesses must not meet.
    require(w.spacing_m - w.width_m > 2 * w.recess_m,
            "windows: spacing_m must be more than width_m and twice recess_m");
    require(w.sill_m + (w.rows - 1) * w.storey_m + w.height_m < design.height_m,
            "windows: so many rows do not fit under the eaves");
}

void require_rectangle(const std::vector<glm::dvec2>& corners) {
    require(corners.size() == 4, "a gabled roof needs a rectangle of four corners");
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 one = glm::normalize(corners[(i + 1) % 4] - corners[i]);
        const glm::dvec2 next = glm::normalize(corners[(i + 2) % 4] - corners[(i + 1) % 4]);
        require(std::abs(glm::dot(one, next)) <= kRightAngleSlack, "a gabled roof needs a rectangle");
    }
}

/// The footprint, checked and counter-clockwise.
std::vector<glm::dvec2> checked_footprint(const BuildingDesign& design) {
    for (const glm::dvec2 corner : design.footprint_m)
        require(std::isfinite(corner.x) && std::isfinite(corner.y), "footprint: a corner is not finite");
    if (const auto reason = why_not_simple(design.footprint_m)) throw InputError("footprint: " + *reason);
    require(is_positive(design.height_m), "height_m must be positive");
    require(std::isfinite(design.floor_m), "floor_m must be finite");
    require(design.foundation_m >= 0 && std::isfinite(design.foundation_m),
            "foundation_m must not be negative");
    if (design.roof == BuildingDesign::Roof::Gabled) {
        require(is_positive(design.roof_height_m), "roof_height_m must be positive");
        require_rectangle(design.footprint_m);
    }
    require_windows_that_fit(design);
    std::vector<glm::dvec2> corners = design.footprint_m;
    double doubled_area = 0;  // from the first corner: no cancellation far from the origin
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::dvec2 a = corners[i] - corners[0], b = corners[i + 1] - corners[0];
        doubled_area += a.x * b.y - a.y * b.x;
    }
    if (doubled_area < 0) std::reverse(corners.begin(), corners.end());
    return corners;
}

/// Puts a house together. Heights at which walls are divided are the same all around, so that walls share the
/// vertices of their corners.
class HouseBuilder {
  public:
    HouseBuilder(const BuildingDesign& design, const BuildingMaterials& materials)
        : design_(design), materials_(materials), corners_(checked_footprint(design)) {}

    Mesh build() {
        choose_levels();
        for (const glm::dvec2 corner : corners_)
            for (const double z : levels_) mesh_.add_position({corner, z});
        for (std::size_t wall = 0; wall < corners_.size(); ++wall) add_wall(wall);
        const auto triangles = triangulate(corners_);
        for (const auto& [a, b, c] : triangles)
            add({corner(a, 0), corner(c, 0), corner(b, 0)}, materials_.wall);
        if (design_.roof == BuildingDesign::Roof::Gabled) {
            add_gabled_roof();
        } else {
            for (const auto& [a, b, c] : triangles)
                add({corner(a, top()), corner(b, top()), corner(c, top())}, materials_.roof);
        }
        mesh_.closed = true;
        return std::move(mesh_);
    }

  private:
    using Index = std::uint32_t;

    template <std::size_t N>
    void add(const Index (&face)[N], std::uint16_t material) {
        mesh_.add_face(std::span<const Index>(face), material);
    }

    std::size_t top() const { return levels_.size() - 1; }
    Index corner(std::size_t i, std::size_t level) const {
        return static_cast<Index>((i % corners_.size()) * levels_.size() + level);
    }

    std::size_t windows_in(std::size_t wall) const {
        const WindowDesign& w = design_.windows;
        if (w.rows == 0) return 0;
        const double length = glm::distance(corners_[wall], corners_[(wall + 1) % corners_.size()]);
        return static_cast<std::size_t>(std::min(std::floor(length / w.spacing_m), 1000.0));
    }

    /// Bottom, then sill and head of each row of windows, then the eaves.
    void choose_levels() {
        levels_.push_back(design_.floor_m - design_.foundation_m);
        bool any = false;
        for (std::size_t wall = 0; wall < corners_.size(); ++wall) any = any || windows_in(wall) > 0;
        for (int row = 0; any && row < design_.windows.rows; ++row) {
            const double sill = design_.floor_m + design_.windows.sill_m + row * design_.windows.storey_m;
            levels_.push_back(sill);
            levels_.push_back(sill + design_.windows.height_m);
        }
        levels_.push_back(design_.floor_m + design_.height_m);
    }

    void add_wall(std::size_t wall) {
        const std::size_t windows = windows_in(wall);
        if (windows == 0) {
            for (std::size_t level = 0; level < top(); ++level)
                add({corner(wall, level), corner(wall + 1, level), corner(wall + 1, level + 1),
                     corner(wall, level + 1)},
                    materials_.wall);
            return;
        }
        // Each window stands in the middle of its own bay; columns are piers (even) and windows (odd).
        const glm::dvec2 from = corners_[wall], to = corners_[(wall + 1) % corners_.size()];
        const double length = glm::distance(from, to), bay = length / static_cast<double>(windows);
        const glm::dvec2 along = (to - from) / length;
        const std::size_t columns = 2 * windows + 1;
        std::vector<std::vector<Index>> grid(levels_.size());  // the first and last level stay undivided
        for (std::size_t level = 1; level < top(); ++level) {
            grid[level].push_back(corner(wall, level));
            for (std::size_t column = 1; column < columns; ++column) {
                const double middle = (static_cast<double>((column - 1) / 2) + 0.5) * bay;
                const double side = column % 2 == 1 ? -0.5 : 0.5;
                grid[level].push_back(mesh_.add_position(
                    {from + along * (middle + side * design_.windows.width_m), levels_[level]}));
            }
            grid[level].push_back(corner(wall + 1, level));
        }
        const glm::dvec3 inwards = glm::dvec3(-along.y, along.x, 0) * design_.windows.recess_m;
        for (std::size_t level = 1; level + 1 < top(); ++level)
            for (std::size_t column = 0; column < columns; ++column) {
                const std::array<Index, 4> cell{grid[level][column], grid[level][column + 1],
                                                grid[level + 1][column + 1], grid[level + 1][column]};
                if (level % 2 == 1 && column % 2 == 1)
                    add_window(cell, inwards);
                else
                    mesh_.add_face(cell, materials_.wall);
            }
        // Below the sills and above the heads the columns run together into the undivided edge.
        const std::vector<Index>&sills = grid[1], &heads = grid[top() - 1];
        const Index foot = corner(wall, 0), eave = corner(wall, top());
        add({foot, corner(wall + 1, 0), sills.back()}, materials_.wall);
        for (std::size_t column = 0; column < columns; ++column) {
            add({foot, sills[column + 1], sills[column]}, materials_.wall);
            add({eave, heads[column], heads[column + 1]}, materials_.wall);
        }
        add({eave, heads.back(), corner(wall + 1, top())}, materials_.wall);
    }

    /// The pane behind the wall, and the reveals between.
    void add_window(const std::array<Index, 4>& hole, glm::dvec3 inwards) {
        std::array<Index, 4> pane{};
        for (std::size_t k = 0; k < 4; ++k) pane[k] = mesh_.add_position(mesh_.positions[hole[k]] + inwards);
        mesh_.add_face(pane, materials_.window);
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t next = (k + 1) % 4;
            add({hole[k], hole[next], pane[next], pane[k]}, materials_.wall);
        }
    }

    /// Over walls 0 and 2, or 1 and 3, whichever are shorter, stands a gable; the ridge runs between their
    /// middles.
    void add_gabled_roof() {
        const auto length = [&](std::size_t wall) {
            return glm::distance(corners_[wall], corners_[(wall + 1) % 4]);
        };
        const std::size_t gable = length(0) + length(2) <= length(1) + length(3) ? 0 : 1;
        std::array<Index, 2> ridge{};
        for (std::size_t end = 0; end < 2; ++end) {
            const std::size_t wall = gable + 2 * end;
            const glm::dvec2 middle = (corners_[wall] + corners_[(wall + 1) % 4]) / 2.0;
            ridge[end] = mesh_.add_position({middle, levels_.back() + design_.roof_height_m});
            add({corner(wall, top()), corner(wall + 1, top()), ridge[end]}, materials_.wall);
        }
        for (std::size_t end = 0; end < 2; ++end) {
            const std::size_t eave = gable + 1 + 2 * end;  // the wall after the gable `end`
            const std::array<Index, 4> slope{corner(eave, top()), corner(eave + 1, top()), ridge[1 - end],
                                             ridge[end]};
            if (is_planar(slope)) {
                mesh_.add_face(slope, materials_.roof);
            } else {  // the rectangle is not quite one
                add({slope[0], slope[1], slope[2]}, materials_.roof);
                add({slope[0], slope[2], slope[3]}, materials_.roof);
            }
        }
    }

    bool is_planar(const std::array<Index, 4>& face) const {
        const glm::dvec3 a = mesh_.positions[face[0]];
        const glm::dvec3 normal =
            glm::normalize(glm::cross(mesh_.positions[face[1]] - a, mesh_.positions[face[3]] - a));
        return std::abs(glm::dot(mesh_.positions[face[2]] - a, normal)) < kPlanarity / 2;
    }

    const BuildingDesign& design_;
    const BuildingMaterials& materials_;
    std::vector<glm::dvec2> corners_;
    std::vector<double> levels_;
    Mesh mesh_;
};

}  // namespace

Object build_building(const BuildingDesign& design, const BuildingMaterials& materials) {
    return {design.name, ObjectKind::Building, HouseBuilder(design, materials).build()};
}

}  // namespace keikan

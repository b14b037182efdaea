// SPDX-License-Identifier: Apache-2.0
#include "tower_shape.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "keikan/support/input_error.hpp"

namespace keikan {

namespace {

/// Height over upper width of a leg panel, and of a cage panel: common in drawings of such towers.
constexpr double kLegPanelShape = 1.15;
constexpr double kCagePanelShape = 1.2;
/// Where the four legs meet in a peak their axes are still this far apart: a cap plate.
constexpr double kPeakWidth = 0.2;

void require_of_tower(bool holds, const std::string& reason) {
    if (!holds) throw InputError("tower: " + reason);
}

void require_positive(double value, const char* what) {
    require_of_tower(value > 0 && std::isfinite(value), std::string(what) + " must be positive");
}

void require_that_it_stands(const TowerDesign& d) {
    require_positive(d.height_m, "height_m");
    require_positive(d.base_width_m, "base_width_m");
    require_positive(d.waist_width_m, "waist_width_m");
    require_positive(d.top_width_m, "top_width_m");
    require_positive(d.peak_above_arm_m, "peak_above_arm_m");
    require_positive(d.arm_spacing_m, "arm_spacing_m");
    require_positive(d.arm_depth_m, "arm_depth_m");
    require_positive(d.leg_width_base_m, "leg_width_base_m");
    require_positive(d.leg_width_top_m, "leg_width_top_m");
    require_positive(d.brace_width_base_m, "brace_width_base_m");
    require_positive(d.brace_width_top_m, "brace_width_top_m");
    require_positive(d.secondary_width_m, "secondary_width_m");
    for (const double length : d.arm_length_m) require_positive(length, "arm_length_m");
    require_of_tower(d.ground_arm_m >= 0 && std::isfinite(d.ground_arm_m),
                     "ground_arm_m must not be negative");
    require_of_tower(d.base_width_m >= d.waist_width_m && d.waist_width_m >= d.top_width_m,
                     "its widths must not grow upwards");
    require_of_tower(d.top_width_m > 4 * d.leg_width_top_m, "top_width_m leaves no room between the legs");
    require_of_tower(d.arm_spacing_m > d.arm_depth_m, "arm_spacing_m must be more than arm_depth_m");
    require_of_tower(d.peak_above_arm_m > d.arm_depth_m * (d.ground_arm_m > 0 ? 1.7 : 1.1),
                     "peak_above_arm_m must be well over arm_depth_m");
    require_of_tower(d.height_m - d.peak_above_arm_m - 2 * d.arm_spacing_m >= d.waist_width_m,
                     "height_m leaves no room for a body under the lowest arms");
    for (const double length : d.arm_length_m)
        require_of_tower(length > d.waist_width_m, "arms must reach out of the body: arm_length_m");
    require_of_tower(d.ground_arm_m == 0 || d.ground_arm_m > d.top_width_m,
                     "ground_arm_m must reach out of the body");
    const InsulatorDesign& i = d.insulator;
    require_positive(i.length_m, "insulator length_m");
    require_positive(i.disc_diameter_m, "insulator disc_diameter_m");
    require_of_tower(i.discs >= 1 && i.discs <= 200, "insulator discs must be 1 to 200");
    require_of_tower(i.length_m < d.arm_spacing_m, "insulator length_m must be less than arm_spacing_m");
    if (i.kind == InsulatorDesign::Kind::V) {
        require_of_tower(i.v_half_width_m > 0 && i.v_half_width_m < i.length_m,
                         "insulator v_half_width_m must be positive and less than its length_m");
        for (const double length : d.arm_length_m)
            require_of_tower(length - 2 * i.v_half_width_m > d.waist_width_m / 2,
                             "insulator v_half_width_m does not fit under the arms");
    }
}

/// Divides [from, to] into equal panels about kCagePanelShape times as tall as `width`; appends their upper
/// ends.
void add_panels(std::vector<double>& levels, double to, double width) {
    const double from = levels.back();
    const double count = std::max(1.0, std::round((to - from) / (kCagePanelShape * width)));
    for (int i = 1; i < static_cast<int>(count); ++i) levels.push_back(from + (to - from) * i / count);
    levels.push_back(to);
}

}  // namespace

TowerShape::TowerShape(const TowerDesign& design) : design_(design) {
    require_that_it_stands(design);
    // Widths of a geometric row of n panels: waist (1 + rho k)^n = base, k the growth of width per metre.
    const double waist = waist_m(), k = (design.base_width_m - design.waist_width_m) / waist;
    const double growth = std::log(design.base_width_m / design.waist_width_m);
    const double wanted =
        k > 0 ? growth / std::log1p(kLegPanelShape * k) : waist / (kLegPanelShape * design.waist_width_m);
    const double count = std::clamp(std::round(wanted), 1.0, 40.0);
    leg_levels_.push_back(waist);
    for (int i = 1; i < static_cast<int>(count); ++i) {
        const double share = i / count;
        const double depth = k > 0 ? design.waist_width_m * std::expm1(growth * share) / k : waist * share;
        leg_levels_.push_back(waist - depth);
    }

    cage_levels_.push_back(waist);
    for (int arm = 0; arm < 3; ++arm) {
        if (arm > 0) add_panels(cage_levels_, arm_m(arm), 2 * half_width(arm_m(arm)));
        cage_levels_.push_back(arm_m(arm) + design.arm_depth_m);
    }
    if (has_ground_arms()) {
        add_panels(cage_levels_, design.height_m - ground_arm_depth_m(), design.top_width_m);
        cage_levels_.push_back(design.height_m);
    } else {
        add_panels(cage_levels_, design.height_m, design.top_width_m);
    }
}

double TowerShape::arm_m(int arm) const {
    return design_.height_m - design_.peak_above_arm_m - (2 - arm) * design_.arm_spacing_m;
}

double TowerShape::half_width(double z) const {
    const auto between = [&](double z0, double w0, double z1, double w1) {
        return (w0 + (w1 - w0) * (z - z0) / (z1 - z0)) / 2;
    };
    if (z <= waist_m()) return between(0, design_.base_width_m, waist_m(), design_.waist_width_m);
    if (z <= cage_top_m())
        return between(waist_m(), design_.waist_width_m, cage_top_m(), design_.top_width_m);
    const double top = has_ground_arms() ? 0.8 * design_.top_width_m : kPeakWidth;
    return between(cage_top_m(), design_.top_width_m, design_.height_m, top);
}

double TowerShape::leg_width(double z) const {
    const double share = std::clamp(z / design_.height_m, 0.0, 1.0);
    return design_.leg_width_base_m + share * (design_.leg_width_top_m - design_.leg_width_base_m);
}

double TowerShape::brace_width(double z) const {
    const double share = std::clamp(z / design_.height_m, 0.0, 1.0);
    return design_.brace_width_base_m + share * (design_.brace_width_top_m - design_.brace_width_base_m);
}

glm::dvec3 TowerShape::node(int leg, double z) const {
    static constexpr std::array<std::array<double, 2>, 4> kSide{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    const auto& side = kSide[static_cast<std::size_t>(leg)];
    const double half = half_width(z);
    return {side[0] * half, side[1] * half, z};
}

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#include "tower_stand.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "keikan/support/input_error.hpp"

namespace keikan {

TowerStand stand_on_ground(const TowerDesign& design, glm::dvec2 place, double yaw_rad,
                           const std::function<double(double x_m, double y_m)>& ground) {
    constexpr double kFootRests = 1e-3;  // a millimetre above the ground: foundations reach far deeper
    constexpr std::array<glm::dvec2, 4> kFeet{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    const double cosine = std::cos(yaw_rad), sine = std::sin(yaw_rad);
    const auto ground_under = [&](std::size_t foot, double drop_m) {
        const glm::dvec2 local = foot_half_width_m(design, drop_m) * kFeet[foot];
        return ground(place.x + cosine * local.x - sine * local.y,
                      place.y + sine * local.x + cosine * local.y);
    };
    TowerStand stand;
    stand.yaw_rad = yaw_rad;
    double base = -std::numeric_limits<double>::infinity();
    for (std::size_t foot = 0; foot < 4; ++foot) base = std::max(base, ground_under(foot, 0));
    stand.base = {place, base};
    for (std::size_t foot = 0; foot < 4; ++foot) {
        double drop = 0;  // each round follows the ground outwards; a leg steeper than the ground settles
        for (int i = 0; i < 40; ++i) drop = std::max(0.0, base - ground_under(foot, drop));
        if (std::max(0.0, base - ground_under(foot, drop)) - drop > kFootRests)
            throw InputError("the ground falls too steeply under a tower's legs");
        stand.foot_drop_m[foot] = drop;
    }
    return stand;
}

}  // namespace keikan

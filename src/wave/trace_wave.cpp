// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/trace_wave.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "keikan/support/check.hpp"

namespace keikan {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// The first s > 0 at which f + g s - q s^2/2 is 0, for f >= 0 and q >= 0.
double first_zero(double f, double g, double q) {
    const double root = std::sqrt(g * g + 2 * q * f);
    if (g < 0) return 2 * f / (root - g);
    return q > 0 ? (g + root) / q : kNever;
}

/// One ray on its way; holds what each wave says of it.
class Approach {
  public:
    Approach(const WaveSurface& water, const glm::dvec3& origin, const glm::dvec3& direction)
        : water_(water), origin_(origin), direction_(direction), speed_(direction.x, direction.y) {
        for (std::size_t i = 0; i < water.size(); ++i) {
            const glm::dvec2 d = water.direction(i);
            const double turning =
                2 * std::numbers::pi / water.length_m(i) * (d.x * speed_.x + d.y * speed_.y);
            const WaveBounds bounds = water.bounds(i);
            curvature_[i] = bounds.second_m * turning * turning;
            crest_[i] = bounds.height_m;
        }
    }

    /// How far the bounds let the ray go from t, and whether it has met the water there.
    struct Look {
        bool met = false;
        double step = 0;
    };
    Look look(double t) {
        const double x = origin_.x + t * direction_.x, y = origin_.y + t * direction_.y;
        const double z = origin_.z + t * direction_.z;
        const std::span<double> heights(height_), rates(rate_);
        water_.along(x, y, speed_, heights, rates);
        // The bounds of all prefixes, from no wave (the slab below the crests) to all of them.
        double f = z - water_.crest_bound_m(), g = direction_.z, q = 0, best = 0;
        if (f > 0) best = first_zero(f + kTraceError, g, q);
        for (std::size_t i = 0; i < water_.size(); ++i) {
            f += crest_[i] - height_[i];
            g -= rate_[i];
            q += curvature_[i];
            // A bound costs a root; every eighth wave is enough to tell long from short.
            if (i % 8 == 7 && f > 0) best = std::max(best, first_zero(f + kTraceError, g, q));
        }
        if (f <= kTraceError && (g <= 0 || f < -kTraceError)) return {true, 0};
        return {false, std::max(best, first_zero(std::max(f, 0.0) + kTraceError, g, q))};
    }

  private:
    const WaveSurface& water_;
    glm::dvec3 origin_, direction_;
    glm::dvec2 speed_;
    std::array<double, WaveSurface::kMostWaves> curvature_, crest_, height_, rate_;
};

}  // namespace

std::optional<WaveMeeting> trace_wave(const WaveSurface& water, const glm::dvec3& origin,
                                      const glm::dvec3& direction, double t_max) {
    KEIKAN_CHECK(std::isfinite(t_max), "a ray without an end");
    // Down to the slab that holds the crests without asking the waves.
    const double above = origin.z - water.crest_bound_m();
    double t = 0;
    if (above > 0) {
        if (!(direction.z < 0)) return std::nullopt;
        t = above / -direction.z;
    }
    Approach approach(water, origin, direction);
    for (int steps = 1; t <= t_max; ++steps) {
        const Approach::Look look = approach.look(t);
        if (look.met) return WaveMeeting{t, steps};
        t += look.step;
    }
    return std::nullopt;
}

}  // namespace keikan

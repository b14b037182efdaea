// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace keikan {

/// Slopes that are not resolved: a normal distribution with mean 0 (Cox, Munk 1954: the sea's is nearly one).
struct SlopeCovariance {
    double xx = 0;
    double xy = 0;
    double yy = 0;

    /// Adds waves along `direction` (unit vector) of this mean square slope.
    void add(glm::dvec2 direction, double variance) {
        xx += variance * direction.x * direction.x;
        xy += variance * direction.x * direction.y;
        yy += variance * direction.y * direction.y;
    }
    double along(glm::dvec2 d) const { return xx * d.x * d.x + 2 * xy * d.x * d.y + yy * d.y * d.y; }
};

/// x with Phi(x) = u, of the standard normal distribution; u in (0, 1). Error: 1.2e-9 of |x| (Acklam 2003).
double inverse_normal(double u);

/// Slopes as they are *seen* from one direction: those that lean towards the viewer fill more of what he
/// sees. Around the resolved slope z0, seen along the unit vector v (from the water to the viewer), a slope z
/// is drawn with
///   density(z) = p(z - z0) max(0, v.z - v.x z.x - v.y z.y) / Z,
/// p the normal distribution, Z what makes it one. That neighbouring slopes hide one another is left out
/// (Bruneton et al. 2010 leave it out, too).
///
/// Requires: z0 itself faces the viewer.
class SeenSlopes {
  public:
    SeenSlopes(const SlopeCovariance& covariance, glm::dvec2 z0, const glm::dvec3& towards_viewer);

    /// The slope for a uniform point of the unit square.
    glm::dvec2 at(double u1, double u2) const;
    /// p(z - z0) / Z, without the factor that the viewer's direction makes; 0 where nothing varies.
    double density_by_projection(glm::dvec2 z) const;

  private:
    glm::dvec2 z0_;
    glm::dvec2 along_{1, 0};  ///< the viewer's direction on the water
    double sigma_along_ = 0;  ///< standard deviation along it
    double cross_per_along_ = 0, sigma_cross_ = 0;
    double horizontal_ = 0;  ///< length of the viewer's direction on the water
    double facing_ = 0;      ///< v.z - v . z0
    double limit_ = 0;       ///< beyond this many sigma a slope turns away from the viewer
    double normaliser_ = 1;  ///< Z
};

}  // namespace keikan

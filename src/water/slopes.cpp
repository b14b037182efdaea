// SPDX-License-Identifier: Apache-2.0
#include "keikan/water/slopes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>

namespace keikan {

namespace {

double density(double x) {
    return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
}

double distribution(double x) {
    return std::erfc(-x / std::numbers::sqrt2) / 2;
}

/// Beyond this many standard deviations there is less than 1e-15 of a normal distribution.
constexpr double kFarSigma = 8;

/// Integral of (limit - t) density(t) from minus infinity to u.
double leaning(double limit, double u) {
    return limit * distribution(u) + density(u);
}

/// u in (-infinity, limit) where `leaning` has reached the given share of its whole.
double inverse_leaning(double limit, double share) {
    const double wanted = share * leaning(limit, limit);
    double low = -kFarSigma - 1, high = std::min(limit, kFarSigma + 1);
    // The mean is -distribution(limit) / leaning(limit, limit): shifted by it, a normal distribution is near.
    double u = std::clamp(
        inverse_normal(std::clamp(share, 1e-15, 1 - 1e-15)) - distribution(limit) / leaning(limit, limit),
        low, high);
    // Newton, held between the bounds; where it leaves them, halves.
    for (int i = 0; i < 60; ++i) {
        const double off = leaning(limit, u) - wanted;
        (off > 0 ? high : low) = u;
        const double slope = (limit - u) * density(u);
        double next = slope > 0 ? u - off / slope : low;
        if (!(next > low && next < high)) next = (low + high) / 2;
        const double moved = std::abs(next - u);
        u = next;
        if (moved < 1e-5) break;  // Newton's next step would be of the order of its square
    }
    return u;
}

}  // namespace

double inverse_normal(double u) {
    // Acklam's rational approximations: one for the middle, one for both tails.
    constexpr double a[] = {-3.969683028665376e+01, 2.209460984245205e+02,  -2.759285104469687e+02,
                            1.383577518672690e+02,  -3.066479806614716e+01, 2.506628277459239e+00};
    constexpr double b[] = {-5.447609879822406e+01, 1.615858368580409e+02, -1.556989798598866e+02,
                            6.680131188771972e+01, -1.328068155288572e+01};
    constexpr double c[] = {-7.784894002430293e-03, -3.223964580411365e-01, -2.400758277161838e+00,
                            -2.549732539343734e+00, 4.374664141464968e+00,  2.938163982698783e+00};
    constexpr double d[] = {7.784695709041462e-03, 3.224671290700398e-01, 2.445134137142996e+00,
                            3.754408661907416e+00};
    constexpr double kTail = 0.02425;
    if (u < kTail || u > 1 - kTail) {
        const double q = std::sqrt(-2 * std::log(u < kTail ? u : 1 - u));
        const double x = (((((c[0] * q + c[1]) * q + c[2]) * q + c[3]) * q + c[4]) * q + c[5]) /
                         ((((d[0] * q + d[1]) * q + d[2]) * q + d[3]) * q + 1);
        return u < kTail ? x : -x;
    }
    const double q = u - 0.5, r = q * q;
    return (((((a[0] * r + a[1]) * r + a[2]) * r + a[3]) * r + a[4]) * r + a[5]) * q /
           (((((b[0] * r + b[1]) * r + b[2]) * r + b[3]) * r + b[4]) * r + 1);
}

SeenSlopes::SeenSlopes(const SlopeCovariance& covariance, glm::dvec2 z0, const glm::dvec3& towards_viewer)
    : z0_(z0) {
    horizontal_ = std::hypot(towards_viewer.x, towards_viewer.y);
    if (horizontal_ > 0) along_ = {towards_viewer.x / horizontal_, towards_viewer.y / horizontal_};
    const glm::dvec2 across(-along_.y, along_.x);
    const double aa = covariance.along(along_), cc = covariance.along(across);
    const double ac = (covariance.yy - covariance.xx) * along_.x * along_.y +
                      covariance.xy * (along_.x * along_.x - along_.y * along_.y);
    facing_ = towards_viewer.z - horizontal_ * (z0.x * along_.x + z0.y * along_.y);
    normaliser_ = facing_;
    if (!(aa > 0)) {
        sigma_cross_ = std::sqrt(std::max(0.0, cc));
        return;
    }
    sigma_along_ = std::sqrt(aa);
    cross_per_along_ = ac / aa;
    sigma_cross_ = std::sqrt(std::max(0.0, cc - ac * ac / aa));
    const double lean = horizontal_ * sigma_along_;
    limit_ = lean > 0 ? facing_ / lean : 2 * kFarSigma;
    if (limit_ < kFarSigma) normaliser_ = lean * leaning(limit_, limit_);
}

glm::dvec2 SeenSlopes::at(double u1, double u2) const {
    if (!(sigma_along_ > 0) && !(sigma_cross_ > 0)) return z0_;
    const double share1 = std::clamp(u1, 1e-15, 1 - 1e-15), share2 = std::clamp(u2, 1e-15, 1 - 1e-15);
    const double a = sigma_along_ > 0 ? sigma_along_ * inverse_leaning(limit_, share1) : 0;
    const double c = cross_per_along_ * a + sigma_cross_ * inverse_normal(share2);
    return {z0_.x + a * along_.x - c * along_.y, z0_.y + a * along_.y + c * along_.x};
}

double SeenSlopes::density_by_projection(glm::dvec2 z) const {
    if (!(sigma_along_ > 0) || !(sigma_cross_ > 0)) return 0;
    const double dx = z.x - z0_.x, dy = z.y - z0_.y;
    const double a = dx * along_.x + dy * along_.y, c = dy * along_.x - dx * along_.y;
    return density(a / sigma_along_) / sigma_along_ * density((c - cross_per_along_ * a) / sigma_cross_) /
           sigma_cross_ / normaliser_;
}

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#include "exact_wave.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace keikan::test {

namespace {

using Vector = std::vector<double>;

/// Solves a x = b by elimination with pivots.
Vector solved(std::vector<Vector> a, Vector b) {
    const std::size_t n = b.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const double f = a[i][k] / a[k][k];
            for (std::size_t j = k; j < n; ++j) a[i][j] -= f * a[k][j];
            b[i] -= f * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
        b[k] /= a[k][k];
    }
    return b;
}

/// Unknowns: heights above the bed [0, N], Fourier terms [N + 1, 2 N], speed, discharge, Bernoulli's
/// constant. Both sides of the flow's equations: the surface is a streamline, and the pressure on it is 0.
Vector residuals(const Vector& v, double e, double kd, std::size_t n) {
    const double speed = v[2 * n + 1], discharge = v[2 * n + 2], energy = v[2 * n + 3];
    Vector r;
    double mean = 0;
    for (std::size_t m = 0; m <= n; ++m) {
        const double x = static_cast<double>(m) * std::numbers::pi / static_cast<double>(n), y = v[m];
        double psi = -speed * y, ux = -speed, uy = 0;
        for (std::size_t i = 1; i <= n; ++i) {
            // sinh(j y) / cosh(j kd) and its like, written so that nothing overflows.
            const double j = static_cast<double>(i), b = v[n + i];
            const double up = std::exp(j * (y - kd)), down = std::exp(-j * (y + kd));
            const double norm = 1 + std::exp(-2 * j * kd);
            psi += b * (up - down) / norm * std::cos(j * x);
            ux += j * b * (up + down) / norm * std::cos(j * x);
            uy += j * b * (up - down) / norm * std::sin(j * x);
        }
        r.push_back(psi + discharge);
        r.push_back((ux * ux + uy * uy) / 2 + y - energy);
        mean += (m == 0 || m == n ? 0.5 : 1) * y / static_cast<double>(n);
    }
    r.push_back(mean - kd);
    r.push_back(v[0] - v[n] - 2 * e);
    return r;
}

}  // namespace

ExactWave exact_wave(double e, double kd, int terms) {
    const auto n = static_cast<std::size_t>(terms);
    Vector v(2 * n + 4, 0);
    const double speed = std::sqrt(std::tanh(kd));
    for (std::size_t m = 0; m <= n; ++m)
        v[m] = kd + e * std::cos(static_cast<double>(m) * std::numbers::pi / static_cast<double>(n));
    v[n + 1] = e / speed;
    v[2 * n + 1] = speed;
    v[2 * n + 2] = speed * kd;
    v[2 * n + 3] = speed * speed / 2 + kd;
    for (int step = 0; step < 12; ++step) {
        const Vector r = residuals(v, e, kd, n);
        std::vector<Vector> jacobian(v.size(), Vector(v.size()));
        for (std::size_t j = 0; j < v.size(); ++j) {
            constexpr double kStep = 1e-6;
            Vector up = v, down = v;
            up[j] += kStep;
            down[j] -= kStep;
            const Vector r_up = residuals(up, e, kd, n), r_down = residuals(down, e, kd, n);
            for (std::size_t i = 0; i < v.size(); ++i) jacobian[i][j] = (r_up[i] - r_down[i]) / (2 * kStep);
        }
        const Vector change = solved(jacobian, r);
        for (std::size_t i = 0; i < v.size(); ++i) v[i] -= change[i];
    }
    ExactWave wave;
    for (std::size_t m = 0; m <= n; ++m) wave.elevation.push_back(v[m] - kd);
    wave.speed = v[2 * n + 1];
    return wave;
}

}  // namespace keikan::test

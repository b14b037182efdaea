// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

namespace keikan::test {

/// A steady wave found numerically, with no series in it: the free surface by its heights at points from
/// crest to trough, the flow by a stream function of Fourier terms (Rienecker, Fenton 1981). In units where k
/// = g = 1.
struct ExactWave {
    std::vector<double> elevation;  ///< above the mean, at x = i pi / (size - 1)
    double speed = 0;               ///< c, for no mean current
};

/// Of height 2 e in water of depth kd, with `terms` Fourier terms.
ExactWave exact_wave(double e, double kd, int terms);

}  // namespace keikan::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cmath>
#include <cstdint>

namespace keikan::report {

/// How many pixels are off by how much of what they may be.
struct ErrorHistogram {
    static constexpr int kBins = 12;
    std::uint64_t none = 0;  ///< no error at all
    /// Bin i: error / bound in (2^(i - kBins), 2^(i + 1 - kBins)]; the first one from 0 on.
    std::array<std::uint64_t, kBins> bins{};
    std::uint64_t beyond = 0;  ///< above the bound

    /// Requires: error >= 0, bound > 0.
    void add(double error, double bound) {
        if (error == 0) {
            ++none;
        } else if (!(error <= bound)) {
            ++beyond;
        } else {
            int power = 0;  // error / bound in [2^(power - 1), 2^power)
            const double part = std::frexp(error / bound, &power);
            const int bin = kBins - 1 + power - (part == 0.5 ? 1 : 0);
            ++bins[static_cast<std::size_t>(bin < 0 ? 0 : bin)];
        }
    }
    friend bool operator==(const ErrorHistogram&, const ErrorHistogram&) = default;
};

}  // namespace keikan::report

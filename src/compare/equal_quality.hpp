// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>

#include "keikan/compare/comparison.hpp"

namespace keikan::compare {

/// Tries one kind of method with various N, each once.
class QualitySearch {
  public:
    QualitySearch(baseline::Method::Kind kind, const Scene& scene, const Geometry& geometry,
                  const Comparison& comparison, const ComparisonOptions& options);

    /// The search that compare_methods describes. `rmse`: kato's.
    EqualQuality operator()(Goal goal, double rmse);
    /// All that was tried, by rising N.
    std::vector<Trial> trials() const;

  private:
    bool samples() const {
        return kind_ == baseline::Method::Kind::Grid || kind_ == baseline::Method::Kind::Random;
    }
    int count(int step) const { return samples() ? step * step : step; }
    const Trial& trial(int count);
    Seconds extrapolated(int count);

    baseline::Method::Kind kind_;
    const Scene& scene_;
    const Geometry& geometry_;
    const Comparison& comparison_;
    const ComparisonOptions& options_;
    std::map<int, Trial> trials_;
};

}  // namespace keikan::compare

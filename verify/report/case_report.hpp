// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "crosscheck/compare_pixel.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "report/page.hpp"

namespace keikan::report {

/// Chooses, of pixel cases as they are checked, those that a page shows: the worst, those with a
/// disagreement, and of each PixelKind the first few. Memory: some thousand cases.
class CaseChoice {
  public:
    explicit CaseChoice(Engine engine) : engine_(engine) {}

    /// Cases come in their order.
    void add(const PixelCase& pixel_case, const crosscheck::PixelVerdict& verdict);

    /// Fills in `errors`, `pixels` and `disagreeing_left_out`.
    void fill(Page& page) const;

  private:
    struct Kept {
        PixelCase pixel_case;
        double error = 0;
        std::vector<crosscheck::Disagreement> disagreements;
        bool sample = false;
    };
    void drop_the_best();

    Engine engine_;
    ErrorHistogram errors_;
    std::map<std::uint64_t, Kept> kept_;  ///< by the number of the case
    std::uint64_t cases_ = 0;
    std::uint64_t disagreeing_ = 0;
    std::array<std::size_t, crosscheck::kPixelKinds> samples_{};
};

/// A case as a page shows it, with the answers of the engine (and of the traversal beside Engine::Splitting).
PixelToShow case_to_show(const PixelCase& pixel_case, Engine engine);

}  // namespace keikan::report

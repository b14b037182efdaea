// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "crosscheck/check_cases.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "keikan/model/pixel_case.hpp"

namespace keikan::fuzz {

/// Who is asked in a campaign, and how the answers are judged. An engine of the product, or in a test a
/// faulty one.
struct Examinee {
    std::string name;

    /// Judges cases side by side, with every rung of the oracle as far as it is wanted; `first` is the number
    /// of the first one in the campaign and chooses the samples. `finding` gets those with disagreements, in
    /// their order.
    std::function<crosscheck::CheckSummary(
        std::span<const PixelCase> cases, std::uint64_t first,
        const std::function<void(const PixelCase&, const crosscheck::PixelVerdict&)>& finding)>
        examine;

    /// Makes what judges one case after the other while a finding is shrunk, each in a thread of its own:
    /// quickly, by a certificate where there is one. `by_all_rungs`: the oracle itself is under suspicion.
    std::function<std::function<crosscheck::PixelVerdict(const PixelCase&)>(bool by_all_rungs)> make_judge;
};

/// An engine of the product under these options.
Examinee examinee_of(std::string name, const crosscheck::CaseCheckOptions& options);

}  // namespace keikan::fuzz

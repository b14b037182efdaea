// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/examinee.hpp"

#include <utility>

#include "crosscheck/sampling.hpp"

namespace keikan::fuzz {

Examinee examinee_of(std::string name, const crosscheck::CaseCheckOptions& options) {
    Examinee result;
    result.name = std::move(name);
    result.examine = [options](std::span<const PixelCase> cases, std::uint64_t first, const auto& finding) {
        crosscheck::CaseCheckOptions here = options;
        here.seed = first == 0 ? options.seed : crosscheck::draw_of(options.seed, first);
        if (first > 0) here.all_rungs_for_first = 0;
        std::size_t given = 0;
        const auto next = [&]() -> std::optional<PixelCase> {
            if (given == cases.size()) return std::nullopt;
            return cases[given++];
        };
        return crosscheck::check_cases(next, here, finding);
    };
    result.make_judge = [options](bool by_all_rungs) {
        const crosscheck::Proofs proofs{.rational = by_all_rungs,
                                        .boolean_sets = by_all_rungs,
                                        .on_disagreement = crosscheck::Proofs::OnDisagreement::Nothing};
        return [proofs, check = std::make_shared<crosscheck::CaseCheck>(options)](
                   const PixelCase& pixel_case) { return (*check)(pixel_case, proofs); };
    };
    return result;
}

}  // namespace keikan::fuzz

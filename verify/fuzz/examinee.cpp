// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/examinee.hpp"

#include <utility>
#include <vector>

#include "crosscheck/check_contacts.hpp"
#include "crosscheck/compare_pixel.hpp"
#include "crosscheck/sampling.hpp"

namespace keikan::fuzz {
namespace {

using crosscheck::CaseCheckOptions;
using crosscheck::Claim;
using crosscheck::PixelVerdict;

/// As crosscheck::check_case, but content with a certificate where a case fails.
class QuickJudge {
  public:
    QuickJudge(const CaseCheckOptions& options, bool by_all_rungs)
        : options_(options), by_all_rungs_(by_all_rungs), product_(options.engine) {}

    PixelVerdict operator()(const PixelCase& pixel_case) {
        const std::vector<FaceView> faces = pixel_case.faces();
        const crosscheck::Question question{pixel_case.pixel, faces, pixel_case.nearness()};
        std::vector<crosscheck::Disagreement> found;
        std::vector<Claim> claims;
        const auto claim = [&](const PixelCoverage& coverage) {
            claims.push_back(crosscheck::claim_of(coverage, faces.size(), question.pixel, found));
        };
        claim(product_(question.pixel, faces, question.nearness));
        PixelVerdict of_contacts;
        if (options_.contacts) {
            const PixelCoverage traversal = contacts_(question, of_contacts, by_all_rungs_);
            if (options_.engine == Engine::Splitting) claim(traversal);
        }
        PixelVerdict verdict = compare_(question, claims,
                                        {.rational = by_all_rungs_,
                                         .boolean_sets = by_all_rungs_,
                                         .on_disagreement = crosscheck::Proofs::OnDisagreement::Nothing});
        for (const auto* more : {&of_contacts.disagreements, &found})
            verdict.disagreements.insert(verdict.disagreements.end(), more->begin(), more->end());
        return verdict;
    }

  private:
    CaseCheckOptions options_;
    bool by_all_rungs_;
    VisibleAreas product_;
    crosscheck::PixelComparison compare_;
    crosscheck::ContactCheck contacts_;
};

}  // namespace

Examinee examinee_of(std::string name, const CaseCheckOptions& options) {
    Examinee result;
    result.name = std::move(name);
    result.examine = [options](std::span<const PixelCase> cases, std::uint64_t first, const auto& finding) {
        CaseCheckOptions here = options;
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
        return [judge = std::make_shared<QuickJudge>(options, by_all_rungs)](const PixelCase& pixel_case) {
            return (*judge)(pixel_case);
        };
    };
    return result;
}

}  // namespace keikan::fuzz

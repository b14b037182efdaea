// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_cases.hpp"

#include <vector>

#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "keikan/support/parallel.hpp"
#include "sampling.hpp"

namespace keikan::crosscheck {
namespace {

constexpr std::size_t kCasesAtOnce = 512;

/// What case number `index` of a file is due.
Proofs proofs_of(std::uint64_t index, const CaseCheckOptions& options) {
    const std::uint64_t draw = draw_of(options.seed, index);
    const bool all = index < options.all_rungs_for_first;
    // The published clipper is known to be wrong: rational splitting confirms it at a hundredth of the cost.
    const bool known_wrong = options.engine == Engine::Published;
    return {.rational = all || draw % options.rational_one_in == 0,
            .boolean_sets = !known_wrong && (all || draw % options.boolean_sets_one_in == 0),
            .on_disagreement =
                known_wrong ? Proofs::OnDisagreement::Rational : Proofs::OnDisagreement::BooleanSets};
}

}  // namespace

CaseCheck::CaseCheck(const CaseCheckOptions& options)
    : engine_(options.engine),
      with_contacts_(options.contacts),
      product_(options.engine),
      contacts_(options.kinds) {}

PixelVerdict CaseCheck::operator()(const PixelCase& pixel_case, const Proofs& proofs) {
    const std::vector<FaceView> faces = pixel_case.faces();
    const Question question{pixel_case.pixel, faces, pixel_case.nearness()};
    std::vector<Disagreement> faults;
    PixelVerdict of_contacts;
    std::vector<Claim> claims;
    claims.push_back(
        claim_of(product_(question.pixel, faces, question.nearness), faces.size(), question.pixel, faults));
    if (with_contacts_) {
        const PixelCoverage traversal = contacts_(question, of_contacts, proofs.rational);
        if (engine_ == Engine::Splitting) {
            claims.push_back(claim_of(traversal, faces.size(), question.pixel, faults));
            claims.back().by = "by the traversal";
        }
    }
    GivenAnswer given;
    if (pixel_case.areas) given.areas = *pixel_case.areas;
    if (pixel_case.background) given.background = &*pixel_case.background;
    const bool answered = pixel_case.areas || pixel_case.background;
    PixelVerdict verdict = compare_(question, claims, proofs, answered ? &given : nullptr);
    verdict.contacts = of_contacts.contacts;
    verdict.kinds = of_contacts.kinds;
    verdict.disagreements.insert(verdict.disagreements.begin(), faults.begin(), faults.end());
    verdict.disagreements.insert(verdict.disagreements.end(), of_contacts.disagreements.begin(),
                                 of_contacts.disagreements.end());
    for (Disagreement& d : verdict.disagreements) d.case_id = pixel_case.id;
    return verdict;
}

PixelVerdict check_case(const PixelCase& pixel_case, std::uint64_t index, const CaseCheckOptions& options) {
    return CaseCheck(options)(pixel_case, proofs_of(index, options));
}

CheckSummary check_cases(std::istream& in, const std::string& name, const CaseCheckOptions& options) {
    PixelCaseReader reader(in, name);
    return check_cases([&] { return reader.next(); }, options);
}

CheckSummary check_cases(const std::function<std::optional<PixelCase>()>& next,
                         const CaseCheckOptions& options,
                         const std::function<void(const PixelCase&, const PixelVerdict&)>& finding,
                         const std::function<void(const PixelCase&, const PixelVerdict&)>& seen) {
    CheckSummary summary;
    for (std::uint64_t first = 0;;) {
        std::vector<PixelCase> cases;
        while (cases.size() < kCasesAtOnce)
            if (auto pixel_case = next())
                cases.push_back(std::move(*pixel_case));
            else
                break;
        std::vector<PixelVerdict> verdicts(cases.size());
        parallel_ranges(cases.size(), 8, [&](std::size_t begin, std::size_t end) {
            CaseCheck check(options);
            for (std::size_t i = begin; i < end; ++i)
                verdicts[i] = check(cases[i], proofs_of(first + i, options));
        });
        for (std::size_t i = 0; i < cases.size(); ++i) {
            summary.add(verdicts[i], cases[i].pixel, cases[i].id, cases[i].polygons.size());
            if (seen) seen(cases[i], verdicts[i]);
            if (finding && !verdicts[i].disagreements.empty()) finding(cases[i], verdicts[i]);
        }
        first += cases.size();
        if (cases.size() < kCasesAtOnce) return summary;
    }
}

}  // namespace keikan::crosscheck

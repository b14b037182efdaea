// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare_pixel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "error_bounds.hpp"

namespace keikan::crosscheck {
namespace {

/// |claimed - exact| lies in [low, high].
struct ErrorRange {
    double low = 0;
    double high = 0;
};

/// The truth about one area as far as a rung knows it, and how far the claim is from it.
struct Comparison {
    double exact = 0;
    ErrorRange error;
};

/// One for each face and the background at the end, claim after claim.
using Comparisons = std::vector<Comparison>;

double claimed_at(const Claim& claim, std::size_t i) {
    return i < claim.areas.size() ? claim.areas[i] : claim.background;
}

void compare(const Claim& claim, const oracle::CertifiedAreas& truth, Comparisons& result) {
    for (std::size_t i = 0; i <= claim.areas.size(); ++i) {
        const oracle::CertifiedArea& area = i < claim.areas.size() ? truth.areas[i] : truth.background;
        const double claimed = claimed_at(claim, i);
        const double difference = std::isfinite(claimed) ? std::abs(claimed - area.value) : HUGE_VAL;
        result.push_back({area.value, {difference - area.error, difference + area.error}});
    }
}

void compare(const Claim& claim, const oracle::ExactAreas& truth, Comparisons& result) {
    for (std::size_t i = 0; i <= claim.areas.size(); ++i) {
        const mpq_class& area = i < claim.areas.size() ? truth.areas[i] : truth.background;
        const double claimed = claimed_at(claim, i);
        const double error =
            std::isfinite(claimed) ? mpq_class(abs(mpq_class(claimed) - area)).get_d() : HUGE_VAL;
        result.push_back({area.get_d(), {error, error}});
    }
}

template <class Truth>
Comparisons compared(std::span<const Claim> claims, const Truth& truth) {
    Comparisons result;
    for (const Claim& claim : claims) compare(claim, truth, result);
    return result;
}

bool all_hold(const Comparisons& comparisons, double bound) {
    return std::ranges::all_of(comparisons, [&](const Comparison& c) { return c.error.high <= bound; });
}

bool within(const oracle::CertifiedArea& certified, const mpq_class& exact) {
    return abs(mpq_class(certified.value) - exact) <= mpq_class(certified.error);
}

bool within(const oracle::CertifiedAreas& certified, const oracle::ExactAreas& exact) {
    for (std::size_t i = 0; i < exact.areas.size(); ++i)
        if (!within(certified.areas[i], exact.areas[i])) return false;
    return within(certified.background, exact.background);
}

void add_differences(const Question& question, const Claim& claim, std::span<const Comparison> comparisons,
                     std::vector<Disagreement>& out) {
    const double bound = area_bound(question.faces.size());
    for (std::size_t i = 0; i < comparisons.size(); ++i) {
        if (comparisons[i].error.high <= bound) continue;
        Disagreement difference{.kind = Disagreement::Kind::Background, .pixel = question.pixel};
        if (i < question.faces.size()) {
            difference.kind = Disagreement::Kind::Area;
            difference.face = question.faces[i].id;
        }
        difference.claimed = claimed_at(claim, i);
        difference.exact = comparisons[i].exact;
        difference.error = comparisons[i].error.high;
        difference.bound = bound;
        difference.note = claim.by;
        out.push_back(difference);
    }
}

/// Returns |areas + background - 1|.
double check_sum(const Question& question, const Claim& claim, std::vector<Disagreement>& out) {
    const double excess = excess_of_sum(claim), error = std::abs(excess);
    const double allowed = sum_bound(question.faces.size());
    if (!(error <= allowed))
        out.push_back({.kind = Disagreement::Kind::Sum,
                       .pixel = question.pixel,
                       .claimed = 1 + excess,
                       .exact = 1,
                       .error = error,
                       .bound = allowed,
                       .note = claim.by});
    return error;
}

void check_given(const Question& question, const GivenAnswer& given, const oracle::ExactAreas& exact,
                 std::vector<Disagreement>& out) {
    const auto check = [&](const std::string& stated, const mpq_class& truth, std::optional<FaceId> face) {
        mpq_class claimed(stated);
        claimed.canonicalize();
        if (claimed == truth) return;
        out.push_back({.kind = Disagreement::Kind::Given,
                       .pixel = question.pixel,
                       .face = face,
                       .claimed = claimed.get_d(),
                       .exact = truth.get_d(),
                       .note = fmt::format("stated as {}, about {:.17g}, exactly about {:.17g}", stated,
                                           claimed.get_d(), truth.get_d())});
    };
    for (std::size_t i = 0; i < given.areas.size(); ++i)
        check(given.areas[i], exact.areas[i], question.faces[i].id);
    if (given.background) check(*given.background, exact.background, std::nullopt);
}

}  // namespace

RungCounts& RungCounts::operator+=(const RungCounts& other) {
    quad += other.quad;
    certified += other.certified;
    rational += other.rational;
    cgal += other.cgal;
    return *this;
}

ContactCounts& ContactCounts::operator+=(const ContactCounts& other) {
    checked += other.checked;
    mismatches += other.mismatches;
    folds += other.folds;
    constructed += other.constructed;
    return *this;
}

double excess_of_sum(const Claim& claim) {
    // Neumaier's sum: what each addition rounds away is kept and added at the end.
    double sum = -1, lost = 0;
    for (std::size_t i = 0; i <= claim.areas.size(); ++i) {
        const double term = claimed_at(claim, i);
        const double next = sum + term;
        lost += std::abs(sum) >= std::abs(term) ? (sum - next) + term : (term - next) + sum;
        sum = next;
    }
    return sum + lost;
}

Claim claim_of(const PixelCoverage& coverage, std::size_t faces, PixelIndex pixel,
               std::vector<Disagreement>& faults) {
    Claim claim{std::vector<double>(faces, 0.0), coverage.background};
    const auto fault = [&](std::string note) {
        faults.push_back({.kind = Disagreement::Kind::Form, .pixel = pixel, .note = std::move(note)});
    };
    std::int64_t last = -1;
    for (const VisiblePart& part : coverage.parts) {
        if (part.face <= last) fault("the parts are not in rising order of their faces");
        last = part.face;
        if (!(part.area > 0 && part.area <= 1)) fault(fmt::format("an area of {:.17g}", part.area));
        if (part.face < faces)
            claim.areas[part.face] += part.area;
        else
            fault(fmt::format("a part of face {} of {}", part.face, faces));
    }
    if (!(coverage.background >= 0 && coverage.background <= 1))
        fault(fmt::format("a background of {:.17g}", coverage.background));
    return claim;
}

PixelVerdict PixelComparison::operator()(const Question& question, std::span<const Claim> claims,
                                         const Proofs& proofs, const GivenAnswer* given) {
    PixelVerdict verdict;
    verdict.faces = question.faces.size();
    std::vector<Disagreement>& out = verdict.disagreements;
    const double bound = area_bound(question.faces.size());
    const auto rungs_differ = [&](const char* which) {
        out.push_back({.kind = Disagreement::Kind::Rungs, .pixel = question.pixel, .note = which});
    };

    const oracle::CertifiedAreas quick = certified_(question.pixel, question.faces, question.nearness);
    ++verdict.rungs.quad;
    verdict.rungs.certified += quick.certified;
    Comparisons comparisons;
    if (quick.certified) comparisons = compared(claims, quick);
    bool settled = quick.certified && all_hold(comparisons, bound);

    std::optional<oracle::ExactAreas> exact;
    const bool enough =
        settled || (quick.certified && proofs.on_disagreement == Proofs::OnDisagreement::Nothing);
    if (!enough || given || proofs.rational || proofs.boolean_sets) {
        exact = oracle::areas_by_rational_splitting(question.pixel, question.faces, question.nearness);
        ++verdict.rungs.rational;
        if (quick.certified && !within(quick, *exact))
            rungs_differ("rational splitting is outside of the certified range");
        comparisons = compared(claims, *exact);
        settled = all_hold(comparisons, bound);
    }
    if (proofs.boolean_sets || (!settled && proofs.on_disagreement == Proofs::OnDisagreement::BooleanSets)) {
        const auto sets = oracle::areas_by_boolean_sets(question.pixel, question.faces, question.nearness);
        ++verdict.rungs.cgal;
        if (!(sets == *exact)) rungs_differ("CGAL's Boolean set operations and rational splitting differ");
    }

    const std::size_t areas = question.faces.size() + 1;
    for (std::size_t c = 0; c < claims.size(); ++c) {
        add_differences(question, claims[c], std::span(comparisons).subspan(c * areas, areas), out);
        verdict.sum_error = std::max(verdict.sum_error, check_sum(question, claims[c], out));
    }
    if (given) check_given(question, *given, *exact, out);
    for (const Comparison& c : comparisons) verdict.area_error = std::max(verdict.area_error, c.error.high);
    return verdict;
}

}  // namespace keikan::crosscheck

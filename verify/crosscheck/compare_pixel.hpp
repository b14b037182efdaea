// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "disagreement.hpp"
#include "keikan/model/coverage.hpp"
#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"
#include "oracle/exact_areas.hpp"
#include "pixel_kinds.hpp"

namespace keikan::crosscheck {

/// What is asked, of product and oracle alike.
struct Question {
    PixelIndex pixel;
    std::span<const FaceView> faces;
    Nearness nearness = Nearness::ByDepth;
};

/// What the product answers: an area for each face asked about (0 where it lists none), and the background.
struct Claim {
    std::vector<double> areas;
    double background = 1;
    std::string by = {};  ///< the engine, where a disagreement shall name it
};

/// The answer of VisibleAreas for `faces` faces as a claim; whatever of its contract (rising positions, areas
/// in (0, 1], background in [0, 1]) does not hold is added to `faults`.
Claim claim_of(const PixelCoverage& coverage, std::size_t faces, PixelIndex pixel,
               std::vector<Disagreement>& faults);

/// Which proofs are wanted beyond what the comparison itself needs.
struct Proofs {
    bool rational = false;      ///< areas_by_rational_splitting in any case
    bool boolean_sets = false;  ///< and CGAL's Boolean set operations
    /// How far to go where an area seems to be off.
    enum class OnDisagreement {
        BooleanSets,  ///< rational splitting, and if that confirms it, the last word
        Rational,     ///< rational splitting alone
        Nothing,      ///< a certified difference is enough: the claim is known to be rough
    } on_disagreement = OnDisagreement::BooleanSets;
};

/// The exact answers that a case states, "p/q".
struct GivenAnswer {
    std::span<const std::string> areas;  ///< empty, or one for each face
    const std::string* background = nullptr;
};

/// How many pixels each rung of the oracle has answered.
struct RungCounts {
    std::uint64_t quad = 0;       ///< asked in extended precision with a running error bound
    std::uint64_t certified = 0;  ///< ... of which with a certificate
    std::uint64_t rational = 0;
    std::uint64_t cgal = 0;
    RungCounts& operator+=(const RungCounts& other);
    friend bool operator==(const RungCounts&, const RungCounts&) = default;
};

/// Contacts of the paper's clipper, against exact classification (ContactCheck).
struct ContactCounts {
    std::uint64_t checked = 0;
    std::uint64_t mismatches = 0;   ///< clip steps in which any contact differs
    std::uint64_t folds = 0;        ///< ClipStatistics::folds
    std::uint64_t constructed = 0;  ///< clip steps put to CGAL's constructions too
    ContactCounts& operator+=(const ContactCounts& other);
    friend bool operator==(const ContactCounts&, const ContactCounts&) = default;
};

struct PixelVerdict {
    std::size_t faces = 0;  ///< that were asked about: they choose the bounds
    double area_error = 0;  ///< the largest |claimed - exact| of faces and background is at most this
    double sum_error = 0;   ///< |areas + background - 1|
    RungCounts rungs;
    ContactCounts contacts;
    PixelKinds kinds = 0;  ///< where ContactCheck was asked for them
    std::vector<Disagreement> disagreements;
};

/// The one place that knows both answers. One object a thread.
///
/// A claim holds when every area is within area_bound(faces.size()) of the exact one and the sum within
/// sum_bound(). The certified rung decides where it can: where it gives no certificate, or where the bound
/// lies within its own error of the difference, rational splitting decides; CGAL's Boolean set operations
/// have the last word on every disagreement. Wherever two rungs answered, they must agree.
class PixelComparison {
  public:
    /// Several claims are several engines' answers to the same question: all must hold, and the errors of the
    /// verdict are the largest of any.
    PixelVerdict operator()(const Question& question, std::span<const Claim> claims,
                            const Proofs& proofs = {}, const GivenAnswer* given = nullptr);
    PixelVerdict operator()(const Question& question, const Claim& claim, const Proofs& proofs = {},
                            const GivenAnswer* given = nullptr) {
        return (*this)(question, std::span(&claim, 1), proofs, given);
    }

  private:
    oracle::CertifiedSplitting certified_;
};

/// areas + background - 1, summed without rounding errors that matter.
double excess_of_sum(const Claim& claim);

}  // namespace keikan::crosscheck

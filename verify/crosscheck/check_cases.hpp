// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <functional>
#include <istream>
#include <optional>
#include <string>

#include "check_contacts.hpp"
#include "check_summary.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "keikan/model/pixel_case.hpp"

namespace keikan::crosscheck {

struct CaseCheckOptions {
    Engine engine = Engine::Splitting;
    /// Every contact of the paper's clipper is classified too, and its areas (Engine::Traversal) are held to
    /// the same bounds.
    bool contacts = true;
    bool kinds = false;      ///< PixelVerdict::kinds is found too
    std::uint64_t seed = 1;  ///< chooses the samples below
    /// So many cases at the start of each file are put to every rung; after them one in so many.
    std::uint64_t all_rungs_for_first = 256;
    std::uint64_t rational_one_in = 16;
    std::uint64_t boolean_sets_one_in = 128;
};

/// Puts one pixel case after the other to VisibleAreas and to the oracle, and holds both to the answers that
/// a case states. One object a thread.
class CaseCheck {
  public:
    /// Of the options: engine, contacts and kinds.
    explicit CaseCheck(const CaseCheckOptions& options);

    /// Contacts are put to CGAL's constructions too where `proofs` wants rational splitting.
    PixelVerdict operator()(const PixelCase& pixel_case, const Proofs& proofs);

  private:
    Engine engine_;
    bool with_contacts_;
    VisibleAreas product_;
    PixelComparison compare_;
    ContactCheck contacts_;
};

/// Puts each pixel case of the stream to VisibleAreas and to the oracle, and holds both to the answers that
/// the case states. Cases are checked side by side, a few hundred at a time, so a file may be of any length.
///
/// Properties: (1) Everything but `seconds` is the same for any number of threads.
/// Errors:     InputError, as PixelCaseReader.
CheckSummary check_cases(std::istream& in, const std::string& name, const CaseCheckOptions& options);

/// The same for the cases that `next` gives, one after the other, until it gives none. `finding` is called,
/// in their order, with each case that has a disagreement, and `seen` with every case.
CheckSummary check_cases(const std::function<std::optional<PixelCase>()>& next,
                         const CaseCheckOptions& options,
                         const std::function<void(const PixelCase&, const PixelVerdict&)>& finding = {},
                         const std::function<void(const PixelCase&, const PixelVerdict&)>& seen = {});

/// One case; `index` is its place in the file.
PixelVerdict check_case(const PixelCase& pixel_case, std::uint64_t index, const CaseCheckOptions& options);

}  // namespace keikan::crosscheck

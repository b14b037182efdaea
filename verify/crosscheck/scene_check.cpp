// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "check_contacts.hpp"
#include "claimed_row.hpp"
#include "error_bounds.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/parallel.hpp"
#include "sampling.hpp"

namespace keikan::crosscheck {
namespace {

/// CGAL's Boolean set operations cost about 15 ms a pixel and far more in a crowded one; where a whole row is
/// wrong they confirm the first few.
constexpr int kConfirmedPerRow = 4;

std::uint16_t at_most_16_bits(std::size_t count) {
    return static_cast<std::uint16_t>(std::min<std::size_t>(count, 0xFFFF));
}

void add_sorted(std::vector<std::uint32_t>& faces, std::uint32_t face) {
    const auto at = std::ranges::lower_bound(faces, face);
    if (at == faces.end() || *at != face) faces.insert(at, face);
}

}  // namespace

struct SceneCheck::RowResult {
    CheckSummary summary;
    UnflaggedErrors unflagged;
};

/// The pixels of one row, one after the other. Writes to the rows of the pictures that it owns alone.
class SceneCheck::RowCheck {
  public:
    RowCheck(SceneCheck& check, const ScanBand& band, int y)
        : check_(check),
          y_(y),
          claimed_(claimed_row(band, y, check.size_.width, check.faces_)),
          row_(check.bins_.row(y)) {
        if (check.options_.engine != Engine::Splitting) engine_.emplace(check.options_.engine);
        if (check.options_.kinds) contacts_ = ContactCheck(true);
    }

    RowResult run() {
        for (const Disagreement& fault : claimed_.faults) {
            result_.summary.add(fault);
            if (fault.pixel.x >= 0 && fault.pixel.x < check_.size_.width) check_.wrong_[fault.pixel] = 1;
        }
        for (int x = 0; x < check_.size_.width; ++x) check_pixel({x, y_});
        return std::move(result_);
    }

  private:
    using Source = ClaimedRow::Source;

    void check_pixel(PixelIndex pixel) {
        const ClaimedRow::Pixel& claimed = claimed_.pixels[static_cast<std::size_t>(pixel.x)];
        check_.flags_[pixel] = claimed.source == Source::ExactAreas ? Flag::ExactAreas
                               : claimed.source == Source::Scanline ? Flag::Scanline
                                                                    : Flag::OneFace;
        const bool flagged = claimed.source == Source::ExactAreas;
        if (claimed.source == Source::Missing || (check_.options_.flagged_only && !flagged)) return;

        const std::span<const std::uint32_t> candidates = row_.at(pixel.x);
        PixelVerdict verdict = verdict_of(pixel, claimed, candidates);
        if (!flagged && !check_.options_.spans_are_exact) {
            // The scanline's weights are an approximation: how good it is, is told apart from the verdict.
            result_.unflagged.add(verdict.area_error);
            check_.errors_[pixel] = static_cast<float>(verdict.area_error);
            std::erase_if(verdict.disagreements, [](const Disagreement& d) { return is_of_areas(d.kind); });
            verdict.area_error = verdict.sum_error = 0;
        } else {
            check_.errors_[pixel] = static_cast<float>(verdict.area_error);
        }
        if (!verdict.disagreements.empty()) check_.wrong_[pixel] = 1;
        check_.face_counts_[pixel] = at_most_16_bits(candidates.size());
        check_.asked_counts_[pixel] = at_most_16_bits(verdict.faces);
        check_.kinds_[pixel] = verdict.kinds;
        result_.summary.add(verdict, pixel, {}, candidates.size());
    }

    PixelVerdict verdict_of(PixelIndex pixel, const ClaimedRow::Pixel& claimed,
                            std::span<const std::uint32_t> candidates) {
        const Proofs proofs = proofs_for(pixel, claimed);
        const std::span<const ClaimedRow::Part> parts = claimed_.parts_of(claimed);
        if (proofs.rational || proofs.boolean_sets)
            asked_.assign(candidates.begin(), candidates.end());
        else {
            check_.hiding_(pixel, candidates, remaining_);
            if (remaining_.decided() && agrees_exactly(claimed, parts)) return {};
            asked_.swap(remaining_.faces);
        }
        // A face that is claimed to be seen is asked about even where it cannot be.
        for (const ClaimedRow::Part& part : parts) add_sorted(asked_, part.face);
        views_.clear();
        for (const std::uint32_t face : asked_) views_.push_back(check_.faces_[face]);

        std::vector<Disagreement> faults;
        const Claim claim = claim_for(pixel, claimed, faults);
        PixelVerdict verdict = compare_({pixel, views_, Nearness::ByDepth}, claim, proofs);
        verdict.disagreements.insert(verdict.disagreements.begin(), faults.begin(), faults.end());
        if (check_.options_.contacts) contacts_({pixel, views_, Nearness::ByDepth}, verdict);
        confirmed_ += !verdict.disagreements.empty();
        return verdict;
    }

    Proofs proofs_for(PixelIndex pixel, const ClaimedRow::Pixel& claimed) const {
        const SceneCheckOptions& options = check_.options_;
        const std::uint64_t draw = draw_of(options.seed, pixel);
        const bool rough = claimed.source != Source::ExactAreas && !options.spans_are_exact;
        using enum Proofs::OnDisagreement;
        return {.rational = draw % options.rational_one_in == 0,
                .boolean_sets = draw % options.boolean_sets_one_in == 0,
                .on_disagreement = rough                           ? Nothing
                                   : confirmed_ < kConfirmedPerRow ? BooleanSets
                                                                   : Rational};
    }

    /// What the product says of the faces `asked_`: the scan, or another engine where the pixel is divided
    /// exactly.
    Claim claim_for(PixelIndex pixel, const ClaimedRow::Pixel& claimed, std::vector<Disagreement>& faults) {
        if (engine_ && claimed.source == Source::ExactAreas)
            return claim_of((*engine_)(pixel, views_, Nearness::ByDepth), views_.size(), pixel, faults);
        Claim claim{std::vector<double>(asked_.size(), 0.0), claimed.background};
        for (const ClaimedRow::Part& part : claimed_.parts_of(claimed)) {
            const auto at = std::ranges::lower_bound(asked_, part.face) - asked_.begin();
            claim.areas[static_cast<std::size_t>(at)] += part.area;
        }
        return claim;
    }

    /// Whether the claim is what CertainHiding has decided, to the last bit.
    bool agrees_exactly(const ClaimedRow::Pixel& claimed, std::span<const ClaimedRow::Part> parts) const {
        if (remaining_.faces.empty()) return parts.empty() && claimed.background == 1;
        return parts.size() == 1 && parts[0].face == *remaining_.cover && parts[0].area == 1 &&
               claimed.background == 0;
    }

    SceneCheck& check_;
    int y_;
    ClaimedRow claimed_;
    FaceBins::Row row_;
    PixelComparison compare_;
    ContactCheck contacts_;
    std::optional<VisibleAreas> engine_;
    CertainHiding::Remaining remaining_;
    std::vector<std::uint32_t> asked_;
    std::vector<FaceView> views_;
    int confirmed_ = 0;
    RowResult result_;
};

SceneCheck::SceneCheck(const ProjectedFaces& faces, const Geometry& geometry, ImageSize size,
                       const SceneCheckOptions& options)
    : faces_(faces),
      geometry_(geometry),
      size_(size),
      options_(options),
      bins_(faces, size),
      hiding_(faces),
      errors_(size),
      flags_(size),
      wrong_(size),
      face_counts_(size),
      asked_counts_(size),
      kinds_(size) {}

void SceneCheck::take(const ScanBand& band) {
    KEIKAN_CHECK(band.first_row == next_row_ && band.rows > 0 && band.first_row + band.rows <= size_.height,
                 "a band of the rows " << band.first_row << " + " << band.rows << " came where " << next_row_
                                       << " was next");
    const auto rows = static_cast<std::size_t>(band.rows);
    KEIKAN_CHECK(band.span_begin.size() == rows + 1 && band.divided_begin.size() == rows + 1,
                 "the band from row " << band.first_row << " on has no table of its rows");
    for (const Disagreement& fault : attribute_faults(band, geometry_, faces_)) summary_.add(fault);
    std::vector<RowResult> results(rows);
    parallel_for(rows, [&](std::size_t i) {
        results[i] = RowCheck(*this, band, band.first_row + static_cast<int>(i)).run();
    });
    for (const RowResult& result : results) {
        summary_ += result.summary;
        unflagged_ += result.unflagged;
    }
    next_row_ += band.rows;
}

std::vector<std::uint32_t> SceneCheck::faces_asked(PixelIndex pixel) const {
    CertainHiding::Remaining remaining;
    const FaceBins::Row row = bins_.row(pixel.y);
    hiding_(pixel, row.at(pixel.x), remaining);
    return remaining.faces;
}

const CheckSummary& SceneCheck::finish() {
    for (; next_row_ < size_.height; ++next_row_)
        summary_.add(
            {.kind = Disagreement::Kind::Form, .pixel = {0, next_row_}, .note = "the row never came"});
    return summary_;
}

}  // namespace keikan::crosscheck

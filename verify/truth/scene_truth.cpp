// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "crosscheck/claimed_row.hpp"
#include "crosscheck/error_bounds.hpp"
#include "crosscheck/sampling.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/parallel.hpp"
#include "rounding.hpp"

namespace keikan::truth {
namespace {

/// The exact coverages of one pixel by the mattes in it, as far as they are known: ranges, or numbers.
struct MatteSums {
    struct Sum {
        std::uint32_t matte = 0;
        std::uint32_t faces = 0;  ///< that were asked about
        long double value = 0;    ///< near the coverage: off by `error`, and by the roundings of the sum
        double error = 0;
        mpq_class exact = 0;     ///< where the pixel is known exactly
        float coverage = 0;      ///< nearest to the exact coverage, once settled
        std::uint16_t code = 0;  ///< likewise

        Range range() const {
            const auto middle = static_cast<double>(value);
            if (faces == 0) return {middle, middle};
            // A sum of at most 1 was rounded once for each face, and is rounded to a double here.
            constexpr double kSumRounding = std::numeric_limits<long double>::epsilon();
            const double slack = error + kSumRounding * faces + 0x1p-53;
            return {middle - slack, middle + slack};
        }
    };
    std::vector<Sum> sums;  ///< by rising matte, background last

    Sum& of(std::uint32_t matte) {
        const auto at = std::ranges::lower_bound(sums, matte, {}, &Sum::matte);
        if (at != sums.end() && at->matte == matte) return *at;
        return *sums.insert(at, Sum{.matte = matte});
    }
};

void keep_worst(std::vector<TruthSummary::Place>& worst, const TruthSummary::Place& place) {
    if (place.error == 0) return;
    const auto at =
        std::ranges::upper_bound(worst, place.error, std::ranges::greater{}, &TruthSummary::Place::error);
    worst.insert(at, place);
    if (worst.size() > TruthSummary::kWorstKept) worst.pop_back();
}

}  // namespace

TruthSummary& TruthSummary::operator+=(const TruthSummary& later) {
    pixels += later.pixels;
    polygons += later.polygons;
    unsettled += later.unsettled;
    rungs += later.rungs;
    values += later.values;
    differing_codes += later.differing_codes;
    at_boundary += later.at_boundary;
    differing_at_boundary += later.differing_at_boundary;
    form_faults += later.form_faults;
    max_error = std::max(max_error, later.max_error);
    max_sum_error = std::max(max_sum_error, later.max_sum_error);
    for (const Place& place : later.worst) keep_worst(worst, place);
    for (const Place& place : later.differing)
        if (differing.size() < kWorstKept) differing.push_back(place);
    return *this;
}

struct SceneTruth::RowResult {
    std::vector<Share> shares;
    std::vector<std::size_t> begin{0};
    TruthSummary summary;
};

/// The pixels of one row, one after the other.
class SceneTruth::RowTruth {
  public:
    RowTruth(const SceneTruth& truth, const ScanBand& band, int y, int width)
        : truth_(truth),
          y_(y),
          claimed_(crosscheck::claimed_row(band, y, width, truth.faces_)),
          row_(truth.bins_.row(y)) {}

    RowResult run() {
        result_.summary.form_faults = claimed_.faults.size();
        for (int x = 0; x < static_cast<int>(claimed_.pixels.size()); ++x) {
            const PixelIndex pixel{x, y_};
            ++result_.summary.pixels;
            result_.summary.polygons += row_.at(x).size();
            add_exact(pixel);
            compare(pixel);
            result_.begin.push_back(result_.shares.size());
        }
        return std::move(result_);
    }

  private:
    /// Fills in `sums_` and appends the pixel's shares.
    void add_exact(PixelIndex pixel) {
        sums_.sums.clear();
        truth_.hiding_(pixel, row_.at(pixel.x), remaining_);
        exact_ = remaining_.decided();
        if (exact_) {
            const std::uint32_t only =
                remaining_.cover ? truth_.matte_of_face_[*remaining_.cover] : Share::kBackground;
            MatteSums::Sum& sum = sums_.of(only);
            sum.value = 1;
            sum.exact = 1;
        } else {
            ask_oracle(pixel, remaining_.faces);
        }
        const std::size_t first_share = result_.shares.size();
        if (!append_shares()) {
            ++result_.summary.unsettled;
            ask_rationals(pixel, remaining_.faces);
            append_shares();
        }
        if (crosscheck::draw_of(truth_.seed_, pixel) % truth_.rational_one_in_ == 0)
            check_by_rationals(pixel, first_share);
    }

    void ask_oracle(PixelIndex pixel, std::span<const std::uint32_t> faces) {
        views_of(faces);
        const oracle::CertifiedAreas certified = certified_(pixel, views_, Nearness::ByDepth);
        ++result_.summary.rungs.quad;
        if (!certified.certified) return ask_rationals(pixel, faces);
        ++result_.summary.rungs.certified;
        const auto add = [&](std::uint32_t matte, const oracle::CertifiedArea& area) {
            MatteSums::Sum& sum = sums_.of(matte);
            ++sum.faces;
            sum.value += area.value;
            sum.error += area.error;
        };
        for (std::size_t i = 0; i < faces.size(); ++i)
            if (certified.areas[i].value != 0 || certified.areas[i].error != 0)
                add(truth_.matte_of_face_[faces[i]], certified.areas[i]);
        if (certified.background.value != 0 || certified.background.error != 0)
            add(Share::kBackground, certified.background);
    }

    void ask_rationals(PixelIndex pixel, std::span<const std::uint32_t> faces) {
        views_of(faces);
        sums_.sums.clear();
        exact_ = true;
        ++result_.summary.rungs.rational;
        const oracle::ExactAreas areas =
            oracle::areas_by_rational_splitting(pixel, views_, Nearness::ByDepth);
        for (std::size_t i = 0; i < faces.size(); ++i)
            if (areas.areas[i] != 0) add_rational(truth_.matte_of_face_[faces[i]], areas.areas[i]);
        if (areas.background != 0) add_rational(Share::kBackground, areas.background);
    }

    void add_rational(std::uint32_t matte, const mpq_class& area) {
        MatteSums::Sum& sum = sums_.of(matte);
        ++sum.faces;
        sum.exact += area;
        sum.value = sum.exact.get_d();
    }

    /// Asks about all faces, those that are certainly hidden as well, by rational splitting: what has been
    /// appended for this pixel must come out again.
    void check_by_rationals(PixelIndex pixel, std::size_t first_share) {
        const std::vector<Share> before(result_.shares.begin() + static_cast<std::ptrdiff_t>(first_share),
                                        result_.shares.end());
        const MatteSums sums = sums_;
        const bool exact = exact_;
        result_.shares.resize(first_share);
        ask_rationals(pixel, row_.at(pixel.x));
        append_shares();
        KEIKAN_CHECK(
            std::ranges::equal(before, std::span(result_.shares).subspan(first_share)),
            "pixel " << pixel.x << "," << pixel.y << ": two rungs of the oracle give different coverages");
        sums_ = sums;
        exact_ = exact;
    }

    void views_of(std::span<const std::uint32_t> faces) {
        views_.clear();
        for (const std::uint32_t face : faces) views_.push_back(truth_.faces_[face]);
    }

    /// False, and nothing appended, if the ranges leave a rounding open.
    bool append_shares() {
        for (MatteSums::Sum& sum : sums_.sums) {
            if (exact_) {
                sum.coverage = nearest_float(sum.exact);
                sum.code = nearest_code(sum.exact);
                continue;
            }
            const std::optional<float> coverage = nearest_float(sum.range());
            const std::optional<std::uint16_t> code = nearest_code(sum.range());
            if (!coverage || !code) return false;
            sum.coverage = *coverage;
            sum.code = *code;
        }
        for (const MatteSums::Sum& sum : sums_.sums)
            if (sum.coverage > 0) result_.shares.push_back({sum.matte, sum.coverage, sum.code});
        return true;
    }

    /// What the scan says of the pixel, matte by matte, against what has just been appended.
    void compare(PixelIndex pixel) {
        const crosscheck::ClaimedRow::Pixel& claimed = claimed_.pixels[static_cast<std::size_t>(pixel.x)];
        if (claimed.source == crosscheck::ClaimedRow::Source::Missing) return;
        read_claims(claimed);
        // Both sides have all mattes; one that is not seen in truth has the coverage 0.
        for (const auto& [matte, area] : claims_) sums_.of(matte);
        TruthSummary& summary = result_.summary;
        TruthSummary::Place worst{pixel, 0}, differing{pixel, 0};
        bool differs = false;
        for (const MatteSums::Sum& sum : sums_.sums) {
            const double area = claimed_area(sum.matte);
            const double error = error_of(area, sum);
            worst.error = std::max(worst.error, error);
            const bool other_code = nearest_code(area) != sum.code;
            const bool at_boundary = near_code_boundary(sum.range(), bound_of(sum));
            ++summary.values;
            summary.differing_codes += other_code;
            summary.at_boundary += at_boundary;
            summary.differing_at_boundary += at_boundary && other_code;
            if (other_code) differs = true, differing.error = std::max(differing.error, error);
        }
        summary.max_error = std::max(summary.max_error, worst.error);
        keep_worst(summary.worst, worst);
        if (differs && summary.differing.size() < TruthSummary::kWorstKept)
            summary.differing.push_back(differing);
    }

    void read_claims(const crosscheck::ClaimedRow::Pixel& claimed) {
        claims_.clear();
        double total = 0;
        const auto add = [&](std::uint32_t matte, double area) {
            const auto at = std::ranges::lower_bound(claims_, matte, {}, &Claim::matte);
            if (at != claims_.end() && at->matte == matte)
                at->area += area;
            else
                claims_.insert(at, {matte, area});
            total += area;
        };
        for (const auto& part : claimed_.parts_of(claimed)) add(truth_.matte_of_face_[part.face], part.area);
        if (claimed.background != 0) add(Share::kBackground, claimed.background);
        result_.summary.max_sum_error = std::max(result_.summary.max_sum_error, std::abs(total - 1));
    }

    double claimed_area(std::uint32_t matte) const {
        const auto at = std::ranges::lower_bound(claims_, matte, {}, &Claim::matte);
        return at != claims_.end() && at->matte == matte ? at->area : 0;
    }

    /// An upper bound of |area - exact coverage|.
    double error_of(double area, const MatteSums::Sum& sum) const {
        if (exact_ && mpq_class(area) == sum.exact) return 0;
        const Range range = sum.range();
        return std::max(range.high - area, area - range.low);
    }

    /// How far the float path may be from the exact coverage, by its contract for single faces.
    double bound_of(const MatteSums::Sum& sum) const {
        return crosscheck::area_bound(remaining_.faces.size()) * std::max(1u, sum.faces);
    }

    struct Claim {
        std::uint32_t matte = 0;
        double area = 0;
    };

    const SceneTruth& truth_;
    int y_;
    crosscheck::ClaimedRow claimed_;
    crosscheck::FaceBins::Row row_;
    oracle::CertifiedSplitting certified_;
    crosscheck::CertainHiding::Remaining remaining_;
    std::vector<FaceView> views_;
    MatteSums sums_;
    bool exact_ = false;         ///< `sums_` holds exact numbers
    std::vector<Claim> claims_;  ///< of the pixel, by rising matte
    RowResult result_;
};

SceneTruth::SceneTruth(const ProjectedFaces& faces, const Geometry& geometry, ImageSize size,
                       std::uint64_t seed, std::uint64_t rational_one_in)
    : faces_(faces), seed_(seed), rational_one_in_(rational_one_in), bins_(faces, size), hiding_(faces) {
    picture_.size = size;
    std::map<std::string, std::uint32_t> known;
    std::vector<std::uint32_t> matte_of_object;
    for (const Object& object : geometry.objects) {
        const auto [at, is_new] =
            known.emplace(object.name, static_cast<std::uint32_t>(picture_.mattes.size()));
        if (is_new) picture_.mattes.push_back(object.name);
        matte_of_object.push_back(at->second);
    }
    for (const FaceId id : faces.id) {
        const auto next = std::ranges::upper_bound(geometry.first_face, id);
        matte_of_face_.push_back(
            matte_of_object[static_cast<std::size_t>(next - geometry.first_face.begin() - 1)]);
    }
}

void SceneTruth::take(const ScanBand& band) {
    KEIKAN_CHECK(
        band.first_row == next_row_ && band.rows > 0 && band.first_row + band.rows <= picture_.size.height,
        "a band of the rows " << band.first_row << " + " << band.rows << " came where " << next_row_
                              << " was next");
    const auto rows = static_cast<std::size_t>(band.rows);
    std::vector<RowResult> results(rows);
    parallel_for(rows, [&](std::size_t i) {
        results[i] = RowTruth(*this, band, band.first_row + static_cast<int>(i), picture_.size.width).run();
    });
    for (const RowResult& row : results) {
        for (std::size_t x = 0; x + 1 < row.begin.size(); ++x)
            picture_.add_pixel(std::span(row.shares).subspan(row.begin[x], row.begin[x + 1] - row.begin[x]));
        summary_ += row.summary;
    }
    next_row_ += band.rows;
}

const CoveragePicture& SceneTruth::picture() const {
    KEIKAN_CHECK(next_row_ == picture_.size.height, "row " << next_row_ << " never came");
    return picture_;
}

}  // namespace keikan::truth

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare_pixel.hpp"

namespace keikan::crosscheck {

/// A pixel and how wrong it is.
struct WorstPixel {
    PixelIndex pixel;
    std::string case_id;
    double error = 0;
    friend bool operator==(const WorstPixel&, const WorstPixel&) = default;
};

/// How wrong pixels are that are not divided exactly (Extraction::Paper); an observation, not part of the
/// verdict.
struct UnflaggedErrors {
    std::uint64_t pixels = 0;
    std::uint64_t visibly_wrong = 0;  ///< off by more than 1/512, half a step of an 8-bit picture
    double sum_of_squares = 0;        ///< of each pixel's largest error
    double max_error = 0;
    double rmse() const;
    void add(double error);
    UnflaggedErrors& operator+=(const UnflaggedErrors& other);
};

/// What was found of the faces that the projection leaves out because they cannot be seen.
struct LeftOutCount {
    std::uint64_t faces = 0;   ///< left out
    std::uint64_t pixels = 0;  ///< asked about, of those that such a face may be in
    double largest = 0;        ///< seen of such faces in a pixel, together
};

/// What a check found, over any number of pixels. Parts are added up in a fixed order (rows from the top,
/// cases as they come), so the summary does not depend on the number of threads.
struct CheckSummary {
    static constexpr std::size_t kWorstKept = 10;
    static constexpr std::size_t kDisagreementsKept = 1000;

    std::uint64_t pixels = 0;
    std::uint64_t polygons = 0;  ///< faces asked about, summed over the pixels
    double max_area_error = 0;
    double max_area_error_to_8_faces = 0;  ///< over the pixels that kVisibleAreaError applies to
    double max_sum_error = 0;
    RungCounts rungs;
    ContactCounts contacts;
    std::vector<WorstPixel> worst;  ///< by falling error, then as they came
    std::uint64_t disagreement_count = 0;
    std::vector<Disagreement> disagreements;  ///< the first ones
    std::optional<LeftOutCount> left_out;     ///< of a scene
    double seconds = 0;

    bool pass() const { return disagreement_count == 0; }

    /// Adds one pixel that `faces` faces may be in (those that were certainly hidden, and so not asked about,
    /// count).
    void add(const PixelVerdict& verdict, PixelIndex pixel, const std::string& case_id, std::size_t faces);
    void add(const Disagreement& disagreement);
    /// Adds a part that comes after everything added so far. `seconds` is left as it is.
    CheckSummary& operator+=(const CheckSummary& later);
};

/// The summary as one JSON object on one line (docs/verification.md). `unflagged` where there are such
/// pixels.
std::string summary_json(const CheckSummary& summary, const UnflaggedErrors* unflagged = nullptr);

}  // namespace keikan::crosscheck

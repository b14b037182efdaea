// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "oracle/exact_areas.hpp"
#include "peers/contestant.hpp"

namespace keikan::peers {

/// The true areas of a pixel, each within its stated error (some 6e-17).
struct Truth {
    std::vector<oracle::CertifiedArea> areas;
    oracle::CertifiedArea background;
    bool by_certificate = false;  ///< by the certified rung; else by rational splitting
};

/// Asks the oracle: the certified rung, and rational splitting where that gives no certificate. One object a
/// thread.
class TruthTeller {
  public:
    Truth operator()(const PixelCase& pixel_case);

  private:
    oracle::CertifiedSplitting certify_;
};

/// The largest |answered - true| of areas and background is at most this.
double error_of(const Answer& answer, const Truth& truth);

/// A pixel's error is that of its worst area, the background being one.
inline constexpr std::array<double, 4> kWrongBy = {1e-12, 1e-9, 1e-6, 1e-3};
inline constexpr std::array<const char*, 4> kWrongByNames = {"1e-12", "1e-9", "1e-6", "1e-3"};

/// How a contestant has fared with some pixels. An answered pixel counts in every column whose threshold its
/// error exceeds; one without an answer in exceptions, crashes or hangs, and in no other.
struct Tally {
    std::uint64_t pixels = 0;  ///< asked
    std::uint64_t exceptions = 0;
    std::uint64_t crashes = 0;
    std::uint64_t hangs = 0;
    std::array<std::uint64_t, 4> wrong{};  ///< parallel to kWrongBy
    double largest_error = 0;

    void add(const Reply& reply, double error);
    std::uint64_t failures() const { return exceptions + crashes + hangs; }
    friend bool operator==(const Tally&, const Tally&) = default;
};

/// One line of the table.
struct Standing {
    std::string name;
    std::string version;
    Tally all;
    std::map<std::string, Tally> by_family;  ///< by what stands before the first '/' of a case's id
    bool knows_depth = true;
    bool promises = false;  ///< Contestant::promised_error is there
    std::uint64_t not_asked = 0;
    std::uint64_t broken_promises = 0;  ///< pixels failed or beyond the contestant's own bound
    std::string worst;                  ///< id of the case with the largest error
    double largest_sum_error = 0;       ///< of |areas + background - 1|
    double seconds = 0;
    std::uint64_t timed_pixels = 0;

    /// 0 if nothing could be timed.
    double pixels_per_second() const { return seconds > 0 ? static_cast<double>(timed_pixels) / seconds : 0; }
};

/// The family that a case's id names: "grid8" of "grid8/1/17"; the empty one of an id without '/'.
std::string family_named_in(const std::string& id);

/// Adds what a contestant said about a batch.
void add_round(Standing& standing, const Contestant& contestant, const Batch& batch,
               const std::vector<Truth>& truths, const Round& round);

}  // namespace keikan::peers

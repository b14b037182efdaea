// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "keikan/model/point.hpp"

namespace keikan {

/// How samples are spread over the unit square. All are unbiased: each point alone is uniform, up to the
/// stratum it stands for, and the mean over the points has the integral as its expectation.
enum class Sampler {
    Random,  ///< independent points
    Paper,   ///< 4.3 to the letter: a point in the *pixel* and its mirror image in the cell it fell into, N/2
             ///< times
    Haber,   ///< what Haber's theorem asks for: a point and its mirror image in *every* cell
    Jittered,  ///< a point in every cell
    Sobol,     ///< the first N points of Sobol's sequence, Owen-scrambled
};

/// How points that were drawn for the water's slopes are paired with places in the pixel.
enum class SlopeOrder {
    AsGiven,  ///< slope i with place i
    /// The slopes, in their order, with the places in the order of the elevations that the waves there mirror
    /// the view to. Where the slopes' first coordinates are well spread over every run of them (Sobol's
    /// points, in their order), waves and slopes together are as well spread as two dimensions of one net:
    /// what is seen depends on their sum. Each place still has a uniform slope, so that the mean's
    /// expectation is the same (array-RQMC: L'Ecuyer, Lecot, Tuffin 2008).
    ByRank,
};

/// Where slopes are drawn for places in order, so many following ones may share a place: following the view
/// to the waves costs more than a slope, and with SlopeOrder::ByRank the mean errs as little (docs/water.md).
inline constexpr std::uint32_t kSlopesOfAPlace = 2;

/// Names on the command line: random, paper, haber, jittered, sobol.
/// Errors: InputError (reason only).
Sampler sampler_of(const std::string& name);

/// Divisions of the pixel in x and y. Equation (2): floor(sqrt(N / 2)), and at least 1.
/// Departure D11: the bound below, for N < 2.
int paper_divisions(std::size_t count);

/// Replaces `points` by about `count` sample points of the unit square, keyed by `key` alone:
///   Random, Sobol   count
///   Paper           2 floor(count / 2), cells from paper_divisions(count)
///   Haber           2 D^2, D = paper_divisions(count)
///   Jittered        D^2,   D = floor(sqrt(count))
/// and at least 1 (Paper, Haber: 2).
///
/// Properties:
///   (1) The mean of f over the points has the expectation "integral of f", for every f.
///   (2) Variance of that mean, N points: Random var(f) / N. On f = x: Jittered 1 / (12 N^2), Haber 0,
///       Paper (1 - 1/D^2) / (6 N), which is up to twice Random's.
///   (3) Sobol: of the first 2^m points, each elementary interval of area 2^-m holds exactly one.
///   (4) Sobol: the points for a smaller count are the first of those for a larger one.
/// Paper:    section 4.3, Eq. (2), Fig. 8. Departure D12: Haber, Jittered and Sobol stand beside it.
void sample_points(Sampler sampler, std::size_t count, std::uint64_t key, std::vector<Point>& points);

/// Point i of the sequence that Sampler::Sobol takes its points from.
/// Scrambling: by hashes in the manner of Laine and Karras 2011, with the constants of Vegdahl (Burley 2020).
Point scrambled_sobol(std::uint32_t i, std::uint64_t key);

/// The same points in another order, which leaves each block of 2^m points together: pairing point i of
/// `key` with shuffled point i of another key fills four dimensions without correlation (Burley 2020,
/// padding).
Point shuffled_sobol(std::uint32_t i, std::uint64_t key);

}  // namespace keikan

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gmpxx.h>

#include <span>
#include <vector>

#include "rational_lines.hpp"

namespace keikan::oracle {

/// A side of a region: the region is to the left of the way from `from` to `to` (y upwards).
struct OutlineSide {
    const RationalCorner* from;
    const RationalCorner* to;
};

/// The area inside of all `sides` together, in square pixels and in lowest terms: half the sum of the cross
/// products of their ends. Sides that join end to end share a denominator, and the result is reduced by one
/// corner's denominator after the other, so that no greatest common divisor is ever asked of two long
/// numbers.
class EnclosedArea {
  public:
    mpq_class operator()(std::span<const OutlineSide> sides, int unit_bits);

  private:
    void add_chain_from(std::size_t first);
    mpq_class reduced(int unit_bits);

    std::span<const OutlineSide> sides_;
    std::vector<bool> added_;
    std::vector<const mpz_class*> factors_;  ///< of the denominator, but for those that are 1
    mpz_class over_, under_;                 ///< the sum so far
    mpz_class chain_, before_, cross_, common_, rest_;
};

/// Whether the fractions add up to 1, exactly.
bool add_up_to_one(std::span<const mpq_class> fractions);

}  // namespace keikan::oracle

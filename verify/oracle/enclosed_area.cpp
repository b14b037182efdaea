// SPDX-License-Identifier: GPL-3.0-or-later
#include "enclosed_area.hpp"

#include <algorithm>

namespace keikan::oracle {
namespace {

bool is_one(const mpz_class& value) {
    return mpz_cmp_ui(value.get_mpz_t(), 1) == 0;
}

void multiply(mpz_class& value, const mpz_class& factor) {
    if (!is_one(factor)) mpz_mul(value.get_mpz_t(), value.get_mpz_t(), factor.get_mpz_t());
}

struct Fraction {
    mpz_class over, under;
};

/// Not reduced; by halves, so that the numbers multiplied are of like length.
Fraction sum(std::span<const mpq_class> terms) {
    if (terms.empty()) return {0, 1};
    if (terms.size() == 1) return {terms[0].get_num(), terms[0].get_den()};
    Fraction first = sum(terms.first(terms.size() / 2)), second = sum(terms.subspan(terms.size() / 2));
    if (first.under == second.under) return {first.over + second.over, first.under};
    return {first.over * second.under + second.over * first.under, first.under * second.under};
}

}  // namespace

bool add_up_to_one(std::span<const mpq_class> fractions) {
    const Fraction total = sum(fractions);
    return total.over == total.under;
}

mpq_class EnclosedArea::operator()(std::span<const OutlineSide> sides, int unit_bits) {
    sides_ = sides;
    added_.assign(sides.size(), false);
    factors_.clear();
    over_ = 0;
    under_ = 1;
    // From corners whose denominator is 1 first: a chain that is closed there needs no division.
    for (const bool any : {false, true})
        for (std::size_t i = 0; i < sides.size(); ++i)
            if (!added_[i] && (any || is_one(sides[i].from->w))) add_chain_from(i);
    return reduced(unit_bits);
}

/// Follows sides from end to end. With p x q the cross product of two corners' numerators, the chain's sum is
/// chain_ / (before_ w), w the denominator of its last corner and before_ the product of all others.
void EnclosedArea::add_chain_from(std::size_t first) {
    const RationalCorner* const start = sides_[first].from;
    const RationalCorner* end = start;
    chain_ = 0;
    before_ = 1;
    bool closed = false;
    for (std::size_t next = first; next < sides_.size() && !closed;) {
        const auto [from, to] = sides_[next];
        added_[next] = true;
        mpz_mul(cross_.get_mpz_t(), from->x.get_mpz_t(), to->y.get_mpz_t());
        mpz_submul(cross_.get_mpz_t(), from->y.get_mpz_t(), to->x.get_mpz_t());
        closed = to == start;
        multiply(cross_, before_);
        multiply(chain_, to->w);
        chain_ += cross_;
        multiply(before_, from->w);
        if (!is_one(from->w)) factors_.push_back(&from->w);
        end = to;
        for (next = 0; next < sides_.size(); ++next)
            if (!added_[next] && sides_[next].from == end) break;
    }
    if (!closed) {
        multiply(before_, end->w);
        if (!is_one(end->w)) factors_.push_back(&end->w);
    } else if (!is_one(start->w)) {  // it has been counted twice
        mpz_divexact(chain_.get_mpz_t(), chain_.get_mpz_t(), start->w.get_mpz_t());
    }
    multiply(over_, before_);
    multiply(chain_, under_);
    over_ += chain_;
    multiply(under_, before_);
}

/// over_ / under_ in units of 2^-(2 unit_bits), and halved.
mpq_class EnclosedArea::reduced(int unit_bits) {
    mpq_class result;
    if (over_ == 0) return result;
    mpz_class& under = result.get_den();
    // After a factor has lost what it has in common with over_, the two have nothing in common any more.
    for (const mpz_class* factor : factors_) {
        mpz_gcd(common_.get_mpz_t(), over_.get_mpz_t(), factor->get_mpz_t());
        if (is_one(common_)) {
            multiply(under, *factor);
            continue;
        }
        mpz_divexact(over_.get_mpz_t(), over_.get_mpz_t(), common_.get_mpz_t());
        mpz_divexact(rest_.get_mpz_t(), factor->get_mpz_t(), common_.get_mpz_t());
        multiply(under, rest_);
    }
    const auto bits = static_cast<mp_bitcnt_t>(2 * unit_bits + 1);
    const mp_bitcnt_t common_bits = std::min(bits, mpz_scan1(over_.get_mpz_t(), 0));
    mpz_fdiv_q_2exp(result.get_num_mpz_t(), over_.get_mpz_t(), common_bits);
    under <<= bits - common_bits;
    return result;
}

}  // namespace keikan::oracle

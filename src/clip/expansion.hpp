// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>

#include "double_double.hpp"

namespace keikan::clip {

/// An exact sum of doubles, as components that do not overlap, by rising magnitude (Shewchuk 1997). Adding
/// keeps it exact and drops zeros; at most Capacity numbers may be added.
template <std::size_t Capacity>
class Expansion {
  public:
    /// Adds b, exactly (Shewchuk's GROW-EXPANSION).
    void add(double b) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const DoubleDouble sum = two_sum(b, component_[i]);
            b = sum.hi;
            if (sum.lo != 0) component_[kept++] = sum.lo;
        }
        if (b != 0) component_[kept++] = b;
        size_ = kept;
    }
    void add(DoubleDouble x) {
        add(x.lo);
        add(x.hi);
    }

    /// The sign is that of the largest component.
    double largest() const { return size_ == 0 ? 0 : component_[size_ - 1]; }

    /// The sum, with a relative error of at most 2^-104; hi is the sum rounded to nearest.
    DoubleDouble rounded() const {
        // From the large end: each step leaves in `lo` what `hi` cannot hold, until lo is full too.
        DoubleDouble head{largest(), 0};
        double tail = 0;
        for (std::size_t i = size_; i-- > 1;) {
            const DoubleDouble sum = two_sum(head.lo, component_[i - 1]);
            head = quick_two_sum(head.hi, sum.hi);
            tail += sum.lo;
        }
        return quick_two_sum(head.hi, head.lo + tail);
    }

  private:
    std::array<double, Capacity> component_{};
    std::size_t size_ = 0;
};

}  // namespace keikan::clip

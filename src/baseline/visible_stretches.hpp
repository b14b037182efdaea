// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace keikan::baseline {

/// Where a line crosses a face: from `begin` to `end` along the line, with nearness w = slope t + start.
struct Crossed {
    double begin = 0;
    double end = 0;
    double slope = 0;
    double start = 0;
    std::uint32_t face = 0;  ///< of two that are equally near all along, the smaller is seen
};

/// A part of a line on which one face is seen.
struct Stretch {
    double begin = 0;
    double end = 0;
    std::uint32_t face = 0;
};

/// Finds what is seen along a line [0, length], from one end to the other: the nearest face is kept, with the
/// place where another one overtakes it, so that a face behind it costs one comparison. One object a thread.
///
/// Properties:
///   (1) Stretches are disjoint and come by rising t; of two neighbours the faces differ, or a gap lies
///       between. Where there is none, no face is crossed.
///   (2) Faces may pass through each other: they change places where their planes meet.
/// Requires: `crossed` by rising begin.
/// Cost:     linear in the faces, and in those crossed at once for each change of what is seen.
class VisibleStretches {
  public:
    std::span<const Stretch> operator()(std::span<const Crossed> crossed, double length);

  private:
    double w(std::size_t i, double t) const { return crossed_[i].slope * t + crossed_[i].start; }
    bool nearer(std::size_t i, std::size_t j, double t) const;
    void see(std::size_t i, double t);
    void look_for_overtaker(double t);
    void see_best(double t);
    void emit(double from, double to);

    static constexpr std::size_t kNone = ~std::size_t{0};
    std::span<const Crossed> crossed_;
    std::vector<std::size_t> live_;  ///< begun; ended ones are thrown out when it is walked
    std::size_t seen_ = kNone;
    std::size_t overtaker_ = kNone;
    double overtaken_at_ = 0;
    std::vector<Stretch> stretches_;
};

}  // namespace keikan::baseline

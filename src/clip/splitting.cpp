// SPDX-License-Identifier: Apache-2.0
#include "splitting.hpp"

#include <algorithm>

namespace keikan::clip {
namespace {

constexpr Point kPixelRing[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

}  // namespace

double Splitting::measure(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness,
                          Entrants& entrants, std::vector<Measure>& measures) {
    find_lone_faces(entrants);
    const auto alone = [](const Entrant& e) { return e.alone; };
    const bool all_alone = std::all_of(entrants.faces.begin(), entrants.faces.end(), alone);
    if (!all_alone) {
        if (nearness == Nearness::ByDepth) {
            measure_depths(pixel, faces, entrants);
            put_in_order_of_depth(entrants);
        } else {
            put_in_order_of_list(entrants);
        }
    }
    const auto first = std::find_if(entrants.faces.begin(), entrants.faces.end(), alone);
    first_alone_ = static_cast<std::size_t>(first - entrants.faces.begin());

    partition_.begin(pixel, entrants);
    for (std::uint32_t who = 0; who < first_alone_; ++who) {
        const Entrant& face = entrants.faces[who];  // in ByDepth, those after it are no nearer
        if (partition_.hides_all_below(face.w_max + face.w_error, nearness)) break;
        partition_.insert(who, nearness);
    }

    measures.assign(entrants.faces.size(), {});
    Measure free;
    const std::uint32_t first_label = partition_.label(0);
    bool single = true;
    for (std::size_t i = 0; i < partition_.size(); ++i) {
        const std::uint32_t label = partition_.label(i);
        (label == Partition::kFree ? free : measures[label]).add(partition_.ring(i));
        single = single && label == first_label;
    }
    if (single && first_label != Partition::kFree) {  // all cells together are the pixel, without rounding
        measures[first_label] = {};
        measures[first_label].add(kPixelRing);
    }
    if (first_alone_ == entrants.faces.size()) return std::clamp(free.area.value(), 0.0, 1.0);

    for (std::size_t i = first_alone_; i < entrants.faces.size(); ++i) {
        measures[i].add(entrants.ring(entrants.faces[i]));
        free.area.add(-measures[i].area.value());
    }
    // Faces that fill the rest leave at most what the rounding of their corners and areas makes: about one
    // rounding for each. Less than that is nothing.
    const double nothing = kHalfUlp * static_cast<double>(2 + entrants.faces.size() - first_alone_);
    const double background = free.area.value();
    return background > nothing ? std::min(background, 1.0) : 0;
}

std::span<const VisiblePiece> Splitting::pieces(const Entrants& entrants) {
    for (; first_alone_ < entrants.faces.size(); ++first_alone_)
        partition_.insert(static_cast<std::uint32_t>(first_alone_), Nearness::InOrder);
    pieces_.clear();
    for (std::size_t i = 0; i < partition_.size(); ++i) {
        const std::uint32_t label = partition_.label(i);
        const std::uint32_t face =
            label == Partition::kFree ? VisiblePiece::kBackground : entrants.faces[label].position;
        pieces_.push_back({face, partition_.ring(i)});
    }
    return pieces_;
}

}  // namespace keikan::clip

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>

#include "peers/peer.hpp"

namespace keikan::peers {

/// What the areas leave of the pixel.
inline void set_background(Answer& answer) {
    double covered = 0;
    for (const double area : answer.areas) covered += area;
    answer.background = 1 - covered;
}

/// The way to visible areas that needs a binary difference alone: from each face, those before it in the list
/// are taken away one by one, until nothing is left of it. `Library` offers, for a region type of its own:
/// region(ring), is_empty(region), difference(region, region), area(region). A face is converted once.
template <typename Library>
void ask_by_repeated_differences(Library& library, const PreparedPixel& pixel, Answer& answer) {
    answer.areas.assign(pixel.in_pixel.size(), 0.0);
    std::vector<typename Library::Region> nearer;
    nearer.reserve(pixel.in_pixel.size());
    for (std::size_t i = 0; i < pixel.in_pixel.size(); ++i) {
        if (pixel.in_pixel[i].empty()) continue;
        typename Library::Region seen = library.region(pixel.in_pixel[i]);
        nearer.push_back(seen);
        for (std::size_t j = 0; j + 1 < nearer.size() && !library.is_empty(seen); ++j)
            seen = library.difference(seen, nearer[j]);
        answer.areas[i] = library.area(seen);
    }
    set_background(answer);
}

}  // namespace keikan::peers

// SPDX-License-Identifier: GPL-3.0-or-later
#include "planted.hpp"

#include <string>

namespace keikan::peers::test {

std::vector<PixelCase> half_covered_pixels(int count) {
    std::vector<PixelCase> cases;
    for (int i = 0; i < count; ++i) {
        PixelCase half;
        half.id = "half/1/" + std::to_string(i);
        half.pixel = {i, 0};
        const double x = i;
        half.polygons = {{{x, 0}, {x + 0.5, 0}, {x + 0.5, 1}, {x, 1}}};
        cases.push_back(half);
    }
    return cases;
}

Peer planted_peer(const std::function<void(int i, Answer& answer)>& misbehave) {
    return {.name = "planted", .version = "planted 1.0", .start = [misbehave]() -> Ask {
                return [misbehave](const PreparedPixel& pixel, Answer& answer) {
                    answer.areas.assign(pixel.faces.size(), 0.5);
                    answer.background = 0.5;
                    misbehave(pixel.pixel.x, answer);
                };
            }};
}

}  // namespace keikan::peers::test

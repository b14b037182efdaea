// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "keikan/clip/visible_areas.hpp"
#include "peers/peer.hpp"

namespace keikan::peers {
namespace {

Peer engine(const char* name, Engine engine) {
    return {.name = name,
            .version = std::string("keikan, engine ") + name,
            .by_depth = true,
            .start = [engine]() -> Ask {
                return [areas = std::make_shared<VisibleAreas>(engine)](const PreparedPixel& pixel,
                                                                        Answer& answer) {
                    answer.areas.assign(pixel.faces.size(), 0.0);
                    const PixelCoverage seen = (*areas)(pixel.pixel, pixel.faces, pixel.nearness);
                    for (const VisiblePart& part : seen.parts) answer.areas[part.face] = part.area;
                    answer.background = seen.background;
                };
            }};
}

}  // namespace

Peer splitting() {
    return engine("splitting", Engine::Splitting);
}
Peer traversal() {
    return engine("traversal", Engine::Traversal);
}
Peer published() {
    return engine("published", Engine::Published);
}

}  // namespace keikan::peers

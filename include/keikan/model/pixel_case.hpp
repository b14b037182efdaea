// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"

namespace keikan {

/// A question about one pixel that can be stored, sent and asked again: the unit of exchange between
/// `keikan pixel`, `keikan areas` and every command of keikan-verify.
struct PixelCase {
    std::string id;
    PixelIndex pixel;
    std::vector<Ring> polygons;                     ///< nearest first, unless `depth` is given
    std::optional<std::vector<DepthPlane>> depth;   ///< one for each polygon
    std::optional<std::vector<std::string>> areas;  ///< the exact answers "p/q", where known
    std::optional<std::string> background;

    Nearness nearness() const { return depth ? Nearness::ByDepth : Nearness::InOrder; }

    /// The polygons as faces; a face's id is its position. Views into this case.
    std::vector<FaceView> faces() const {
        std::vector<FaceView> views(polygons.size());
        for (std::size_t i = 0; i < polygons.size(); ++i)
            views[i] = {static_cast<FaceId>(i), polygons[i], depth ? (*depth)[i] : DepthPlane{}};
        return views;
    }
};

}  // namespace keikan

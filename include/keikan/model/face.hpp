// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "keikan/model/point.hpp"

namespace keikan {

/// Nearness over the image: w(x, y) = a x + b y + c, in image coordinates. The larger w is nearer.
/// Under a perspective camera w is 1/z, which is affine on the screen; under an orthographic one it is -z.
struct DepthPlane {
    double a = 0;
    double b = 0;
    double c = 0;
    friend bool operator==(const DepthPlane&, const DepthPlane&) = default;
};

/// Names a face through all stages, from the scene's geometry to the verdict.
using FaceId = std::uint32_t;

/// A convex polygon as the camera sees it. `outline` is in image coordinates, of either orientation;
/// it may reach far beyond the pixel looked at, repeat points, and have no area (then it shows nothing).
/// The doubles are the question: product and oracle take each of them as exact.
struct FaceView {
    FaceId id = 0;
    std::span<const Point> outline;
    DepthPlane depth;
};

/// Which of two faces is seen where both are.
enum class Nearness {
    InOrder,  ///< the one that stands earlier in the list; depth planes are not looked at
    ByDepth,  ///< the one with the larger w at that point; the smaller id where w is equal everywhere
};

}  // namespace keikan

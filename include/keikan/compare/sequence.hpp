// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "keikan/baseline/method.hpp"

namespace keikan::compare {

struct SequenceOptions {
    std::vector<baseline::Method> methods;
    int frames = 0;
    /// From frame to frame the camera moves this far, four fifths of it to its right and three fifths up [m].
    double step_m = 0.05;
    std::uint32_t seed = 1;
    WaterOptions water;
    std::function<void(const std::string& doing)> tell = {};
};

/// How the conductors' brightness changes from frame to frame, by one method.
struct Flicker {
    baseline::Method method;
    /// For each conductor that any frame shows: the sum over the frames of |change of its integrated
    /// luminance|, in pixels times luminance (keikan/render/object_light.hpp).
    std::vector<double> variation;
    double total = 0;  ///< over the conductors
    /// The sum of all conductors' luminance in each frame.
    std::vector<double> light;
    std::vector<Image<Rgb>> frames;
};

/// Thin lines that flicker give a method away.
struct Sequence {
    std::vector<std::string> conductors;  ///< names
    Flicker truth;                        ///< exact areas: only what the camera's way changes; without frames
    std::vector<Flicker> methods;
};

/// Renders `frames` pictures by each method, the camera moving along a straight line, over the same faces
/// (levels of detail as they are for the first frame).
Sequence render_sequence(const Scene& scene, const Geometry& geometry, const SequenceOptions& options);

}  // namespace keikan::compare

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <ctime>

#include "keikan/compare/comparison.hpp"

namespace keikan::compare {

struct TimedRun {
    RenderedPicture picture;
    Seconds seconds;
};

/// One run of a method, from the faces to the picture.
inline TimedRun timed_run(const baseline::Method& method, const Scene& scene, const Geometry& geometry,
                          const baseline::MethodOptions& options) {
    const std::clock_t spent = std::clock();
    const auto start = std::chrono::steady_clock::now();
    TimedRun run;
    run.picture = render_by(method, scene, geometry, options);
    run.seconds.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    run.seconds.processor = static_cast<double>(std::clock() - spent) / CLOCKS_PER_SEC;
    return run;
}

}  // namespace keikan::compare

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "keikan/compare/sequence.hpp"
#include "keikan/render/object_light.hpp"

namespace keikan::compare {

namespace {

/// Luminance of every object in every frame.
using LightOfFrames = std::vector<std::vector<double>>;

LightOfFrames film(const Scene& scene, const Geometry& geometry, const SequenceOptions& options,
                   const baseline::Method& method, std::vector<Image<Rgb>>* frames) {
    LightOfFrames light;
    Scene moved = scene;
    const glm::dvec3 step = options.step_m * (0.8 * scene.camera.right - 0.6 * scene.camera.down);
    for (int frame = 0; frame < options.frames; ++frame) {
        if (options.tell) options.tell(name_of(method) + ", frame " + std::to_string(frame + 1));
        moved.camera.position = scene.camera.position + static_cast<double>(frame) * step;
        std::vector<double>& of_frame = light.emplace_back(geometry.objects.size(), 0.0);
        baseline::MethodOptions how;
        how.seed = options.seed;
        how.render.water = options.water;
        if (frames == nullptr) how.render.water.mode = WaterMode::Flat;
        how.render.after_band = [&](const ScanBand& band) { add_object_light(band, moved, of_frame); };
        RenderedPicture picture = render_by(method, moved, geometry, how);
        if (frames != nullptr) frames->push_back(std::move(picture.image));
    }
    return light;
}

void find_variation(const LightOfFrames& light, const std::vector<std::size_t>& conductors,
                    Flicker& flicker) {
    for (const std::vector<double>& frame : light) {
        double sum = 0;
        for (const std::size_t o : conductors) sum += frame[o];
        flicker.light.push_back(sum);
    }
    for (const std::size_t o : conductors) {
        double variation = 0;
        for (std::size_t frame = 1; frame < light.size(); ++frame)
            variation += std::abs(light[frame][o] - light[frame - 1][o]);
        flicker.variation.push_back(variation);
        flicker.total += variation;
    }
}

}  // namespace

Sequence render_sequence(const Scene& scene, const Geometry& geometry, const SequenceOptions& options) {
    Sequence sequence;
    sequence.truth.method = baseline::method_of("catmull");
    const LightOfFrames truth = film(scene, geometry, options, sequence.truth.method, nullptr);
    std::vector<std::size_t> conductors;
    for (std::size_t o = 0; o < geometry.objects.size(); ++o) {
        const bool seen = std::any_of(truth.begin(), truth.end(),
                                      [&](const std::vector<double>& frame) { return frame[o] > 0; });
        if (geometry.objects[o].kind != ObjectKind::Conductor || !seen) continue;
        conductors.push_back(o);
        sequence.conductors.push_back(geometry.objects[o].name);
    }
    find_variation(truth, conductors, sequence.truth);
    for (const baseline::Method& method : options.methods) {
        Flicker& flicker = sequence.methods.emplace_back();
        flicker.method = method;
        find_variation(film(scene, geometry, options, method, &flicker.frames), conductors, flicker);
    }
    return sequence;
}

}  // namespace keikan::compare

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "keikan/image/image.hpp"
#include "keikan/render/render_scene.hpp"

namespace keikan::baseline {

/// How a picture is freed of aliasing: the project's method, or one that it is compared with. Each has a
/// header of its own in this folder, with its source and its cost.
struct Method {
    enum class Kind {
        Kato,        ///< keikan/render/render_scene.hpp
        None,        ///< point_sampling
        MultiScan,   ///< multi_scanning
        Orthogonal,  ///< orthogonal_scanlines
        Catmull,     ///< exact_everywhere
        Grid,        ///< supersampling, SamplePattern::Grid
        Random,      ///< supersampling, SamplePattern::Random
    };
    Kind kind = Kind::Kato;
    int count = 1;                         ///< the N of those that have one
    std::optional<Extraction> extraction;  ///< of Kato; not said: that of the RenderOptions
    friend bool operator==(const Method&, const Method&) = default;

    bool has_count() const {
        return kind == Kind::MultiScan || kind == Kind::Orthogonal || kind == Kind::Grid ||
               kind == Kind::Random;
    }
};

/// The largest N of a method.
inline constexpr int kMostSamples = 1 << 20;

/// "kato", "kato:outline", "kato:paper", "none", "multiscan:N", "orthogonal:N", "catmull", "grid:N",
/// "random:N". Errors: InputError (reason only).
Method method_of(const std::string& text);

/// The inverse.
std::string name_of(const Method& method);
/// Without the N.
std::string name_of(Method::Kind kind);

/// What else a comparison may ask for.
struct MethodOptions {
    RenderOptions
        render;  ///< Kato: all of it; others: water (but for its numbers of samples), extra, after_...
    std::uint32_t seed = 1;
    Image<std::uint8_t> only = {};  ///< Grid, Random: SupersamplingOptions::only
};

/// The picture by that method: from the faces to colours in linear light, with the same projection, shading
/// and light on water for all of them.
///
/// Properties:
///   (1) The same for any number of threads.
///   (2) Kato is render_scene.
RenderedPicture render_by(const Method& method, const Scene& scene, const Geometry& geometry,
                          const MethodOptions& options = {});

}  // namespace keikan::baseline

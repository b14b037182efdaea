// SPDX-License-Identifier: Apache-2.0
#include "keikan/baseline/method.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "keikan/baseline/catmull.hpp"
#include "keikan/baseline/faces_in_view.hpp"
#include "keikan/baseline/multi_scanning.hpp"
#include "keikan/baseline/orthogonal_scanlines.hpp"
#include "keikan/baseline/supersampling.hpp"
#include "keikan/render/render_bands.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan::baseline {

namespace {

constexpr std::pair<std::string_view, Method::Kind> kKinds[] = {
    {"kato", Method::Kind::Kato},           {"none", Method::Kind::None},
    {"multiscan", Method::Kind::MultiScan}, {"orthogonal", Method::Kind::Orthogonal},
    {"catmull", Method::Kind::Catmull},     {"grid", Method::Kind::Grid},
    {"random", Method::Kind::Random}};

std::function<BandMaker()> makers(const Method& method, const FacesInView& view,
                                  const MethodOptions& options) {
    switch (method.kind) {
        case Method::Kind::MultiScan:
            return multi_scanning(view, method.count);
        case Method::Kind::Orthogonal:
            return orthogonal_scanlines(view, method.count);
        case Method::Kind::Catmull:
            return exact_everywhere(view);
        case Method::Kind::Grid:
            return supersampling(view, {SamplePattern::Grid, method.count, options.seed, options.only});
        case Method::Kind::Random:
            return supersampling(view, {SamplePattern::Random, method.count, options.seed, options.only});
        case Method::Kind::None:
        case Method::Kind::Kato:
            break;
    }
    return point_sampling(view);
}

}  // namespace

Method method_of(const std::string& text) {
    const std::size_t colon = text.find(':');
    const std::string_view name = std::string_view(text).substr(0, colon);
    const auto refuse = [&](const char* why) -> Method { throw InputError("method '" + text + "': " + why); };
    Method method;
    const auto* const found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                           [&](const auto& kind) { return kind.first == name; });
    if (found == std::end(kKinds))
        return refuse("there are only: kato, none, multiscan:N, orthogonal:N, catmull, grid:N, random:N");
    method.kind = found->second;
    const std::string_view rest =
        colon == std::string::npos ? std::string_view{} : std::string_view(text).substr(colon + 1);
    if (method.has_count()) {
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), method.count);
        if (error != std::errc() || end != rest.data() + rest.size() || method.count < 1 ||
            method.count > kMostSamples)
            return refuse("needs a whole number from 1 to 1048576 behind a colon");
    } else if (method.kind == Method::Kind::Kato && (rest == "outline" || rest == "paper")) {
        method.extraction = rest == "paper" ? Extraction::Paper : Extraction::Outline;
    } else if (colon != std::string::npos) {
        return refuse("takes nothing of this kind behind a colon");
    }
    return method;
}

std::string name_of(Method::Kind kind) {
    const auto* const found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                           [&](const auto& known) { return known.second == kind; });
    return std::string(found->first);
}

std::string name_of(const Method& method) {
    const std::string name = name_of(method.kind);
    if (method.has_count()) return name + ":" + std::to_string(method.count);
    if (method.extraction) return name + (*method.extraction == Extraction::Paper ? ":paper" : ":outline");
    return name;
}

RenderedPicture render_by(const Method& method, const Scene& scene, const Geometry& geometry,
                          const MethodOptions& options) {
    if (method.kind == Method::Kind::Kato) {
        RenderOptions render = options.render;
        if (method.extraction) render.scan.extraction = *method.extraction;
        return render_scene(scene, geometry, render);
    }
    const ProjectedFaces faces = project_faces(geometry, scene.camera);
    const FacesInView view(geometry, faces, scene.camera);
    RenderedPicture picture =
        render_bands(scene, geometry, faces, makers(method, view, options), options.render);
    const ImageSize size = scene.camera.size;
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
    if (method.kind == Method::Kind::None) picture.scan.samples = pixels;
    if (method.kind == Method::Kind::Grid || method.kind == Method::Kind::Random)
        picture.scan.samples = pixels * static_cast<std::uint64_t>(method.count);
    return picture;
}

}  // namespace keikan::baseline

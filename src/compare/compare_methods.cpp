// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "equal_quality.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/parallel.hpp"
#include "timed_run.hpp"

namespace keikan::compare {

namespace {

using Kind = baseline::Method::Kind;

constexpr const char* kGiven = "given";  ///< what the truth is

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

Seconds median_of(const std::vector<Seconds>& runs) {
    std::vector<double> wall, processor;
    for (const Seconds& s : runs) wall.push_back(s.wall), processor.push_back(s.processor);
    return {median(wall), median(processor)};
}

baseline::MethodOptions method_options(const ComparisonOptions& options) {
    baseline::MethodOptions result;
    result.render.water = options.water;
    result.seed = options.seed;
    return result;
}

void find_truth(const Scene& scene, const Geometry& geometry, const ComparisonOptions& options,
                Comparison& comparison) {
    if (options.reference) {
        comparison.truth = *options.reference;
        comparison.truth_is = kGiven;
        return;
    }
    baseline::MethodOptions method = method_options(options);
    method.render.water.mode = WaterMode::Fixed;
    method.render.water.fixed = options.reference_samples;
    method.render.water.fixed_sampler = Sampler::Sobol;
    // Other points than kato's, which would be some of the truth's and share its noise.
    method.render.water.seed = ~options.water.seed;
    const Kind kind = comparison.water ? Kind::Kato : Kind::Catmull;
    comparison.truth = render_by({kind, 1, Extraction::Outline}, scene, geometry, method).image;
    comparison.truth_is = comparison.water
                              ? "exact areas; water by " + std::to_string(options.reference_samples) +
                                    " of Sobol's points a pixel"
                              : "exact areas in every pixel";
}

void run_in_turns(const Scene& scene, const Geometry& geometry, const ComparisonOptions& options,
                  Comparison& comparison) {
    for (const baseline::Method& method : options.methods)
        comparison.methods.push_back({method, {}, {}, {}, {}, 0, {}});
    for (int turn = 0; turn < options.repeat; ++turn)
        for (MethodResult& result : comparison.methods) {
            if (options.tell) options.tell(name_of(result.method));
            TimedRun run = timed_run(result.method, scene, geometry, method_options(options));
            result.runs.push_back(run.seconds);
            KEIKAN_CHECK(turn == 0 || run.picture.image == result.picture,
                         name_of(result.method) << " gives another picture the second time");
            result.water_samples = run.picture.water.samples;
            result.picture = std::move(run.picture.image);
        }
    const Image<std::uint8_t>* const where =
        comparison.has_conductors ? &comparison.conductor_pixels : nullptr;
    for (MethodResult& result : comparison.methods) {
        result.median = median_of(result.runs);
        result.all = picture_error(result.picture, comparison.truth);
        result.conductors = picture_error(result.picture, comparison.truth, where);
    }
}

void search_equal_quality(const Scene& scene, const Geometry& geometry, const ComparisonOptions& options,
                          Comparison& comparison) {
    const auto kato = std::find_if(comparison.methods.begin(), comparison.methods.end(),
                                   [](const MethodResult& r) { return r.method.kind == Kind::Kato; });
    if (kato == comparison.methods.end() || options.search_to < 1) return;
    for (const Kind kind : {Kind::MultiScan, Kind::Orthogonal, Kind::Grid, Kind::Random}) {
        if (std::none_of(options.methods.begin(), options.methods.end(),
                         [&](const baseline::Method& m) { return m.kind == kind; }))
            continue;
        QualitySearch search(kind, scene, geometry, comparison, options);
        for (const Goal goal : {Goal::KatoRmse, Goal::AllRight}) {
            EqualQuality found = search(goal, kato->conductors.rmse);
            const Seconds theirs = found.reached ? found.reached->seconds : found.last.seconds;
            if (theirs.processor > 0) found.time_ratio = kato->median.processor / theirs.processor;
            comparison.equal_quality.push_back(found);
        }
        comparison.trials.push_back({kind, search.trials()});
    }
}

bool promises_exact_areas(const baseline::Method& method) {
    return method.kind == Kind::Catmull ||
           (method.kind == Kind::Kato &&
            method.extraction.value_or(Extraction::Outline) == Extraction::Outline);
}

}  // namespace

void require_exact(const Comparison& comparison) {
    if (comparison.water || comparison.truth_is == kGiven) return;
    for (const MethodResult& result : comparison.methods)
        KEIKAN_CHECK(!promises_exact_areas(result.method) || result.all.off_share == 0,
                     name_of(result.method)
                         << " is off by up to " << result.all.largest << " where it must be exact");
}

Image<std::uint8_t> conductor_pixels(const Geometry& geometry, const Camera& camera) {
    Image<std::uint8_t> mask(camera.size, 0);
    const auto shows = [&](const SeenFace& face) {
        return geometry.objects[face.object].kind == ObjectKind::Conductor;
    };
    scan_faces(project_faces(geometry, camera), geometry, camera, {}, [&](const ScanBand& band) {
        for (int row = 0; row < band.rows; ++row) {
            const auto r = static_cast<std::size_t>(row);
            const int y = band.first_row + row;
            for (std::uint32_t s = band.span_begin[r]; s < band.span_begin[r + 1]; ++s) {
                const Span& span = band.spans[s];
                if (span.face == Span::kBackground || !shows(band.faces[span.face])) continue;
                for (int x = span.x_begin; x < span.x_end; ++x) mask[{x, y}] = 1;
            }
            for (std::uint32_t d = band.divided_begin[r]; d < band.divided_begin[r + 1]; ++d)
                for (std::uint32_t p = band.divided[d].part_begin; p < band.divided[d].part_end; ++p)
                    if (shows(band.faces[band.parts[p].face])) mask[{band.divided[d].x, y}] = 1;
        }
    });
    return mask;
}

Comparison compare_methods(const Scene& scene, const Geometry& geometry, const ComparisonOptions& options) {
    Comparison comparison;
    comparison.size = scene.camera.size;
    comparison.threads = thread_count();
    comparison.faces = geometry.first_face.back();
    comparison.water = std::any_of(scene.water.begin(), scene.water.end(),
                                   [](const auto& surface) { return surface.has_value(); });
    if (options.tell) options.tell("truth");
    find_truth(scene, geometry, options, comparison);
    comparison.conductor_pixels = conductor_pixels(geometry, scene.camera);
    for (const std::uint8_t shown : comparison.conductor_pixels.values())
        comparison.conductor_pixel_count += shown;
    comparison.has_conductors = comparison.conductor_pixel_count > 0;
    run_in_turns(scene, geometry, options, comparison);
    search_equal_quality(scene, geometry, options, comparison);
    return comparison;
}

}  // namespace keikan::compare

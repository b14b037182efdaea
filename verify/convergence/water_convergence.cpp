// SPDX-License-Identifier: GPL-3.0-or-later
#include "water_convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "keikan/image/srgb.hpp"

namespace keikan::convergence {

namespace {

/// Seed of the references: not that of what they judge.
constexpr std::uint32_t kReferenceSeed = 0x7ef5eed;

RenderedPicture drawn(const Scene& scene, const Geometry& geometry, const WaterOptions& water) {
    RenderOptions options;
    options.water = water;
    options.extra = true;
    return render_scene(scene, geometry, options);
}

double code_of(float linear) {
    return 255 * srgb_from_linear(std::clamp(static_cast<double>(linear), 0.0, 1.0));
}

WaterOptions fixed(Sampler sampler, int count, const WaterCheckOptions& options) {
    WaterOptions water;
    water.mode = WaterMode::Fixed;
    water.fixed_sampler = sampler;
    water.fixed = count;
    water.window = options.window;
    water.seed = options.seed;
    return water;
}

template <typename Visit>
void each_water_pixel(const PixelWindow& window, const Image<float>& samples, const Visit& visit) {
    for (int y = window.y; y < window.y + window.height; ++y)
        for (int x = window.x; x < window.x + window.width; ++x)
            if (samples[PixelIndex{x, y}] > 0) visit(PixelIndex{x, y});
}

WaterResult compared(std::string method, const RenderedPicture& picture, const RenderedPicture& reference,
                     const PixelWindow& window) {
    WaterResult result;
    result.method = std::move(method);
    double squares = 0;
    std::uint64_t values = 0;
    each_water_pixel(window, reference.extra.water_samples, [&](PixelIndex at) {
        const Rgb p = picture.image[at], q = reference.image[at];
        for (const double error :
             {code_of(p.r) - code_of(q.r), code_of(p.g) - code_of(q.g), code_of(p.b) - code_of(q.b)}) {
            squares += error * error;
            result.largest_error = std::max(result.largest_error, std::abs(error));
            ++values;
        }
    });
    const WaterStatistics& s = picture.water;
    result.rmse = values > 0 ? std::sqrt(squares / static_cast<double>(values)) : 0;
    result.samples_per_pixel =
        s.pixels > 0 ? static_cast<double>(s.samples) / static_cast<double>(s.pixels) : 0;
    result.most_samples = s.most_samples;
    result.missed = s.missed;
    result.seconds = s.seconds;
    return result;
}

nlohmann::ordered_json json_of(const WaterResult& r) {
    return {
        {"method", r.method},  {"samples_per_pixel", r.samples_per_pixel}, {"most_samples", r.most_samples},
        {"rmse", r.rmse},      {"largest_error", r.largest_error},         {"missed", r.missed},
        {"seconds", r.seconds}};
}

}  // namespace

std::uint64_t WaterReport::missed() const {
    std::uint64_t sum = reference_missed + adaptive.missed + random.missed + sobol.missed;
    for (const WaterResult& r : paper) sum += r.missed;
    return sum;
}

bool WaterReport::finite() const {
    const auto is_finite = [](const WaterResult& r) { return std::isfinite(r.rmse); };
    return std::isfinite(filter_rmse) && is_finite(adaptive) && is_finite(random) && is_finite(sobol) &&
           std::all_of(paper.begin(), paper.end(), is_finite);
}

std::optional<PixelWindow> window_of_water(const Scene& scene, const Geometry& geometry, ImageSize size) {
    WaterOptions one;
    one.mode = WaterMode::Fixed;
    one.fixed = 1;
    const ImageSize whole = scene.camera.size;
    const RenderedPicture picture = drawn(scene, geometry, one);
    std::vector<int> columns, rows;
    each_water_pixel({0, 0, whole.width, whole.height}, picture.extra.water_samples, [&](PixelIndex at) {
        columns.push_back(at.x);
        rows.push_back(at.y);
    });
    if (columns.empty()) return std::nullopt;
    const auto begin_of = [](std::vector<int>& places, int length, int of) {
        const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
        std::nth_element(places.begin(), middle, places.end());
        return std::clamp(*middle - length / 2, 0, of - length);
    };
    const int width = std::min(size.width, whole.width), height = std::min(size.height, whole.height);
    return PixelWindow{begin_of(columns, width, whole.width), begin_of(rows, height, whole.height), width,
                       height};
}

WaterReport check_water(const Scene& scene, const Geometry& geometry, const WaterCheckOptions& options) {
    return check_water([&](const WaterOptions& water) { return drawn(scene, geometry, water); }, options);
}

WaterReport check_water(const WaterDrawing& draw, const WaterCheckOptions& options) {
    WaterOptions many = fixed(Sampler::Sobol, options.reference_samples, options);
    many.seed = kReferenceSeed;
    const RenderedPicture reference = draw(many);
    many.filter = false;
    const RenderedPicture all_waves = draw(many);

    WaterReport report;
    report.window = options.window;
    report.asked_error = options.error;
    report.reference_missed = reference.water.missed + all_waves.water.missed;
    each_water_pixel(options.window, reference.extra.water_samples, [&](PixelIndex) { ++report.pixels; });
    report.filter_rmse = compared("", reference, all_waves, options.window).rmse;

    WaterOptions adaptive;
    adaptive.error = options.error;
    adaptive.most = 1 << 16;
    adaptive.window = options.window;
    adaptive.seed = options.seed;
    report.adaptive = compared("variance", draw(adaptive), reference, options.window);
    // What was measured beforehand, all over the picture: as many samples as it has pixels of water.
    report.adaptive.samples_per_pixel += 1;
    const int equal = std::max(1, static_cast<int>(std::ceil(report.adaptive.samples_per_pixel)));
    report.random =
        compared("random", draw(fixed(Sampler::Random, equal, options)), reference, options.window);
    report.sobol = compared("sobol", draw(fixed(Sampler::Sobol, equal, options)), reference, options.window);
    for (const double k_w : options.k_w)
        for (const double k_r : options.k_r) {
            WaterOptions paper;
            paper.mode = WaterMode::Paper;
            paper.paper = {.k_w = k_w, .k_r = k_r, .most = options.paper_most};
            paper.window = options.window;
            paper.seed = options.seed;
            report.paper.push_back(compared(fmt::format("paper k_w {:g}, k_r {:g}", k_w, k_r), draw(paper),
                                            all_waves, options.window));
        }
    return report;
}

std::string report_json(const WaterReport& report, double seconds) {
    nlohmann::ordered_json json;
    json["verdict"] = report.pass() ? "pass" : "fail";
    json["pixels"] = report.pixels;
    json["window"] = {report.window.x, report.window.y, report.window.width, report.window.height};
    json["asked_error"] = report.asked_error;
    json["error_as_asked"] = report.error_as_asked();
    json["beats_random"] = report.beats_random();
    json["missed"] = report.missed();
    json["finite"] = report.finite();
    json["filter_rmse"] = report.filter_rmse;
    for (const WaterResult* r : {&report.adaptive, &report.random, &report.sobol})
        json["methods"].push_back(json_of(*r));
    for (const WaterResult& r : report.paper) json["methods"].push_back(json_of(r));
    json["seconds"] = seconds;
    return json.dump();
}

std::string report_table(const WaterReport& report) {
    std::string text =
        "| method | samples a pixel | most | RMSE | largest error |\n|---|---:|---:|---:|---:|\n";
    const auto add = [&](const WaterResult& r) {
        text += fmt::format("| {} | {:.1f} | {} | {:.2f} | {:.1f} |\n", r.method, r.samples_per_pixel,
                            r.most_samples, r.rmse, r.largest_error);
    };
    for (const WaterResult* r : {&report.adaptive, &report.random, &report.sobol}) add(*r);
    for (const WaterResult& r : report.paper) add(r);
    return text;
}

}  // namespace keikan::convergence

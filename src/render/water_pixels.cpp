// SPDX-License-Identifier: Apache-2.0
#include "water_pixels.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "keikan/clip/visible_areas.hpp"
#include "keikan/image/srgb.hpp"
#include "keikan/support/parallel.hpp"
#include "keikan/water/face_rays.hpp"
#include "keikan/water/water_light.hpp"
#include "keikan/wave/counter_random.hpp"
#include "keikan/wave/water_footprint.hpp"
#include "water_region.hpp"

namespace keikan {

namespace {

// What the random numbers of a pixel are for.
constexpr std::uint32_t kPosition = 1, kSlope = 2, kSecondPosition = 3, kSecondSlope = 4;

/// A wave is traced in full where its length is at least the footprint's extent along it, and is slopes alone
/// where three of its lengths fit into it; in between, its amplitude fades, so that no line is drawn where it
/// ends.
constexpr double kTracedCycles = 1, kSlopeCycles = 3;

/// The error of Sobol's points beside that of as many independent ones, which the variance of the samples
/// tells: measured on riverside, 64 samples (docs/water.md).
constexpr double kSobolGain = 0.65;

double traced_share(double cycles) {
    const double s = std::clamp((cycles - kTracedCycles) / (kSlopeCycles - kTracedCycles), 0.0, 1.0);
    return 1 - s * s * (3 - 2 * s);
}

/// Sums of samples and of their squares, channel by channel.
class SampleSums {
  public:
    void add(double r, double g, double b) {
        const double values[] = {r, g, b};
        for (int i = 0; i < 3; ++i) {
            sum_[i] += values[i];
            squares_[i] += values[i] * values[i];
        }
        ++count_;
    }
    void add(Rgb c) { add(static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)); }
    std::size_t count() const { return count_; }
    double mean(int i) const { return sum_[i] / static_cast<double>(count_); }
    double variance(int i) const {
        if (count_ < 2) return 0;
        const double n = static_cast<double>(count_), m = mean(i);
        return std::max(0.0, (squares_[i] - n * m * m) / (n - 1));
    }

  private:
    double sum_[3] = {0, 0, 0}, squares_[3] = {0, 0, 0};
    std::size_t count_ = 0;
};

/// By how many codes of 8 bits sRGB rises for each unit of linear light.
double codes_per_light(double linear) {
    if (linear >= 1) return 0;
    if (linear <= 0.0031308) return 255 * 12.92;
    return 255 * 1.055 / 2.4 * std::pow(linear, 1 / 2.4 - 1);
}

double code_of(float linear) {
    return 255 * srgb_from_linear(std::clamp(static_cast<double>(linear), 0.0, 1.0));
}

/// What all pixels have in common.
struct Shared {
    const Scene& scene;
    const ProjectedFaces& faces;
    const WaterOptions& options;
    const WaterLight& light;
};

/// Draws pixels, one after the other; owns the memory that this needs.
class Painter {
  public:
    explicit Painter(const Shared& shared) : shared_(shared), camera_(shared.scene.camera) {}

    void paint(const WaterPixels& all, const WaterPixels::Pixel& pixel, Rgb& colour) {
        samples_of_pixel_ = 0;
        at_ = {pixel.x, pixel.y};
        ++statistics_.pixels;
        if (pixel.water != kNoWater) {
            region_.set_whole();
            colour = water_colour(pixel.water, 1, Rgb{});
        } else {
            paint_divided(all.parts(pixel), colour);
        }
        count_samples(samples_of_pixel_);
    }

    /// Adds the water of one pixel's points, each by its weight.
    void paint_points(std::span<const WaterPoint> points, std::span<const std::uint16_t> water_of_object,
                      Rgb& colour) {
        at_ = {points[0].x, points[0].y};
        region_.set_whole();
        CounterRandom random(key(kSlope));
        std::uint16_t resolved = kNoWater;
        for (const WaterPoint& point : points) {
            const std::uint16_t water = water_of_object[point.object];
            if (water == kNoWater) continue;
            if (water != resolved) {
                water_ = &*shared_.scene.water[water];
                resolve();
                resolved = water;
            }
            const double u1 = random.uniform(), u2 = random.uniform();
            SampleSums one;
            sample(point.at, {u1, u2}, one);
            const float weight = static_cast<float>(point.weight);
            colour = colour + weight * Rgb{static_cast<float>(one.mean(0)), static_cast<float>(one.mean(1)),
                                           static_cast<float>(one.mean(2))};
        }
        if (resolved == kNoWater) return;
        ++statistics_.pixels;
        count_samples(points.size());
    }

    const WaterStatistics& statistics() const { return statistics_; }

  private:
    void count_samples(std::uint64_t samples) {
        statistics_.samples += samples;
        statistics_.most_samples = std::max(statistics_.most_samples, samples);
        const auto bin = static_cast<std::size_t>(std::bit_width(std::max<std::uint64_t>(samples, 1)) - 1);
        ++statistics_.histogram[std::min(bin, statistics_.histogram.size() - 1)];
    }

    void paint_divided(std::span<const WaterPixels::Part> parts, Rgb& colour) {
        // The triangles of one water are one region; with nothing else in the pixel, the whole of it.
        double water_weight = 0;
        for (const WaterPixels::Part& part : parts)
            if (part.water == parts[0].water && part.water != kNoWater) water_weight += part.weight;
        if (water_weight >= 1 - kAreaSumError) {
            region_.set_whole();
            colour = water_colour(parts[0].water, 1, Rgb{});
            return;
        }
        ++statistics_.mixed_pixels;
        if (shared_.options.mixed == MixedPixels::Paper) {
            const auto largest =
                std::max_element(parts.begin(), parts.end(), [](const auto& p, const auto& q) {
                    return std::pair(p.water != kNoWater, p.weight) <
                           std::pair(q.water != kNoWater, q.weight);
                });
            region_.set_whole();
            colour = water_colour(largest->water, 1, Rgb{});
            return;
        }
        // The faces that are seen hide what is hidden, so they alone divide the pixel as all faces do.
        asked_.clear();
        for (const WaterPixels::Part& part : parts) {
            const auto found = std::lower_bound(shared_.faces.id.begin(), shared_.faces.id.end(), part.face);
            asked_.push_back(shared_.faces[static_cast<std::size_t>(found - shared_.faces.id.begin())]);
        }
        visible_areas_(at_, asked_, Nearness::ByDepth);
        const auto pieces = visible_areas_.pieces();
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::uint16_t water = parts[i].water;
            if (water == kNoWater) continue;
            const auto same = [&](const WaterPixels::Part& part) { return part.water == water; };
            if (std::any_of(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(i), same)) continue;
            double weight = 0;
            for (const WaterPixels::Part& part : parts)
                if (same(part)) weight += part.weight;
            region_.clear();
            for (const VisiblePiece& piece : pieces)
                if (piece.face < parts.size() && same(parts[piece.face])) region_.add(piece.ring);
            // A region that only rounding left is where its centroid is.
            if (region_.empty()) add_point(parts[i].centroid);
            colour = colour + static_cast<float>(weight) * water_colour(water, weight, colour);
        }
    }

    void add_point(Point p) {
        const Point tiny[] = {p, {p.x + 0x1p-30, p.y}, {p.x, p.y + 0x1p-30}};
        region_.add(tiny);
    }

    /// The mean colour of the water over the region; `weight` is its share of the pixel, whose other shares
    /// are `base`.
    Rgb water_colour(std::uint16_t number, double weight, Rgb base) {
        water_ = &*shared_.scene.water[number];
        resolve();
        SampleSums sums;
        switch (shared_.options.mode) {
            case WaterMode::Variance:
                sample_to_error(weight, base, sums);
                break;
            case WaterMode::Paper:
                sample_as_the_paper(sums);
                break;
            case WaterMode::Fixed:
                sample_fixed(sums);
                break;
            case WaterMode::Flat:
                break;
        }
        samples_of_pixel_ += sums.count();
        return {static_cast<float>(sums.mean(0)), static_cast<float>(sums.mean(1)),
                static_cast<float>(sums.mean(2))};
    }

    ViewRay ray(double x, double y) const {
        const double u = (x - camera_.centre_x) / camera_.focal_px,
                     v = (y - camera_.centre_y) / camera_.focal_px;
        const glm::dvec3 off = u * camera_.right + v * camera_.down;
        if (camera_.kind == Camera::Kind::Orthographic) return {camera_.position + off, camera_.forward};
        return {camera_.position, camera_.forward + off};
    }

    /// The waves that this pixel traces, and the slopes of the others.
    void resolve() {
        const double x = at_.x, y = at_.y;
        std::array<ViewRay, 4> corners{ray(x, y), ray(x + 1, y), ray(x + 1, y + 1), ray(x, y + 1)};
        for (ViewRay& corner : corners) corner.origin.z -= water_->level_m;
        footprint_ = water_footprint(corners, WaterLight::kFarthest_m);
        const WaveSurface& waves = water_->waves;
        const bool filters = shared_.options.filter && shared_.options.mode != WaterMode::Paper;
        resolved_.unresolved = {water_->ripple_variance / 2, 0, water_->ripple_variance / 2};
        shares_.assign(waves.size(), 1);
        for (std::size_t i = 0; filters && i < waves.size(); ++i) {
            const glm::dvec2 direction = waves.direction(i);
            shares_[i] = traced_share(footprint_.extent_m(direction) / waves.length_m(i));
            resolved_.unresolved.add(direction, (1 - shares_[i] * shares_[i]) * waves.slope_variance(i));
        }
        resolved_.waves.set_shares(waves, shares_);
    }

    void sample(Point position, Point slope, SampleSums& sums, SampleSums* codes = nullptr) {
        const Point p = region_.at(position);
        ViewRay view = ray(at_.x + p.x, at_.y + p.y);
        view.direction = glm::normalize(view.direction);
        const WaterSample seen = shared_.light.along(*water_, resolved_, view, {slope.x, slope.y});
        statistics_.face_rays += seen.rays;
        statistics_.missed += seen.missed ? 1 : 0;
        sums.add(seen.colour);
        if (codes != nullptr)
            codes->add(code_of(seen.colour.r), code_of(seen.colour.g), code_of(seen.colour.b));
    }

    std::uint64_t key(std::uint32_t purpose) const {
        return random_key(at_.x, at_.y, purpose, shared_.options.seed);
    }

    /// Doubles the samples until their standard error is small enough.
    void sample_to_error(double weight, Rgb base, SampleSums& sums) {
        const std::uint64_t position = key(kPosition), slope = key(kSlope);
        const float bases[] = {base.r, base.g, base.b};
        const auto most = static_cast<std::size_t>(shared_.options.most);
        for (std::size_t wanted = static_cast<std::size_t>(shared_.options.least);; wanted *= 2) {
            for (auto i = static_cast<std::uint32_t>(sums.count()); i < wanted; ++i)
                sample(scrambled_sobol(i, position), shuffled_sobol(i, slope), sums);
            double error = 0;
            for (int c = 0; c < 3; ++c) {
                const double standard =
                    kSobolGain * weight * std::sqrt(sums.variance(c) / static_cast<double>(sums.count()));
                const double light = static_cast<double>(bases[c]) + weight * sums.mean(c);
                error = std::max(error, standard * codes_per_light(light - standard));
            }
            if (error <= shared_.options.error || 2 * wanted > most) break;
        }
    }

    void sample_points_of(Sampler sampler, std::size_t count, std::uint32_t position, std::uint32_t slope,
                          SampleSums& sums, SampleSums* codes) {
        sample_points(sampler, count, key(position), points_);
        if (sampler == Sampler::Sobol) {
            for (std::uint32_t i = 0; i < points_.size(); ++i)
                sample(points_[i], shuffled_sobol(i, key(slope)), sums, codes);
            return;
        }
        CounterRandom random(key(slope));
        for (const Point p : points_) {
            const double u1 = random.uniform(), u2 = random.uniform();
            sample(p, {u1, u2}, sums, codes);
        }
    }

    /// Paper 4.2 to 4.4.
    void sample_as_the_paper(SampleSums& sums) {
        SampleSums codes;
        const PaperSampleCounts& counts = shared_.options.paper;
        const int first = paper_first_count(water_->waves, footprint_, counts);
        sample_points_of(Sampler::Paper, static_cast<std::size_t>(first), kPosition, kSlope, sums, &codes);
        const double largest = std::max({codes.variance(0), codes.variance(1), codes.variance(2)});
        const int second = paper_second_count(largest, counts);
        if (second > 0)
            sample_points_of(Sampler::Paper, static_cast<std::size_t>(second), kSecondPosition, kSecondSlope,
                             sums, &codes);
    }

    void sample_fixed(SampleSums& sums) {
        sample_points_of(shared_.options.fixed_sampler, static_cast<std::size_t>(shared_.options.fixed),
                         kPosition, kSlope, sums, nullptr);
    }

    const Shared& shared_;
    const Camera& camera_;
    WaterStatistics statistics_;
    std::uint64_t samples_of_pixel_ = 0;
    PixelIndex at_;
    const WaterSurface* water_ = nullptr;
    WaterFootprint footprint_;
    ResolvedWater resolved_;
    WaterRegion region_;
    VisibleAreas visible_areas_;
    std::vector<FaceView> asked_;
    std::vector<double> shares_;
    std::vector<Point> points_;
};

/// Adds up what the threads counted: whole numbers, so that the order does not matter.
class SharedCounts {
  public:
    void add(const WaterStatistics& s) {
        pixels_ += s.pixels;
        mixed_ += s.mixed_pixels;
        samples_ += s.samples;
        rays_ += s.face_rays;
        missed_ += s.missed;
        for (std::size_t i = 0; i < s.histogram.size(); ++i) histogram_[i] += s.histogram[i];
        std::uint64_t most = most_.load();
        while (most < s.most_samples && !most_.compare_exchange_weak(most, s.most_samples)) {
        }
    }
    WaterStatistics sums() const {
        WaterStatistics s{pixels_, mixed_, samples_, most_, rays_, missed_, {}, 0};
        for (std::size_t i = 0; i < s.histogram.size(); ++i) s.histogram[i] = histogram_[i];
        return s;
    }

  private:
    std::atomic<std::uint64_t> pixels_{0}, mixed_{0}, samples_{0}, most_{0}, rays_{0}, missed_{0};
    std::array<std::atomic<std::uint64_t>, 17> histogram_{};
};

}  // namespace

bool has_water_surfaces(const Scene& scene) {
    return std::any_of(scene.water.begin(), scene.water.end(),
                       [](const auto& water) { return water.has_value(); });
}

std::vector<std::uint16_t> water_of_objects(const Scene& scene, const Geometry& geometry) {
    std::vector<std::uint16_t> water_of(geometry.objects.size(), kNoWater);
    std::uint16_t next = 0;
    for (std::size_t o = 0; o < geometry.objects.size(); ++o) {
        if (geometry.objects[o].kind != ObjectKind::Water) continue;
        if (next < scene.water.size() && scene.water[next]) water_of[o] = next;
        ++next;
    }
    return water_of;
}

void WaterPixels::add_divided(int x, int y, std::span<const SeenPart> parts,
                              std::span<const SeenFace> faces) {
    if (by_points_) return;
    const auto begin = static_cast<std::uint32_t>(parts_.size());
    for (const SeenPart& part : parts) {
        const SeenFace& face = faces[part.face];
        parts_.push_back({face.id,
                          water_of(face),
                          {static_cast<double>(part.x), static_cast<double>(part.y)},
                          part.weight});
    }
    pixels_.push_back({x, y, kNoWater, begin, static_cast<std::uint32_t>(parts_.size())});
}

/// What outlives a list of pixels.
struct WaterPainter::Working {
    Working(const Scene& scene, const Geometry& geometry, const ProjectedFaces& faces,
            const WaterOptions& options)
        : rays(scene, geometry), light(scene, rays), shared{scene, faces, options, light} {}

    FaceRays rays;
    WaterLight light;
    Shared shared;
    SharedCounts counts;
};

WaterPainter::WaterPainter(const Scene& scene, const Geometry& geometry, const ProjectedFaces& faces,
                           const WaterOptions& options)
    : working_(std::make_unique<Working>(scene, geometry, faces, options)) {}

WaterPainter::~WaterPainter() = default;

void WaterPainter::paint(const WaterPixels& list, Image<Rgb>& image) {
    // Far pixels need other times than near ones: short runs share the work evenly.
    constexpr std::size_t kPixelsPerRun = 128;
    const auto all = list.pixels();
    parallel_ranges(all.size(), kPixelsPerRun, [&](std::size_t first, std::size_t end) {
        Painter painter(working_->shared);
        for (std::size_t i = first; i < end; ++i)
            painter.paint(list, all[i], image[PixelIndex{all[i].x, all[i].y}]);
        working_->counts.add(painter.statistics());
    });
}

void WaterPainter::paint(std::span<const WaterPoint> points, std::span<const std::uint16_t> water_of_object,
                         Image<Rgb>& image) {
    Painter painter(working_->shared);
    for (std::size_t first = 0; first < points.size();) {
        const PixelIndex pixel{points[first].x, points[first].y};
        std::size_t end = first + 1;
        while (end < points.size() && points[end].x == pixel.x && points[end].y == pixel.y) ++end;
        painter.paint_points(points.subspan(first, end - first), water_of_object, image[pixel]);
        first = end;
    }
    working_->counts.add(painter.statistics());
}

WaterStatistics WaterPainter::statistics() const {
    return working_->counts.sums();
}

WaterStatistics paint_water(std::span<const WaterPixels> pixels, const Scene& scene, const Geometry& geometry,
                            const ProjectedFaces& faces, const WaterOptions& options, Image<Rgb>& image) {
    const auto begin = std::chrono::steady_clock::now();
    WaterPainter painter(scene, geometry, faces, options);
    for (const WaterPixels& list : pixels) painter.paint(list, image);
    WaterStatistics statistics = painter.statistics();
    statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return statistics;
}

}  // namespace keikan

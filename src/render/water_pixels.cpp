// SPDX-License-Identifier: Apache-2.0
#include "water_pixels.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>

#include "keikan/clip/visible_areas.hpp"
#include "keikan/render/scene_rays.hpp"
#include "keikan/support/parallel.hpp"
#include "keikan/wave/counter_random.hpp"
#include "sample_sums.hpp"
#include "sobol_gain.hpp"
#include "water_random.hpp"
#include "water_region.hpp"

namespace keikan {

namespace {

/// How many samples the pixel needs for this standard error, from those that it has; not more than four times
/// as many, because few samples may mislead. No more than it has: enough. `sobol_share` is
/// SobolGain::variance_share.
std::size_t samples_for(double wanted, const SampleSums& sums, double sobol_share, double weight, Rgb base) {
    const float bases[] = {base.r, base.g, base.b};
    const auto count = static_cast<double>(sums.count());
    double square = 0;
    for (int c = 0; c < 3; ++c) {
        const double standard = weight * std::sqrt(sobol_share * sums.variance(c) / count);
        const double light = static_cast<double>(bases[c]) + weight * sums.mean(c);
        const double codes = standard * codes_per_light(light - standard);
        square += codes * codes / 3;
    }
    if (square <= wanted * wanted) return sums.count();
    // Sobol's points are best in whole blocks.
    constexpr double kGrowth = 4;
    const double needed = count * std::min(kGrowth, square / (wanted * wanted));
    const double together = needed <= 16 ? 4 : 16;
    return static_cast<std::size_t>(std::ceil(needed / together) * together);
}

/// What all pixels have in common.
struct Shared {
    const Scene& scene;
    const ProjectedFaces& faces;
    const WaterOptions& options;
    const SceneRays& rays;
    const SobolGain& gain;
};

/// Draws pixels, one after the other; owns the memory that this needs.
class Painter {
  public:
    explicit Painter(const Shared& shared)
        : shared_(shared),
          sampler_(shared.rays, shared.options.filter && shared.options.mode != WaterMode::Paper,
                   shared.options.seed) {}

    /// The samples that it took.
    std::uint64_t paint(const WaterPixels& all, const WaterPixels::Pixel& pixel, Rgb& colour) {
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
        return samples_of_pixel_;
    }

    /// How well Sobol's points do in a pixel that shows this water and nothing else.
    SobolGain::Note note(const WaterPixels::Pixel& pixel) {
        at_ = {pixel.x, pixel.y};
        region_.set_whole();
        sampler_.look_at(at_, pixel.water);
        SampleSums sums;
        std::vector<Rgb> all;
        // Block by block: slopes are paired within one call.
        for (std::size_t block = 0; block < SobolGain::kBlocks; ++block) {
            take_sobol(block * SobolGain::kBlock, (block + 1) * SobolGain::kBlock, sums);
            all.insert(all.end(), colours_.begin(), colours_.end());
        }
        return SobolGain::note(at_, all);
    }

    /// Adds the water of one pixel's points, each by its weight.
    void paint_points(std::span<const WaterPoint> points, std::span<const std::uint16_t> water_of_object,
                      Rgb& colour) {
        at_ = {points[0].x, points[0].y};
        CounterRandom random_slope(key(kSlopeNumbers)), random_sun(key(kSunNumbers));
        bool any = false;
        // Neighbours of one water at once.
        for (std::size_t first = 0; first < points.size();) {
            const std::uint16_t water = water_of_object[points[first].object];
            clear_points();
            std::size_t end = first;
            for (; end < points.size() && water_of_object[points[end].object] == water; ++end) {
                positions_.push_back(points[end].at);
                slopes_.push_back(random_point(random_slope));
                suns_.push_back(random_point(random_sun));
            }
            if (water != kNoWater) {
                any = true;
                sampler_.look_at(at_, water);
                colours_.resize(positions_.size());
                sampler_.colours(positions_, slopes_, suns_, colours_);
                for (std::size_t i = first; i < end; ++i)
                    colour = colour + static_cast<float>(points[i].weight) * colours_[i - first];
            }
            first = end;
        }
        if (!any) return;
        ++statistics_.pixels;
        count_samples(points.size());
    }

    WaterStatistics statistics() const {
        WaterStatistics all = statistics_;
        const WaterStatistics& seen = sampler_.statistics();
        all.samples = seen.samples;
        all.face_rays = seen.face_rays;
        all.wave_rays = seen.wave_rays;
        all.wave_steps = seen.wave_steps;
        all.missed = seen.missed;
        return all;
    }

  private:
    void count_samples(std::uint64_t samples) {
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
        sampler_.look_at(at_, number);
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
        return sums.mean();
    }

    std::uint64_t key(std::uint32_t purpose) const {
        return random_key(at_.x, at_.y, purpose, shared_.options.seed);
    }

    static Point random_point(CounterRandom& random) {
        const double u1 = random.uniform(), u2 = random.uniform();
        return {u1, u2};
    }

    void clear_points() {
        positions_.clear();
        slopes_.clear();
        suns_.clear();
    }

    /// Takes the samples whose places in the unit square are in positions_, slopes_ and suns_.
    void take(SampleSums& sums, SlopeOrder order, SampleSums* codes = nullptr) {
        for (Point& position : positions_) position = region_.at(position);
        colours_.resize(positions_.size());
        sampler_.colours(positions_, slopes_, suns_, colours_, order);
        for (const Rgb c : colours_) {
            sums.add(c);
            if (codes != nullptr)
                codes->add(code_of(static_cast<double>(c.r)), code_of(static_cast<double>(c.g)),
                           code_of(static_cast<double>(c.b)));
        }
    }

    /// Samples [begin, end) of Sobol's points; several slopes share a place.
    void take_sobol(std::size_t begin, std::size_t end, SampleSums& sums) {
        const std::uint64_t position = key(kPositionNumbers), slope = key(kSlopeNumbers),
                            sun = key(kSunNumbers);
        clear_points();
        for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
            positions_.push_back(scrambled_sobol(i / kSlopesOfAPlace, position));
            slopes_.push_back(scrambled_sobol(i, slope));
            suns_.push_back(shuffled_sobol(i, sun));
        }
        take(sums, SlopeOrder::ByRank);
    }

    /// Takes samples until their standard error is small enough.
    void sample_to_error(double weight, Rgb base, SampleSums& sums) {
        const WaterOptions& options = shared_.options;
        const auto most = static_cast<std::size_t>(options.most);
        std::size_t wanted = std::min(static_cast<std::size_t>(options.least), most);
        while (wanted > sums.count()) {
            take_sobol(sums.count(), wanted, sums);
            const double share = shared_.gain.variance_share(at_, sums.count());
            wanted = std::min(most, samples_for(options.error, sums, share, weight, base));
        }
    }

    void sample_points_of(Sampler sampler, std::size_t count, bool second, SampleSums& sums,
                          SampleSums* codes) {
        sample_points(sampler, count, key(second ? kSecondPositionNumbers : kPositionNumbers), positions_);
        slopes_.clear();
        suns_.clear();
        const std::uint64_t slope = key(second ? kSecondSlopeNumbers : kSlopeNumbers);
        const std::uint64_t sun = key(second ? kSecondSunNumbers : kSunNumbers);
        CounterRandom random_slope(slope), random_sun(sun);
        for (std::uint32_t i = 0; i < positions_.size(); ++i) {
            slopes_.push_back(sampler == Sampler::Sobol ? scrambled_sobol(i, slope)
                                                        : random_point(random_slope));
            suns_.push_back(sampler == Sampler::Sobol ? shuffled_sobol(i, sun) : random_point(random_sun));
        }
        take(sums, sampler == Sampler::Sobol ? SlopeOrder::ByRank : SlopeOrder::AsGiven, codes);
    }

    /// Paper 4.2 to 4.4.
    void sample_as_the_paper(SampleSums& sums) {
        SampleSums codes;
        const PaperSampleCounts& counts = shared_.options.paper;
        const auto first = static_cast<std::size_t>(sampler_.paper_first_count(counts));
        sample_points_of(Sampler::Paper, first, false, sums, &codes);
        const double largest = std::max({codes.variance(0), codes.variance(1), codes.variance(2)});
        const int second = paper_second_count(largest, counts);
        if (second > 0)
            sample_points_of(Sampler::Paper, static_cast<std::size_t>(second), true, sums, &codes);
    }

    void sample_fixed(SampleSums& sums) {
        sample_points_of(shared_.options.fixed_sampler, static_cast<std::size_t>(shared_.options.fixed),
                         false, sums, nullptr);
    }

    const Shared& shared_;
    WaterSampler sampler_;
    WaterStatistics statistics_;
    std::uint64_t samples_of_pixel_ = 0;
    PixelIndex at_;
    WaterRegion region_;
    VisibleAreas visible_areas_;
    std::vector<FaceView> asked_;
    std::vector<Point> positions_, slopes_, suns_;
    std::vector<Rgb> colours_;
};

/// Adds up what the threads counted: whole numbers, so that the order does not matter.
class SharedCounts {
  public:
    void add(const WaterStatistics& s) {
        pixels_ += s.pixels;
        mixed_ += s.mixed_pixels;
        samples_ += s.samples;
        measuring_ += s.measuring_samples;
        rays_ += s.face_rays;
        missed_ += s.missed;
        wave_rays_ += s.wave_rays;
        wave_steps_ += s.wave_steps;
        for (std::size_t i = 0; i < s.histogram.size(); ++i) histogram_[i] += s.histogram[i];
        std::uint64_t most = most_.load();
        while (most < s.most_samples && !most_.compare_exchange_weak(most, s.most_samples)) {
        }
    }
    WaterStatistics sums() const {
        WaterStatistics s{.pixels = pixels_,
                          .mixed_pixels = mixed_,
                          .samples = samples_,
                          .measuring_samples = measuring_,
                          .most_samples = most_,
                          .face_rays = rays_,
                          .wave_rays = wave_rays_,
                          .wave_steps = wave_steps_,
                          .missed = missed_};
        for (std::size_t i = 0; i < s.histogram.size(); ++i) s.histogram[i] = histogram_[i];
        return s;
    }

  private:
    std::atomic<std::uint64_t> pixels_{0}, mixed_{0}, samples_{0}, most_{0}, rays_{0}, missed_{0},
        wave_rays_{0}, wave_steps_{0}, measuring_{0};
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
    Working(const Scene& scene, const SceneRays& rays, const ProjectedFaces& faces,
            const WaterOptions& options)
        : gain(scene.camera.size), shared{scene, faces, options, rays, gain} {}
    SobolGain gain;
    Shared shared;
    SharedCounts counts;
};

WaterPainter::WaterPainter(const Scene& scene, const SceneRays& rays, const ProjectedFaces& faces,
                           const WaterOptions& options)
    : working_(std::make_unique<Working>(scene, rays, faces, options)) {}

WaterPainter::~WaterPainter() = default;

void WaterPainter::measure(std::span<const WaterPixels> lists) {
    if (working_->shared.options.mode != WaterMode::Variance) return;
    std::vector<WaterPixels::Pixel> chosen;
    for (const WaterPixels& list : lists)
        for (const WaterPixels::Pixel& pixel : list.pixels())
            if (pixel.water != kNoWater && SobolGain::measures({pixel.x, pixel.y})) chosen.push_back(pixel);
    std::sort(chosen.begin(), chosen.end(),
              [](const auto& p, const auto& q) { return std::pair(p.y, p.x) < std::pair(q.y, q.x); });
    std::vector<SobolGain::Note> notes(chosen.size());
    constexpr std::size_t kPixelsPerRun = 64;
    parallel_ranges(chosen.size(), kPixelsPerRun, [&](std::size_t first, std::size_t end) {
        Painter painter(working_->shared);
        for (std::size_t i = first; i < end; ++i) notes[i] = painter.note(chosen[i]);
        WaterStatistics taken = painter.statistics();
        std::swap(taken.measuring_samples, taken.samples);
        working_->counts.add(taken);
    });
    working_->gain.settle(notes);
}

void WaterPainter::paint(const WaterPixels& list, Image<Rgb>& image, Image<float>* counts) {
    // Far pixels need other times than near ones: short runs share the work evenly.
    constexpr std::size_t kPixelsPerRun = 128;
    const auto all = list.pixels();
    parallel_ranges(all.size(), kPixelsPerRun, [&](std::size_t first, std::size_t end) {
        Painter painter(working_->shared);
        const auto& window = working_->shared.options.window;
        for (std::size_t i = first; i < end; ++i) {
            const PixelIndex at{all[i].x, all[i].y};
            if (window && !window->holds(at)) continue;
            const std::uint64_t samples = painter.paint(list, all[i], image[at]);
            if (counts != nullptr) (*counts)[at] = static_cast<float>(samples);
        }
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

WaterStatistics paint_water(std::span<const WaterPixels> pixels, const Scene& scene, const SceneRays& rays,
                            const ProjectedFaces& faces, const WaterOptions& options, Image<Rgb>& image,
                            Image<float>* counts) {
    const auto begin = std::chrono::steady_clock::now();
    WaterPainter painter(scene, rays, faces, options);
    painter.measure(pixels);
    for (const WaterPixels& list : pixels) painter.paint(list, image, counts);
    WaterStatistics statistics = painter.statistics();
    statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return statistics;
}

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#include "region_sampler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "keikan/wave/pixel_sampler.hpp"
#include "water_random.hpp"

namespace keikan {

namespace {

/// Samples on strips of MirroredWires: of a wire that covers the share p of these, the coverage is off by
/// sqrt(p (1 - p)) / 8 of the strips' area.
constexpr std::size_t kOnWires = 64;

Point random_point(CounterRandom& random) {
    const double u1 = random.uniform(), u2 = random.uniform();
    return {u1, u2};
}

using Near = std::optional<std::array<NearVariance::Channel, 3>>;

/// What a pixel's colour is expected to err, with a given number of samples.
class ErrorForecast {
  public:
    /// Of a region of this share of the pixel, whose other shares are `base`. `exponent` is SobolGain's.
    ErrorForecast(const Near& near, double exponent, double weight, Rgb base)
        : near_(near),
          exponent_(exponent),
          weight_(weight),
          base_{static_cast<double>(base.r), static_cast<double>(base.g), static_cast<double>(base.b)} {}

    /// How many samples the neighbours let expect to be needed for this standard error; nothing without
    /// neighbours.
    std::optional<std::size_t> first_count(double wanted) const {
        if (!near_) return std::nullopt;
        // A tenth short: between pixels that vary more, one may vary less, and more samples can be added.
        constexpr double kTypical = 16, kShort = 1.1;
        std::array<double, 3> means, variances;
        for (std::size_t c = 0; c < 3; ++c) {
            means[c] = (*near_)[c].mean;
            variances[c] = (*near_)[c].variance;
        }
        const double excess =
            square(means, variances, std::pow(kTypical, exponent_ - 1)) / (kShort * kShort * wanted * wanted);
        return whole_blocks(kTypical * std::pow(excess, 1 / (1 - exponent_)));
    }

    /// So many samples were taken at once. Those of one call alone are well spread together.
    void took(std::size_t count) { spread_ += std::pow(static_cast<double>(count), 1 + exponent_); }

    /// How many are needed in all for this standard error, from those that there are; not more than four
    /// times as many, because few may mislead. No more than there are: enough.
    std::size_t count_for(double wanted, const SampleSums& sums) const {
        // A little more than what was asked for is left as it is: few more samples, by themselves, hardly
        // help.
        constexpr double kSlack = 1.25, kGrowth = 4;
        std::array<double, 3> means, variances;
        const double own = static_cast<double>(sums.count()) - 1, others = near_ ? kNeighbours : 0;
        for (std::size_t c = 0; c < 3; ++c) {
            means[c] = sums.mean(static_cast<int>(c));
            variances[c] =
                (own * sums.variance(static_cast<int>(c)) + others * (near_ ? (*near_)[c].variance : 0)) /
                std::max(own + others, 1.0);
        }
        const auto count = static_cast<double>(sums.count());
        const double now = spread_ / (count * count);
        const double excess = square(means, variances, now) / (wanted * wanted);
        if (excess <= kSlack) return sums.count();
        std::size_t enough = sums.count();
        for (double after = excess; after > 1 && static_cast<double>(enough) < kGrowth * count;) {
            enough = whole_blocks(static_cast<double>(enough) + 1);
            const auto all = static_cast<double>(enough);
            after = excess * (spread_ + std::pow(all - count, 1 + exponent_)) / (all * all) / now;
        }
        return enough;
    }

  private:
    /// A pixel's own samples are held together with what is known of its neighbours, who count as much as
    /// so many samples: eight of one's own may all have missed what the neighbours have met.
    static constexpr double kNeighbours = 4;

    /// Many are rounded up to whole blocks, at which Sobol's points are best.
    static std::size_t whole_blocks(double needed) {
        const double together = needed <= 16 ? kSlopesOfAPlace : needed <= 64 ? 4 : 16;
        return static_cast<std::size_t>(std::ceil(needed / together) * together);
    }

    /// Mean square over the channels of the standard error in codes of 8 bits, where a mean of samples has
    /// `per_sample` times their variance.
    double square(const std::array<double, 3>& means, const std::array<double, 3>& variances,
                  double per_sample) const {
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double standard = weight_ * std::sqrt(per_sample * variances[c]);
            const double light = base_[c] + weight_ * means[c];
            const double codes = (code_of(light + standard) - code_of(light - standard)) / 2;
            sum += codes * codes / 3;
        }
        return sum;
    }

    const Near& near_;
    double exponent_, weight_;
    std::array<double, 3> base_;
    double spread_ = 0;  ///< the mean's variance, in those of one sample, times the square of the count
};

}  // namespace

RegionSampler::RegionSampler(const SceneRays& rays, const WaterOptions& options,
                             const WaterMeasures& measures)
    : options_(options),
      measures_(measures),
      sampler_(rays, options.filter && options.mode != WaterMode::Paper, options.seed) {}

std::uint64_t RegionSampler::key(std::uint32_t purpose) const {
    return random_key(at_.x, at_.y, purpose, options_.seed);
}

void RegionSampler::look_at(PixelIndex pixel, std::uint16_t water, const WaterRegion& region) {
    at_ = pixel;
    region_ = &region;
    sampler_.look_at(pixel, water);
}

Rgb RegionSampler::colour(PixelIndex pixel, std::uint16_t water, const WaterRegion& region, double weight,
                          Rgb base) {
    look_at(pixel, water, region);
    if (options_.mode == WaterMode::Variance) {
        measures_.wires.at(pixel, water, strips_);
        return strips_.empty() ? colour_to_error(weight, base) : colour_beside_wires(weight, base);
    }
    SampleSums sums;
    if (options_.mode == WaterMode::Paper)
        sample_as_the_paper(sums);
    else
        take_points_of(options_.fixed_sampler, static_cast<std::size_t>(options_.fixed), false, sums,
                       nullptr);
    count_ = sums.count();
    return sums.mean();
}

SobolGain::Note RegionSampler::note(PixelIndex pixel, std::uint16_t water) {
    const WaterRegion whole;
    look_at(pixel, water, whole);
    SampleSums sums;
    noted_.clear();
    // Block by block: slopes are paired within one call.
    for (std::size_t block = 0; block < SobolGain::kBlocks; ++block) {
        take_sobol(block * SobolGain::kBlock, (block + 1) * SobolGain::kBlock, sums);
        noted_.insert(noted_.end(), colours_.begin(), colours_.end());
    }
    return SobolGain::note(pixel, noted_);
}

void RegionSampler::begin_points(PixelIndex pixel) {
    at_ = pixel;
    slope_numbers_ = CounterRandom(key(kSlopeNumbers));
    sun_numbers_ = CounterRandom(key(kSunNumbers));
}

std::span<const Rgb> RegionSampler::colours_at(std::uint16_t water, std::span<const Point> points) {
    slopes_.clear();
    suns_.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
        slopes_.push_back(random_point(slope_numbers_));
        suns_.push_back(random_point(sun_numbers_));
    }
    sampler_.look_at(at_, water);
    colours_.resize(points.size());
    sampler_.colours(points, slopes_, suns_, colours_);
    return colours_;
}

/// Takes the samples at positions_, with slopes_ and suns_.
void RegionSampler::take(SampleSums& sums, SlopeOrder order, SampleSums* codes) {
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
void RegionSampler::take_sobol(std::size_t begin, std::size_t end, SampleSums& sums) {
    const std::uint64_t position = key(kPositionNumbers), slope = key(kSlopeNumbers), sun = key(kSunNumbers);
    positions_.clear();
    slopes_.clear();
    suns_.clear();
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
        positions_.push_back(region_->at(scrambled_sobol(i / kSlopesOfAPlace, position)));
        slopes_.push_back(scrambled_sobol(i, slope));
        suns_.push_back(shuffled_sobol(i, sun));
    }
    take(sums, SlopeOrder::ByRank);
}

/// Takes samples until their standard error is small enough: `take(first, end, sums)` takes those numbers of
/// at most `most`; they count `weight` in the pixel, beside `base`.
template <typename Take>
void RegionSampler::sample_to_error(double weight, Rgb base, std::size_t most, SampleSums& sums,
                                    const Take& take) {
    const auto near = measures_.near.at(at_);
    ErrorForecast forecast(near, measures_.gain.exponent(at_), weight, base);
    const auto least = static_cast<std::size_t>(options_.least);
    std::size_t wanted =
        std::min(most, std::max(least, forecast.first_count(options_.error).value_or(4 * least)));
    while (wanted > sums.count()) {
        const std::size_t before = sums.count();
        take(before, wanted, sums);
        forecast.took(wanted - before);
        wanted = std::min(most, forecast.count_for(options_.error, sums));
    }
}

Rgb RegionSampler::colour_to_error(double weight, Rgb base) {
    SampleSums sums;
    sample_to_error(weight, base, static_cast<std::size_t>(options_.most), sums,
                    [&](std::size_t begin, std::size_t end, SampleSums& to) { take_sobol(begin, end, to); });
    count_ = sums.count();
    return sums.mean();
}

/// The same where wires are mirrored: kOnWires samples on their strips, the error that is asked for beside
/// them.
Rgb RegionSampler::colour_beside_wires(double weight, Rgb base) {
    using enum SamplePlaces::Part;
    places_.part(at_, *region_, strips_, key(kPlaceNumbers));
    CounterRandom choice(key(kChoiceNumbers));
    placed_ = 0;
    SampleSums on, beside;
    Rgb seen;
    if (const std::size_t on_strips = places_.count(OnStrips); on_strips > 0) {
        take_places(OnStrips, std::min(on_strips, kOnWires), choice, on);
        seen = static_cast<float>(places_.share(OnStrips)) * on.mean();
    }
    if (const std::size_t others = places_.count(Beside); others > 0) {
        const double share = places_.share(Beside);
        sample_to_error(weight * share, base + static_cast<float>(weight) * seen,
                        std::min(others, static_cast<std::size_t>(options_.most)), beside,
                        [&](std::size_t begin, std::size_t end, SampleSums& to) {
                            take_places(Beside, end - begin, choice, to);
                        });
        seen = seen + static_cast<float>(share) * beside.mean();
    }
    count_ = on.count() + beside.count();
    return seen;
}

/// So many more samples of a part.
void RegionSampler::take_places(SamplePlaces::Part part, std::size_t count, CounterRandom& choice,
                                SampleSums& sums) {
    positions_.clear();
    slopes_.clear();
    suns_.clear();
    places_.choose(part, count, choice, positions_);
    const std::uint64_t slope = key(kSlopeNumbers), sun = key(kSunNumbers);
    for (std::size_t i = 0; i < count; ++i, ++placed_) {
        slopes_.push_back(scrambled_sobol(placed_, slope));
        suns_.push_back(shuffled_sobol(placed_, sun));
    }
    take(sums, SlopeOrder::ByRank);
}

void RegionSampler::take_points_of(Sampler sampler, std::size_t count, bool second, SampleSums& sums,
                                   SampleSums* codes) {
    sample_points(sampler, count, key(second ? kSecondPositionNumbers : kPositionNumbers), positions_);
    for (Point& position : positions_) position = region_->at(position);
    slopes_.clear();
    suns_.clear();
    const std::uint64_t slope = key(second ? kSecondSlopeNumbers : kSlopeNumbers);
    const std::uint64_t sun = key(second ? kSecondSunNumbers : kSunNumbers);
    CounterRandom random_slope(slope), random_sun(sun);
    for (std::uint32_t i = 0; i < positions_.size(); ++i) {
        slopes_.push_back(sampler == Sampler::Sobol ? scrambled_sobol(i, slope) : random_point(random_slope));
        suns_.push_back(sampler == Sampler::Sobol ? shuffled_sobol(i, sun) : random_point(random_sun));
    }
    take(sums, sampler == Sampler::Sobol ? SlopeOrder::ByRank : SlopeOrder::AsGiven, codes);
}

/// Paper 4.2 to 4.4.
void RegionSampler::sample_as_the_paper(SampleSums& sums) {
    SampleSums codes;
    const PaperSampleCounts& counts = options_.paper;
    const auto first = static_cast<std::size_t>(sampler_.paper_first_count(counts));
    take_points_of(Sampler::Paper, first, false, sums, &codes);
    const double largest = std::max({codes.variance(0), codes.variance(1), codes.variance(2)});
    const int second = paper_second_count(largest, counts);
    if (second > 0) take_points_of(Sampler::Paper, static_cast<std::size_t>(second), true, sums, &codes);
}

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "keikan/image/image.hpp"
#include "keikan/model/pixel.hpp"
#include "keikan/model/point.hpp"
#include "keikan/render/water_options.hpp"
#include "keikan/scene/scene.hpp"

namespace keikan {

/// What rays need of a scene, to its water and to its sun: made once, asked from any number of threads.
///
/// Requires: `scene` and `geometry` outlive it.
/// Cost:     a hierarchy over all faces, a microsecond a face.
class SceneRays {
  public:
    SceneRays(const Scene& scene, const Geometry& geometry);
    ~SceneRays();

    /// The share of the sun's disc that is seen from points of a face whose plane has this unit normal (of
    /// either side): from points[i] a ray goes to the i-th of Sobol's points on the disc, keyed by `key`. The
    /// disc has the sun's true angular radius, kSunRadius_rad; with Shadows::Hard all rays go to its middle.
    ///
    /// Property: (1) A function of scene, geometry and the arguments alone, bit for bit.
    /// Error:    n points err by less than 2 / n for one straight edge before the sun, as a rule; the share
    /// is a
    ///           multiple of 1 / n.
    float sun_share(std::span<const glm::dvec3> points, const glm::dvec3& flat_normal,
                    std::uint64_t key) const;

  private:
    friend class WaterSampler;
    struct Light;
    std::unique_ptr<Light> light_;
};

struct FaceRay;

/// The colours of water at points of pixels, one pixel after the other. One for each thread.
///
///   WaterSampler sampler(rays);
///   sampler.look_at({412, 233}, 0);                 // water 0 of Scene::water
///   const Rgb seen = sampler.mean(pattern);         // exactly pattern.size() samples
///
/// Properties:
///   (1) A colour follows from scene, geometry, pixel, water, point, its slope and seed alone, bit for bit
///       (SlopeOrder::ByRank: from those of the whole call).
///   (2) The mean over points that are uniform in a region, with slopes that are uniform in the unit square,
///   is an
///       unbiased estimate of that region's colour.
class WaterSampler {
  public:
    /// `filter`: waves that are smaller than a pixel's footprint are slopes, drawn for each sample; otherwise
    /// all waves are traced.
    explicit WaterSampler(const SceneRays& rays, bool filter = true, std::uint32_t seed = 1);
    ~WaterSampler();
    WaterSampler(WaterSampler&&) noexcept;

    /// The pixel that all questions are about from now on, and the water: its place in Scene::water, which
    /// must not be empty there.
    void look_at(PixelIndex pixel, std::uint16_t water);

    /// The mean colour of the water at these points of the pixel, which lie in [0, 1] x [0, 1] (x to the
    /// right, y down); linear light. Slopes are Sobol's points, keyed by the pixel: the same each time.
    /// Requires: at least one point.
    Rgb mean(std::span<const Point> points);

    /// The colour at each point, with slopes for uniform points of the unit square of one's own. All of equal
    /// size. Sun: from which point of its disc it shines, where faces have shadows.
    /// SlopeOrder::ByRank: of Sobol's points, in their order.
    void colours(std::span<const Point> points, std::span<const Point> slopes, std::span<const Point> suns,
                 std::span<Rgb> colours, SlopeOrder order = SlopeOrder::AsGiven);

    /// The rays that the last call of colours() sent to look for the first face, and to ask whether the sun
    /// is hidden: for measurements.
    std::span<const FaceRay> first_hit_rays() const;
    std::span<const FaceRay> sun_rays() const;

    /// Eq. (1) of the paper for this pixel.
    int paper_first_count(const PaperSampleCounts& counts) const;

    /// What was asked so far: samples, face_rays, wave_rays, steps, missed.
    const WaterStatistics& statistics() const;

  private:
    struct Working;
    std::unique_ptr<Working> working_;
};

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "keikan/image/image.hpp"
#include "keikan/render/render_bands.hpp"
#include "keikan/render/scene_rays.hpp"
#include "keikan/render/water_options.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scan/scan_band.hpp"
#include "keikan/scene/scene.hpp"

namespace keikan {

/// Whether any water of the scene is drawn by rays.
bool has_water_surfaces(const Scene& scene);

/// Which objects are water that is drawn by rays: for each object of the geometry its place in Scene::water,
/// or kNoWater.
std::vector<std::uint16_t> water_of_objects(const Scene& scene, const Geometry& geometry);
inline constexpr std::uint16_t kNoWater = 0xFFFF;

/// The pixels whose water is still to be drawn, collected while bands are shaded.
class WaterPixels {
  public:
    /// `by_points`: water is drawn at WaterPoints that someone else lists, so nothing is collected.
    explicit WaterPixels(std::vector<std::uint16_t> water_of_object, bool by_points = false)
        : water_of_object_(std::move(water_of_object)), by_points_(by_points) {}

    std::uint16_t water_of(const SeenFace& face) const {
        return face.object < water_of_object_.size() ? water_of_object_[face.object] : kNoWater;
    }
    /// The pixel shows this water and nothing else.
    void add_whole(int x, int y, std::uint16_t water) {
        if (!by_points_) pixels_.push_back({x, y, water, 0, 0});
    }
    /// The pixel is divided; at least one of the parts is water. All of its parts, because each may hide
    /// water.
    void add_divided(int x, int y, std::span<const SeenPart> parts, std::span<const SeenFace> faces);

    /// One part of a divided pixel.
    struct Part {
        FaceId face = 0;
        std::uint16_t water = kNoWater;
        Point centroid;
        double weight = 0;
    };
    struct Pixel {
        int x = 0, y = 0;
        std::uint16_t water = kNoWater;  ///< of a whole pixel; kNoWater: divided
        std::uint32_t part_begin = 0, part_end = 0;
    };
    std::span<const Pixel> pixels() const { return pixels_; }
    std::span<const Part> parts(const Pixel& pixel) const {
        return std::span(parts_).subspan(pixel.part_begin, pixel.part_end - pixel.part_begin);
    }

  private:
    std::vector<std::uint16_t> water_of_object_;
    bool by_points_;
    std::vector<Pixel> pixels_;
    std::vector<Part> parts_;
};

/// Adds the colours of the water to the pixels of `image`, which hold the shares of all that is not water
/// already (MixedPixels::Paper: replaces them).
///
/// A water region is what the visible areas leave to the water's faces; samples are uniform on it.
///
/// Properties:
///   (1) A pixel's colour follows from scene, geometry and options alone: not from other pixels or the number
///   of
///       threads. Random numbers are keyed by the pixel.
///   (2) The samples of a divided pixel lie in the region of the pixel that shows the water.
class WaterPainter {
  public:
    /// Requires: all four outlive it.
    WaterPainter(const Scene& scene, const SceneRays& rays, const ProjectedFaces& faces,
                 const WaterOptions& options);
    ~WaterPainter();

    /// Before any list is painted in WaterMode::Variance: measures how well samples do, in some pixels of all
    /// of them.
    void measure(std::span<const WaterPixels> lists);
    /// The pixels of a list, side by side; those outside of options.window are left alone. `counts`, where
    /// given, holds each pixel's samples afterwards.
    void paint(const WaterPixels& list, Image<Rgb>& image, Image<float>* counts = nullptr);
    /// Adds `weight` times the colour of the water at each point, slopes being random. On this thread; may be
    /// called by several at once, for different pixels.
    ///
    /// Requires: points of a pixel stand together. Of objects that are not water (kNoWater) they are left
    /// out.
    void paint(std::span<const WaterPoint> points, std::span<const std::uint16_t> water_of_object,
               Image<Rgb>& image);

    /// What was counted so far; `seconds` is not.
    WaterStatistics statistics() const;

  private:
    struct Working;
    std::unique_ptr<Working> working_;
};

/// All of it at once.
WaterStatistics paint_water(std::span<const WaterPixels> pixels, const Scene& scene, const SceneRays& rays,
                            const ProjectedFaces& faces, const WaterOptions& options, Image<Rgb>& image,
                            Image<float>* counts);

}  // namespace keikan

// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "keikan/model/point.hpp"
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

}  // namespace keikan

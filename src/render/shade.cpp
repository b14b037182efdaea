// SPDX-License-Identifier: Apache-2.0
#include "keikan/render/shade.hpp"

#include <array>
#include <cmath>

#include "keikan/render/scene_rays.hpp"
#include "keikan/support/check.hpp"
#include "keikan/wave/counter_random.hpp"
#include "keikan/wave/pixel_sampler.hpp"
#include "point_shader.hpp"
#include "water_pixels.hpp"
#include "water_random.hpp"

namespace keikan {

namespace {

/// A weighted mean of colours, summed in double so that it is rounded once.
class MeanColour {
  public:
    void add(double weight, Rgb colour) {
        r_ += weight * static_cast<double>(colour.r);
        g_ += weight * static_cast<double>(colour.g);
        b_ += weight * static_cast<double>(colour.b);
    }
    Rgb colour() const { return {static_cast<float>(r_), static_cast<float>(g_), static_cast<float>(b_)}; }

  private:
    double r_ = 0, g_ = 0, b_ = 0;
};

/// How much of the sun faces are seen by.
class SunShade {
  public:
    SunShade(const PointShader& shader, const Camera& camera, const SceneRays* rays)
        : shader_(shader), camera_(camera), rays_(rays) {}

    /// Of the face, as it is seen in a square of this side around the image point (x, y).
    float share(const SeenFace& face, const FaceShader& lit, PixelIndex pixel, double x, double y,
                double side) const {
        if (rays_ == nullptr || !lit.faces_sun(x, y)) return 1;
        const std::uint64_t key = random_key(pixel.x, pixel.y, kShadowNumbers, face.id);
        std::array<glm::dvec3, kMost> points;
        for (std::uint32_t i = 0; i < kMost; ++i) {
            const Point u = scrambled_sobol(i, key);
            const double at_x = x + (u.x - 0.5) * side, at_y = y + (u.y - 0.5) * side;
            points[i] = camera_.world_point(at_x, at_y, camera_.nearness_at(shader_.depth(face, at_x, at_y)));
        }
        const glm::dvec3 normal(face.flat_normal[0], face.flat_normal[1], face.flat_normal[2]);
        const float few = rays_->sun_share(std::span(points).first(kFew), normal, key);
        return few == 0 || few == 1 ? few : rays_->sun_share(points, normal, key);
    }

  private:
    static constexpr std::uint32_t kFew = 4, kMost = 32;
    const PointShader& shader_;
    const Camera& camera_;
    const SceneRays* rays_;
};

/// Shades one row; a row has one writer.
class RowPainter {
  public:
    RowPainter(const ScanBand& band, const PointShader& shader, const SunShade& shade, Image<Rgb>& image,
               ExtraImages* extra, WaterPixels* water, int y)
        : band_(band),
          shader_(shader),
          shade_(shade),
          colours_(image.row(y)),
          extra_(extra),
          water_(water),
          y_(y) {}

    void paint(const Span& span) {
        const bool empty = span.face == Span::kBackground;
        const auto row = colours_.subspan(static_cast<std::size_t>(span.x_begin),
                                          static_cast<std::size_t>(span.x_end - span.x_begin));
        double x = span.x_begin + 0.5;
        if (empty) {
            for (Rgb& colour : row) colour = shader_.background_colour(x++, y_ + 0.5);
        } else if (const std::uint16_t water = water_of(span.face); water != kNoWater) {
            for (int column = span.x_begin; column < span.x_end; ++column)
                water_->add_whole(column, y_, water);
        } else {
            const SeenFace& seen = band_.faces[span.face];
            const FaceShader face(shader_, seen);
            for (int column = span.x_begin; column < span.x_end; ++column, ++x)
                colours_[static_cast<std::size_t>(column)] =
                    face.colour(x, y_ + 0.5, shade_.share(seen, face, {column, y_}, x, y_ + 0.5, 1));
        }
        if (extra_ == nullptr) return;
        const SeenFace* const face = empty ? nullptr : &band_.faces[span.face];
        for (int column = span.x_begin; column < span.x_end; ++column)
            note(column, empty ? 1 : 0, face, 0.5, 0.5, 0);
    }

    void paint(const DividedPixel& pixel) {
        MeanColour mean;
        if (pixel.background > 0)
            mean.add(pixel.background, shader_.background_colour(pixel.x + 0.5, y_ + 0.5));
        const SeenPart* largest = nullptr;
        bool holds_water = false;
        for (std::uint32_t i = pixel.part_begin; i < pixel.part_end; ++i) {
            const SeenPart& part = band_.parts[i];
            if (part.weight > (largest != nullptr ? largest->weight : 0)) largest = &part;
            if (water_of(part.face) != kNoWater) {
                holds_water = true;
                continue;
            }
            const SeenFace& seen = band_.faces[part.face];
            const FaceShader face(shader_, seen);
            const double x = pixel.x + static_cast<double>(part.x), y = y_ + static_cast<double>(part.y);
            const float sun = shade_.share(seen, face, {pixel.x, y_}, x, y, std::sqrt(part.weight) / 2);
            mean.add(part.weight, face.colour(x, y, sun));
        }
        if (holds_water)
            water_->add_divided(
                pixel.x, y_,
                std::span(band_.parts).subspan(pixel.part_begin, pixel.part_end - pixel.part_begin),
                band_.faces);
        colours_[static_cast<std::size_t>(pixel.x)] = mean.colour();
        if (extra_ == nullptr) return;
        const float flag = pixel.division == Division::ExactAreas ? 1 : 2;
        if (largest == nullptr || pixel.background > largest->weight) {
            note(pixel.x, pixel.background, nullptr, 0.5, 0.5, flag);
        } else {
            note(pixel.x, pixel.background, &band_.faces[largest->face], largest->x, largest->y, flag);
        }
    }

  private:
    /// The water that a face of the band is drawn as by rays; kNoWater: as any face.
    std::uint16_t water_of(std::uint32_t face) const {
        return water_ != nullptr ? water_->water_of(band_.faces[face]) : kNoWater;
    }

    /// Fills in those of the extra images that are wanted; `face` shows the most, none: the background does.
    void note(int x, double background, const SeenFace* face, double local_x, double local_y, float flag) {
        const PixelIndex at{x, y_};
        const auto set = [&](Image<float>& image, float value) {
            if (image.width() > 0) image[at] = value;
        };
        set(extra_->background, static_cast<float>(background));
        set(extra_->object_id, face != nullptr ? static_cast<float>(1 + face->object) : 0);
        set(extra_->depth,
            face != nullptr ? static_cast<float>(shader_.depth(*face, x + local_x, y_ + local_y)) : 0);
        set(extra_->flags, flag);
    }

    const ScanBand& band_;
    const PointShader& shader_;
    const SunShade& shade_;
    std::span<Rgb> colours_;
    ExtraImages* extra_;
    WaterPixels* water_;
    int y_;
};

}  // namespace

void shade_band(const ScanBand& band, const Scene& scene, Image<Rgb>& image, ExtraImages* extra,
                WaterPixels* water, const SceneRays* rays) {
    for (const SeenFace& face : band.faces)
        KEIKAN_CHECK(face.material < scene.materials.size(), "face " << face.id << " has no material");
    const PointShader shader(scene);
    const SunShade shade(shader, scene.camera, scene.light.shadows != Shadows::Off ? rays : nullptr);
    for (int row = 0; row < band.rows; ++row) {
        const auto r = static_cast<std::size_t>(row);
        RowPainter painter(band, shader, shade, image, extra, water, band.first_row + row);
        for (std::uint32_t i = band.span_begin[r]; i < band.span_begin[r + 1]; ++i)
            painter.paint(band.spans[i]);
        for (std::uint32_t i = band.divided_begin[r]; i < band.divided_begin[r + 1]; ++i)
            painter.paint(band.divided[i]);
    }
}

}  // namespace keikan

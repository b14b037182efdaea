// SPDX-License-Identifier: Apache-2.0
#include "keikan/render/object_light.hpp"

#include "point_shader.hpp"

namespace keikan {

void add_object_light(const ScanBand& band, const Scene& scene, std::span<double> light) {
    const PointShader shader(scene);
    for (int row = 0; row < band.rows; ++row) {
        const auto r = static_cast<std::size_t>(row);
        const int y = band.first_row + row;
        for (std::uint32_t i = band.span_begin[r]; i < band.span_begin[r + 1]; ++i) {
            const Span& span = band.spans[i];
            if (span.face == Span::kBackground) continue;
            const SeenFace& seen = band.faces[span.face];
            const FaceShader face(shader, seen);
            for (int x = span.x_begin; x < span.x_end; ++x)
                light[seen.object] += static_cast<double>(luminance(face.colour(x + 0.5, y + 0.5)));
        }
        for (std::uint32_t i = band.divided_begin[r]; i < band.divided_begin[r + 1]; ++i) {
            const DividedPixel& pixel = band.divided[i];
            for (std::uint32_t p = pixel.part_begin; p < pixel.part_end; ++p) {
                const SeenPart& part = band.parts[p];
                const SeenFace& seen = band.faces[part.face];
                const double x = pixel.x + static_cast<double>(part.x),
                             at_y = y + static_cast<double>(part.y);
                light[seen.object] +=
                    part.weight * static_cast<double>(luminance(FaceShader(shader, seen).colour(x, at_y)));
            }
        }
    }
}

}  // namespace keikan

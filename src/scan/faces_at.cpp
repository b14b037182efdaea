// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "keikan/scan/pixel_question.hpp"
#include "keikan/scan/projected_faces.hpp"

namespace keikan {

std::vector<std::uint32_t> faces_at(const ProjectedFaces& faces, PixelIndex pixel) {
    std::vector<std::uint32_t> met;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const auto outline = faces[i].outline;
        const auto [left, right] =
            std::minmax_element(outline.begin(), outline.end(), [](Point p, Point q) { return p.x < q.x; });
        const auto [top, bottom] =
            std::minmax_element(outline.begin(), outline.end(), [](Point p, Point q) { return p.y < q.y; });
        if (left->x <= pixel.x + 1.0 && right->x >= pixel.x && top->y <= pixel.y + 1.0 &&
            bottom->y >= pixel.y)
            met.push_back(static_cast<std::uint32_t>(i));
    }
    return met;
}

PixelCase pixel_question(const ProjectedFaces& faces, PixelIndex pixel) {
    PixelCase question;
    question.id = std::to_string(pixel.x) + "," + std::to_string(pixel.y);
    question.pixel = pixel;
    question.depth.emplace();
    for (const std::uint32_t i : faces_at(faces, pixel)) {
        const FaceView face = faces[i];
        question.polygons.emplace_back(face.outline.begin(), face.outline.end());
        question.depth->push_back(face.depth);
    }
    return question;
}

}  // namespace keikan

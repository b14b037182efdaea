// SPDX-License-Identifier: GPL-3.0-or-later
#include "small_picture.hpp"

#include <stdexcept>

#include "keikan/clip/visible_areas.hpp"

namespace keikan {
void add_face(ProjectedFaces& faces, const Ring& outline, DepthPlane plane) {
    faces.points.insert(faces.points.end(), outline.begin(), outline.end());
    faces.begin.push_back(static_cast<std::uint32_t>(faces.points.size()));
    faces.id.push_back(static_cast<FaceId>(faces.id.size()));
    faces.plane.push_back(plane);
}

namespace {

Object object_of(std::size_t faces, std::uint16_t material) {
    Object object;
    for (std::size_t i = 0; i < faces; ++i) object.mesh.add_face({}, material);
    return object;
}

std::vector<SeenFace> seen_faces(const ProjectedFaces& faces) {
    std::vector<SeenFace> seen(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const std::uint16_t object = i < SmallPicture::RisingRoof ? 0 : 1;
        seen[i].id = faces.id[i];
        seen[i].object = object;
        seen[i].material = object;
        seen[i].plane = faces.plane[i];
    }
    return seen;
}

void add_pixel(ScanBand& band, int x, const PixelCoverage& seen) {
    const bool one_face = seen.parts.size() == 1 && seen.parts[0].area == 1;
    if (seen.parts.empty() || one_face) {
        band.spans.push_back({x, x + 1, one_face ? seen.parts[0].face : Span::kBackground});
        return;
    }
    DividedPixel divided;
    divided.x = x;
    divided.background = seen.background;
    divided.part_begin = static_cast<std::uint32_t>(band.parts.size());
    for (const VisiblePart& part : seen.parts) {
        SeenPart shown;
        shown.face = part.face;
        shown.weight = part.area;
        band.parts.push_back(shown);
    }
    divided.part_end = static_cast<std::uint32_t>(band.parts.size());
    band.divided.push_back(divided);
}

ScanBand band_from(int first_row, int rows, const ProjectedFaces& faces) {
    std::vector<FaceView> views;
    for (std::size_t i = 0; i < faces.size(); ++i) views.push_back(faces[i]);
    VisibleAreas visible_areas;
    ScanBand band;
    band.first_row = first_row;
    band.rows = rows;
    band.faces = seen_faces(faces);
    band.span_begin = band.divided_begin = {0};
    for (int y = first_row; y < first_row + rows; ++y) {
        for (int x = 0; x < SmallPicture::kSize.width; ++x)
            add_pixel(band, x, visible_areas({x, y}, views, Nearness::ByDepth));
        band.span_begin.push_back(static_cast<std::uint32_t>(band.spans.size()));
        band.divided_begin.push_back(static_cast<std::uint32_t>(band.divided.size()));
    }
    return band;
}

}  // namespace

SmallPicture::SmallPicture() {
    add_face(faces, {{-1, 1}, {9, 1}, {9, 7}, {-1, 7}}, {0, 0, 1});                          // Wall
    add_face(faces, {{0.25, 1.5}, {3.5, 2.25}, {0.75, 4.5}}, {0.01, 0.02, 2});               // Triangle
    add_face(faces, {{-1, 0.25}, {9, 0.75}, {9, 0.8125}, {-1, 0.3125}}, {0, 0, 3});          // Wire
    add_face(faces, {{1.25, 4.25}, {2.75, 4.25}, {2.75, 5.75}, {1.25, 5.75}}, {0, 0, 0.5});  // Hidden
    add_face(faces, {{4.25, 1.25}, {7.5, 1.25}, {7.5, 5.5}, {4.25, 5.5}}, {1, 0.125, -3});   // RisingRoof
    add_face(faces, {{4.25, 1.75}, {7.75, 1.75}, {7.75, 5.25}, {4.25, 5.25}}, {-1, 0, 9});   // FallingRoof
    geometry.objects = {object_of(RisingRoof, 0), object_of(kFaces - RisingRoof, 1)};
    geometry.first_face = {0, RisingRoof, kFaces};
    for (int row = 0; row < kSize.height; row += 2) bands.push_back(band_from(row, 2, faces));
}

DividedPixel& SmallPicture::divided(PixelIndex pixel) {
    ScanBand& band = band_of(pixel.y);
    const auto row = static_cast<std::size_t>(pixel.y - band.first_row);
    for (auto i = band.divided_begin[row]; i < band.divided_begin[row + 1]; ++i)
        if (band.divided[i].x == pixel.x) return band.divided[i];
    throw std::logic_error("not a divided pixel");
}

Span& SmallPicture::span(PixelIndex pixel) {
    ScanBand& band = band_of(pixel.y);
    const auto row = static_cast<std::size_t>(pixel.y - band.first_row);
    for (auto i = band.span_begin[row]; i < band.span_begin[row + 1]; ++i)
        if (band.spans[i].x_begin <= pixel.x && pixel.x < band.spans[i].x_end) return band.spans[i];
    throw std::logic_error("not in a span");
}

SeenPart& SmallPicture::part(PixelIndex pixel, FaceId face) {
    const DividedPixel& at = divided(pixel);
    ScanBand& band = band_of(pixel.y);
    for (auto i = at.part_begin; i < at.part_end; ++i)
        if (band.parts[i].face == face) return band.parts[i];
    throw std::logic_error("the face does not show there");
}

}  // namespace keikan

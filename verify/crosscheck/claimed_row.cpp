// SPDX-License-Identifier: GPL-3.0-or-later
#include "claimed_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace keikan::crosscheck {
namespace {

std::optional<std::uint32_t> position_of(FaceId id, const ProjectedFaces& faces) {
    const auto found = std::ranges::lower_bound(faces.id, id);
    if (found == faces.id.end() || *found != id) return std::nullopt;
    return static_cast<std::uint32_t>(found - faces.id.begin());
}

class RowReader {
  public:
    RowReader(const ScanBand& band, int y, int width, const ProjectedFaces& faces)
        : band_(band), y_(y), faces_(faces) {
        row_.pixels.resize(static_cast<std::size_t>(width));
    }

    ClaimedRow read() {
        const auto row = static_cast<std::size_t>(y_ - band_.first_row);
        for (auto i = band_.span_begin[row]; i < band_.span_begin[row + 1]; ++i) read_span(band_.spans[i]);
        for (auto i = band_.divided_begin[row]; i < band_.divided_begin[row + 1]; ++i)
            read_divided(band_.divided[i]);
        for (std::size_t x = 0; x < row_.pixels.size(); ++x)
            if (row_.pixels[x].source == ClaimedRow::Source::Missing)
                fault(static_cast<int>(x), "is in no span and is not divided");
        return std::move(row_);
    }

  private:
    void fault(int x, std::string note) {
        row_.faults.push_back(
            {.kind = Disagreement::Kind::Form, .pixel = {x, y_}, .note = "the pixel " + std::move(note)});
    }

    /// The pixel to fill in, or nothing if it lies outside or has been told before.
    ClaimedRow::Pixel* fresh_pixel(int x) {
        if (x < 0 || static_cast<std::size_t>(x) >= row_.pixels.size()) {
            fault(x, "lies outside of the picture");
            return nullptr;
        }
        ClaimedRow::Pixel& pixel = row_.pixels[static_cast<std::size_t>(x)];
        if (pixel.source == ClaimedRow::Source::Missing) return &pixel;
        fault(x, "is told twice");
        return nullptr;
    }

    void add_part(int x, std::uint32_t band_face, double area) {
        const auto position =
            band_face < band_.faces.size() ? position_of(band_.faces[band_face].id, faces_) : std::nullopt;
        if (!position)
            fault(x, "shows a face that was never projected");
        else if (!(area > 0 && area <= 1))
            fault(x, fmt::format("shows an area of {:.17g}", area));
        else
            row_.parts.push_back({*position, area});
    }

    void read_span(const Span& span) {
        for (std::int32_t x = span.x_begin; x < span.x_end; ++x) {
            ClaimedRow::Pixel* pixel = fresh_pixel(x);
            if (!pixel) continue;
            const bool background = span.face == Span::kBackground;
            pixel->source = ClaimedRow::Source::OneFace;
            pixel->background = background ? 1 : 0;
            pixel->part_begin = static_cast<std::uint32_t>(row_.parts.size());
            if (!background) add_part(x, span.face, 1);
            pixel->part_end = static_cast<std::uint32_t>(row_.parts.size());
        }
    }

    void read_divided(const DividedPixel& divided) {
        ClaimedRow::Pixel* pixel = fresh_pixel(divided.x);
        if (!pixel) return;
        const bool exact = divided.division == Division::ExactAreas;
        pixel->source = exact ? ClaimedRow::Source::ExactAreas : ClaimedRow::Source::Scanline;
        pixel->background = divided.background;
        if (!(divided.background >= 0 && divided.background <= 1))
            fault(divided.x, fmt::format("shows a background of {:.17g}", divided.background));
        pixel->part_begin = static_cast<std::uint32_t>(row_.parts.size());
        for (auto i = divided.part_begin; i < divided.part_end; ++i)
            add_part(divided.x, band_.parts[i].face, band_.parts[i].weight);
        pixel->part_end = static_cast<std::uint32_t>(row_.parts.size());
    }

    const ScanBand& band_;
    int y_;
    const ProjectedFaces& faces_;
    ClaimedRow row_;
};

}  // namespace

ClaimedRow claimed_row(const ScanBand& band, int y, int width, const ProjectedFaces& faces) {
    return RowReader(band, y, width, faces).read();
}

std::vector<Disagreement> attribute_faults(const ScanBand& band, const Geometry& geometry,
                                           const ProjectedFaces& faces) {
    std::vector<Disagreement> faults;
    for (const SeenFace& seen : band.faces) {
        const auto fault = [&](const char* what) {
            faults.push_back(
                {.kind = Disagreement::Kind::Attributes,
                 .pixel = {0, band.first_row},
                 .face = seen.id,
                 .note = fmt::format("the rows from {} on shade it with another {}", band.first_row, what)});
        };
        const auto position = position_of(seen.id, faces);
        if (!position || seen.id >= geometry.first_face.back()) {
            fault("face's attributes: it was never projected");
            continue;
        }
        const auto next = std::ranges::upper_bound(geometry.first_face, seen.id);
        const auto object = static_cast<std::size_t>(next - geometry.first_face.begin()) - 1;
        const std::size_t face = seen.id - geometry.first_face[object];
        if (seen.plane != faces.plane[*position]) fault("face's depth plane");
        if (seen.object != object) fault("object");
        if (seen.material != geometry.objects[object].mesh.face_material[face]) fault("material");
    }
    return faults;
}

}  // namespace keikan::crosscheck

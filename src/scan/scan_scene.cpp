// SPDX-License-Identifier: Apache-2.0
#include "keikan/scan/scan_scene.hpp"

#include <algorithm>
#include <chrono>
#include <memory>

#include "face_facts.hpp"
#include "keikan/scan/band_builder.hpp"
#include "keikan/scan/seen_face.hpp"
#include "keikan/support/parallel.hpp"
#include "pixel_division.hpp"
#include "tile_bins.hpp"
#include "tile_candidates.hpp"

namespace keikan {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Makes bands, one after the other; each slot of the pipeline has its own.
class BandScan {
  public:
    BandScan(const ScanQuestion& question, const TileBins& bins, const Camera& camera)
        : question_(question),
          bins_(bins),
          camera_(camera),
          division_(question),
          builder_(question.faces.size()) {}

    void make(int tile_row) {
        const int first_row = tile_row * kTileSize;
        const int rows = std::min(kTileSize, camera_.size.height - first_row);
        counted_ = {};
        builder_.begin(first_row, rows);
        for (int column = 0; column < bins_.columns; ++column) scan_tile(column, tile_row, rows);
        band_.faces.clear();
        for (const std::uint32_t f : builder_.seen())
            band_.faces.push_back(
                seen_face(question_.faces, f, question_.geometry, question_.facts[f].object, camera_));
        builder_.finish(band_);
    }

    const ScanBand& band() const { return band_; }
    const ScanStatistics& counted() const { return counted_; }

  private:
    void scan_tile(int column, int tile_row, int rows) {
        const int x = column * kTileSize;
        const int columns = std::min(kTileSize, camera_.size.width - x);
        const auto tile = bins_.tile(column, tile_row);
        if (tile.empty()) {
            for (int row = 0; row < rows; ++row)
                builder_.add_span(row, x, x + columns, BandBuilder::kBackground);
            return;
        }
        candidates_.look(question_.faces, question_.facts, tile, x, tile_row * kTileSize, columns, rows);
        for (int row = 0; row < rows; ++row)
            for (int i = 0; i < columns; ++i)
                scan_pixel({x + i, tile_row * kTileSize + row}, row, candidates_.at(row, i));
    }

    void scan_pixel(PixelIndex pixel, int row, std::span<const Candidate> candidates) {
        if (candidates.empty()) return builder_.add_span(row, pixel.x, pixel.x + 1, BandBuilder::kBackground);
        if (candidates.size() == 1 && candidates[0].covers)
            return builder_.add_span(row, pixel.x, pixel.x + 1, candidates[0].face);
        const DividedView divided = division_(pixel, candidates);
        if (divided.parts.empty())
            return builder_.add_span(row, pixel.x, pixel.x + 1, BandBuilder::kBackground);
        if (divided.parts.size() == 1 && shows_it_wholly(divided))
            return builder_.add_span(row, pixel.x, pixel.x + 1, divided.parts[0].face);
        builder_.add_divided(row, pixel.x, divided.division, divided.parts, divided.background);
        count(divided);
    }

    /// The bound of the areas: a pixel that differs by less from one that shows a single face is one.
    static bool shows_it_wholly(const DividedView& divided) {
        return divided.background <= kVisibleAreaError && divided.parts[0].weight >= 1 - kVisibleAreaError;
    }

    void count(const DividedView& divided) {
        ++(divided.division == Division::ExactAreas ? counted_.divided_pixels : counted_.scanline_pixels);
        counted_.parts += divided.parts.size();
        const auto object = [&](const SeenPart& part) { return question_.facts[part.face].object; };
        if (divided.background > 0 ||
            std::any_of(divided.parts.begin(), divided.parts.end(),
                        [&](const SeenPart& part) { return object(part) != object(divided.parts[0]); }))
            ++counted_.multi_object_pixels;
    }

    const ScanQuestion& question_;
    const TileBins& bins_;
    const Camera& camera_;
    TileCandidates candidates_;
    PixelDivision division_;
    BandBuilder builder_;
    ScanBand band_;
    ScanStatistics counted_;
};

}  // namespace

ScanStatistics scan_faces(const ProjectedFaces& faces, const Geometry& geometry, const Camera& camera,
                          const ScanOptions& options, const std::function<void(const ScanBand&)>& take) {
    ScanStatistics statistics;
    statistics.faces = faces.size();
    const auto bin_start = std::chrono::steady_clock::now();
    const std::vector<FaceFacts> facts = face_facts(faces, geometry);
    const FaceNeighbours neighbours = face_neighbours(faces, facts, geometry);
    const TileBins bins = tile_bins(facts, camera.size);
    statistics.seconds_bin = seconds_since(bin_start);

    const auto divide_start = std::chrono::steady_clock::now();
    const ScanQuestion question{faces, facts, neighbours, geometry, options};
    const std::size_t threads = static_cast<std::size_t>(thread_count());
    const std::size_t in_flight = threads == 1 ? 1 : 2 * threads;
    std::vector<std::unique_ptr<BandScan>> scans(in_flight);
    parallel_in_order(
        static_cast<std::size_t>(bins.rows), in_flight,
        [&](std::size_t i, std::size_t slot) {
            if (!scans[slot]) scans[slot] = std::make_unique<BandScan>(question, bins, camera);
            scans[slot]->make(static_cast<int>(i));
        },
        [&](std::size_t, std::size_t slot) {
            const ScanStatistics& counted = scans[slot]->counted();
            statistics.divided_pixels += counted.divided_pixels;
            statistics.scanline_pixels += counted.scanline_pixels;
            statistics.multi_object_pixels += counted.multi_object_pixels;
            statistics.parts += counted.parts;
            take(scans[slot]->band());
        });
    statistics.seconds_divide = seconds_since(divide_start);
    return statistics;
}

}  // namespace keikan

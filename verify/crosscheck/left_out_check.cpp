// SPDX-License-Identifier: GPL-3.0-or-later
#include "left_out_check.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "certain_hiding.hpp"
#include "face_bins.hpp"
#include "keikan/support/parallel.hpp"
#include "oracle/exact_areas.hpp"
#include "sampling.hpp"

namespace keikan::crosscheck {
namespace {

/// For each face of `all`, whether it is not in `asked`. Both are in rising order of their ids.
std::vector<bool> left_out_of(const ProjectedFaces& asked, const ProjectedFaces& all) {
    std::vector<bool> left_out(all.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        while (next < asked.size() && asked.id[next] < all.id[i]) ++next;
        left_out[i] = next == asked.size() || asked.id[next] != all.id[i];
    }
    return left_out;
}

/// The exact areas, each from above, within 1e-16.
std::vector<double> areas_from_above(oracle::CertifiedSplitting& certified_areas, PixelIndex pixel,
                                     std::span<const FaceView> faces) {
    std::vector<double> areas;
    const oracle::CertifiedAreas certified = certified_areas(pixel, faces, Nearness::ByDepth);
    if (certified.certified) {
        for (const oracle::CertifiedArea& area : certified.areas) areas.push_back(area.value + area.error);
    } else {
        const auto exact = oracle::areas_by_rational_splitting(pixel, faces, Nearness::ByDepth);
        for (const mpq_class& area : exact.areas)
            areas.push_back(std::nextafter(area.get_d(), 2));  // get_d rounds towards 0
    }
    return areas;
}

struct RowFindings {
    std::uint64_t pixels = 0;
    double largest = 0;
    std::vector<Disagreement> seen;
};

}  // namespace

void check_left_out(const ProjectedFaces& asked, const ProjectedFaces& all, ImageSize size,
                    std::uint64_t seed, std::uint64_t one_in, CheckSummary& summary) {
    const std::vector<bool> left_out = left_out_of(asked, all);
    LeftOutCount& count = summary.left_out.emplace();
    count.faces = static_cast<std::uint64_t>(std::ranges::count(left_out, true));
    if (count.faces == 0) return;
    const FaceBins bins(all, size);
    const CertainHiding hiding(all);
    std::vector<RowFindings> rows(static_cast<std::size_t>(size.height));

    parallel_for(rows.size(), [&](std::size_t y) {
        const FaceBins::Row row = bins.row(static_cast<int>(y));
        oracle::CertifiedSplitting certified_areas;
        CertainHiding::Remaining remaining;
        std::vector<FaceView> views;
        const auto is_left_out = [&](std::uint32_t face) { return left_out[face]; };
        for (int x = 0; x < size.width; ++x) {
            const PixelIndex pixel{x, static_cast<int>(y)};
            if (draw_of(seed, pixel) % one_in != 0 || std::ranges::none_of(row.at(x), is_left_out)) continue;
            ++rows[y].pixels;
            hiding(pixel, row.at(x), remaining);
            if (std::ranges::none_of(remaining.faces, is_left_out)) continue;
            views.clear();
            for (const std::uint32_t face : remaining.faces) views.push_back(all[face]);
            const std::vector<double> areas = areas_from_above(certified_areas, pixel, views);
            Disagreement worst{.kind = Disagreement::Kind::LeftOut, .pixel = pixel, .bound = kSeenByRounding};
            double together = 0;
            for (std::size_t i = 0; i < areas.size(); ++i) {
                if (!left_out[remaining.faces[i]] || areas[i] == 0) continue;
                together += areas[i];
                if (areas[i] <= worst.exact) continue;
                worst.exact = areas[i];
                worst.face = all.id[remaining.faces[i]];
            }
            worst.error = together;
            rows[y].largest = std::max(rows[y].largest, together);
            if (together > kSeenByRounding) rows[y].seen.push_back(worst);
        }
    });
    for (const RowFindings& row : rows) {
        count.pixels += row.pixels;
        count.largest = std::max(count.largest, row.largest);
        for (const Disagreement& seen : row.seen) summary.add(seen);
    }
}

}  // namespace keikan::crosscheck

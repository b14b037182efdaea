// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/scene_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "crosscheck/error_bounds.hpp"
#include "crosscheck/error_picture.hpp"
#include "crosscheck/sampling.hpp"
#include "keikan/image/png_file.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/parallel.hpp"

namespace keikan::report {
namespace {

using crosscheck::ClaimedRow;

/// Pixels by number, row by row, with the reasons to show them.
using Chosen = std::map<std::size_t, std::vector<Reason>>;

/// Adds those `count` of `candidates` whose `rank` is largest, the earlier of two alike.
template <class Rank>
void choose(std::vector<std::size_t> candidates, std::size_t count, Rank rank, Reason reason,
            Chosen& chosen) {
    const auto middle = candidates.begin() + static_cast<std::ptrdiff_t>(std::min(count, candidates.size()));
    std::partial_sort(candidates.begin(), middle, candidates.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(rank(a), b) > std::pair(rank(b), a);
    });
    for (auto at = candidates.begin(); at != middle; ++at) {
        std::vector<Reason>& reasons = chosen[*at];
        if (reasons.empty() || reasons.back() != reason) reasons.push_back(reason);
    }
}

Chosen chosen_pixels(const CheckedScene& scene) {
    const auto errors = scene.check.errors().values();
    const auto wrong = scene.check.wrong().values();
    const auto kinds = scene.check.kinds().values();
    std::vector<std::size_t> off, disagreeing;
    std::vector<std::vector<std::size_t>> of_kind(crosscheck::kPixelKinds);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (errors[i] > 0) off.push_back(i);
        if (wrong[i] != 0) disagreeing.push_back(i);
        for (std::size_t k = 0; k < of_kind.size(); ++k)
            if ((kinds[i] >> k & 1) != 0) of_kind[k].push_back(i);
    }
    for (const crosscheck::Disagreement& d : scene.summary.disagreements) {
        const std::size_t i =
            static_cast<std::size_t>(d.pixel.y) * static_cast<std::size_t>(scene.check.errors().width()) +
            static_cast<std::size_t>(d.pixel.x);
        if (i < wrong.size() && wrong[i] == 0 && std::ranges::count(disagreeing, i) == 0)
            disagreeing.push_back(i);
    }
    Chosen chosen;
    const auto error = [&](std::size_t i) { return errors[i]; };
    choose(std::move(disagreeing), kDisagreeingShown, error, Reason::Disagrees, chosen);
    choose(std::move(off), kWorstShown, error, Reason::Worst, chosen);
    const auto draw = [&](std::size_t i) { return crosscheck::draw_of(scene.options.seed, i); };
    for (auto& pixels : of_kind) choose(std::move(pixels), kSamplesOfKind, draw, Reason::Sample, chosen);
    return chosen;
}

crosscheck::Claim claim_of_scan(std::span<const std::uint32_t> asked, const ClaimedRow& row,
                                const ClaimedRow::Pixel& pixel) {
    crosscheck::Claim claim{std::vector<double>(asked.size(), 0.0), pixel.background};
    for (const ClaimedRow::Part& part : row.parts_of(pixel)) {
        const auto at = std::ranges::lower_bound(asked, part.face) - asked.begin();
        claim.areas[static_cast<std::size_t>(at)] += part.area;
    }
    return claim;
}

PixelToShow pixel_to_show(const CheckedScene& scene, PixelIndex pixel, std::vector<Reason> reasons) {
    PixelToShow show;
    const ClaimedRow& row = scene.layers.row(pixel.y);
    const ClaimedRow::Pixel& claimed = row.pixels[static_cast<std::size_t>(pixel.x)];
    std::vector<std::uint32_t> asked = scene.check.faces_asked(pixel);
    for (const ClaimedRow::Part& part : row.parts_of(claimed)) asked.push_back(part.face);
    std::ranges::sort(asked);
    asked.erase(std::unique(asked.begin(), asked.end()), asked.end());

    show.asked.id = fmt::format("{},{}", pixel.x, pixel.y);
    show.asked.pixel = pixel;
    show.asked.depth.emplace();
    for (const std::uint32_t face : asked) {
        const FaceView view = scene.faces[face];
        show.asked.polygons.emplace_back(view.outline.begin(), view.outline.end());
        show.asked.depth->push_back(view.depth);
        show.objects.push_back(scene.layers.object_of(face));
        show.faces.push_back(view.id);
    }
    const bool divided = claimed.source == ClaimedRow::Source::ExactAreas;
    const Engine engine = scene.options.engine;
    // First whoever was asked to answer for the pixel.
    if (divided && engine == Engine::Published) show.claims.push_back(engines_claim(engine, show.asked));
    show.claims.push_back({"scan", claim_of_scan(asked, row, claimed)});
    show.claims.push_back(engines_claim(Engine::Traversal, show.asked));
    if (divided && engine == Engine::Traversal) std::swap(show.claims[0], show.claims[1]);
    show.engine = engine;
    show.error = scene.check.errors()[pixel];
    show.reasons = std::move(reasons);
    for (const crosscheck::Disagreement& d : scene.summary.disagreements)
        if (d.pixel == pixel) show.disagreements.push_back(d);
    return show;
}

ErrorHistogram histogram_of(const crosscheck::SceneCheck& check, bool flagged_only) {
    ErrorHistogram histogram;
    for (std::size_t i = 0; i < check.errors().values().size(); ++i)
        if (!flagged_only || check.flags().values()[i] == crosscheck::Flag::ExactAreas)
            histogram.add(check.errors().values()[i], crosscheck::area_bound(check.asked().values()[i]));
    return histogram;
}

}  // namespace

std::vector<PixelToShow> pixels_to_show(const CheckedScene& scene) {
    const Chosen chosen = chosen_pixels(scene);
    const std::vector<std::pair<std::size_t, std::vector<Reason>>> list(chosen.begin(), chosen.end());
    const auto width = static_cast<std::size_t>(scene.check.errors().width());
    std::vector<PixelToShow> pixels(list.size());
    parallel_for(list.size(), [&](std::size_t i) {
        const PixelIndex pixel{static_cast<int>(list[i].first % width),
                               static_cast<int>(list[i].first / width)};
        pixels[i] = pixel_to_show(scene, pixel, list[i].second);
    });
    return pixels;
}

void write_scene_report(const std::filesystem::path& folder, Page page, const CheckedScene& scene) {
    const crosscheck::SceneCheck& check = scene.check;
    const crosscheck::ErrorScale scale = crosscheck::scale_for(check.errors());
    write_png(folder / "picture.png", scene.picture);
    write_png(folder / "error.png", crosscheck::error_picture(check.errors(), check.wrong(), scale));
    write_whole_file(folder / "error_legend.txt", crosscheck::error_legend(scale));
    write_png(folder / "flags.png", crosscheck::flag_picture(check.flags()));

    page.errors = histogram_of(check, scene.options.flagged_only);
    page.picture = scene.layers.json(scene.picture, check);
    page.pixels = pixels_to_show(scene);
    page.junit = junit_cases(scene.summary);
    const auto wrong = static_cast<std::uint64_t>(
        std::ranges::count_if(check.wrong().values(), [](std::uint8_t w) { return w != 0; }));
    page.disagreeing_left_out = wrong > kDisagreeingShown ? wrong - kDisagreeingShown : 0;
    write_page(folder, page);
}

}  // namespace keikan::report

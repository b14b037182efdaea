// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/scene_report.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "../crosscheck/small_picture.hpp"
#include "keikan/image/png_file.hpp"
#include "keikan/support/parallel.hpp"

using namespace keikan;
using namespace keikan::crosscheck;
using namespace keikan::report;

namespace {

/// The small picture, checked, as a page sees it.
struct CheckedPicture {
    SmallPicture picture;
    SceneCheckOptions options;
    SceneCheck check;
    SceneLayers layers;
    Image<Rgb> rendered{SmallPicture::kSize};

    explicit CheckedPicture(void (*doctor)(SmallPicture&) = [](SmallPicture&) {})
        : options{.kinds = true},
          check(picture.faces, picture.geometry, SmallPicture::kSize, options),
          layers(picture.faces, picture.geometry, SmallPicture::kSize) {
        doctor(picture);
        for (const ScanBand& band : picture.bands) {
            layers.take(band);
            check.take(band);
        }
        check.finish();
    }
    CheckedScene scene() const { return {picture.faces, check, check.summary(), options, layers, rendered}; }
};

Page page_of_small_picture(const CheckSummary& summary) {
    Page page;
    page.kind = "scene";
    page.summary = summary_json(summary);
    return page;
}

}  // namespace

TEST_CASE("write_scene_report: every file is there, pictures of the right size", "[report]") {
    const CheckedPicture checked;
    const auto folder = std::filesystem::temp_directory_path() / "keikan-report-test" / "deep";
    std::filesystem::remove_all(folder.parent_path());
    make_report_folder(folder);
    write_scene_report(folder, page_of_small_picture(checked.check.summary()), checked.scene());
    CHECK(read_png(folder / "picture.png").size() == SmallPicture::kSize);
    CHECK(read_png(folder / "flags.png").size() == SmallPicture::kSize);
    CHECK(read_png(folder / "error.png").width() == SmallPicture::kSize.width);
    for (const char* name : {"error_legend.txt", "summary.json", "junit.xml", "index.html"})
        CHECK(std::filesystem::file_size(folder / name) > 100);
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++files;
    CHECK(files == 7);  // nothing half-written is left
    std::filesystem::remove_all(folder.parent_path());
}

TEST_CASE("pixels_to_show: a planted fault is among them, with what the scan claims", "[report][planted]") {
    constexpr PixelIndex kOnWire{3, 0};
    const CheckedPicture checked([](SmallPicture& picture) {
        picture.part({3, 0}, SmallPicture::Wire).weight += 1e-9;
    });
    const std::vector<PixelToShow> pixels = pixels_to_show(checked.scene());
    const auto wrong =
        std::ranges::find_if(pixels, [&](const PixelToShow& p) { return p.asked.pixel == kOnWire; });
    REQUIRE(wrong != pixels.end());
    CHECK(wrong->reasons.front() == Reason::Disagrees);
    CHECK_FALSE(wrong->disagreements.empty());
    CHECK(wrong->error == Approx(1e-9).epsilon(1e-3));
    REQUIRE(wrong->claims.size() == 2);
    CHECK(wrong->claims[0].by == "scan");
    const auto area = [&](std::size_t claim) {
        const auto face = std::ranges::find(wrong->faces, FaceId{SmallPicture::Wire}) - wrong->faces.begin();
        return wrong->claims[claim].claim.areas[static_cast<std::size_t>(face)];
    };
    CHECK(area(0) - area(1) == Approx(1e-9).epsilon(1e-6));
    // By rows, each once.
    CHECK(std::ranges::is_sorted(pixels, {},
                                 [](const PixelToShow& p) { return 8 * p.asked.pixel.y + p.asked.pixel.x; }));
}

TEST_CASE("SceneCheck: faces of each pixel add up to the summary, and the roofs go through each other",
          "[report][crosscheck]") {
    const CheckedPicture checked;
    std::uint64_t sum = 0;
    for (const std::uint16_t n : checked.check.faces().values()) sum += n;
    CHECK(sum == checked.check.summary().polygons);
    CHECK((checked.check.kinds()[{5, 3}] & bit_of(PixelKind::Interpenetration)) != 0);
    CHECK((checked.check.kinds()[{3, 0}] & bit_of(PixelKind::Interpenetration)) == 0);
}

TEST_CASE("html_of: the same bytes for any number of threads", "[report]") {
    const CheckedPicture checked;
    const auto html = [&](int threads) {
        const ThreadLimit limit(threads);
        Page page = page_of_small_picture(checked.check.summary());
        page.pixels = pixels_to_show(checked.scene());
        page.picture = checked.layers.json(checked.rendered, checked.check);
        return html_of(page);
    };
    CHECK(html(1) == html(4));
}

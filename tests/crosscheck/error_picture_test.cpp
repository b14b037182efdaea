// SPDX-License-Identifier: GPL-3.0-or-later
#include "crosscheck/error_picture.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "crosscheck/report.hpp"
#include "keikan/image/png_file.hpp"
#include "keikan/support/input_error.hpp"
#include "small_picture.hpp"

using namespace keikan;
using namespace keikan::crosscheck;

TEST_CASE("error_picture: brighter means more, black means none, red means wrong", "[crosscheck][report]") {
    Image<float> errors({60, 1});
    Image<std::uint8_t> wrong(errors.size());
    errors[{1, 0}] = 1e-18f;
    errors[{2, 0}] = 1e-15f;
    errors[{3, 0}] = 1e-12f;
    errors[{4, 0}] = 1e-12f;
    wrong[{4, 0}] = 1;
    const Image<Rgb> picture = error_picture(errors, wrong, scale_for(errors));
    CHECK(picture[{0, 0}] == Rgb{0, 0, 0});
    CHECK(picture[{1, 0}].g < picture[{2, 0}].g);
    CHECK(picture[{2, 0}].g < picture[{3, 0}].g);
    CHECK(picture[{4, 0}] == Rgb{1, 0, 0});
    CHECK(picture.height() > errors.height());  // the scale
}

TEST_CASE("scale_for: reaches to the largest error, at least to 1e-12", "[crosscheck][report]") {
    Image<float> errors({2, 1});
    CHECK(scale_for(errors).highest == -12);
    errors[{1, 0}] = 0.25f;
    CHECK(scale_for(errors).highest == 0);
    CHECK_THAT(error_legend({-18, -12}), Catch::Contains("1e-18") && Catch::Contains("1e-12"));
}

TEST_CASE("write_report: every file is there, pictures of the right size", "[crosscheck][report]") {
    const SmallPicture picture;
    SceneCheck check(picture.faces, picture.geometry, SmallPicture::kSize, {});
    for (const ScanBand& band : picture.bands) check.take(band);
    const auto folder = std::filesystem::temp_directory_path() / "keikan-report-test" / "deep";
    std::filesystem::remove_all(folder.parent_path());
    make_report_folder(folder);
    write_report(folder, Image<Rgb>(SmallPicture::kSize), check, "{}");
    CHECK(read_png(folder / "picture.png").size() == SmallPicture::kSize);
    CHECK(read_png(folder / "flags.png").size() == SmallPicture::kSize);
    CHECK(read_png(folder / "error.png").width() == SmallPicture::kSize.width);
    CHECK(std::filesystem::file_size(folder / "error_legend.txt") > 100);
    CHECK(std::filesystem::file_size(folder / "summary.json") == 3);
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++files;
    CHECK(files == 5);  // nothing half-written is left
    CHECK_THROWS_AS(make_report_folder(folder / "summary.json"), InputError);
    std::filesystem::remove_all(folder.parent_path());
}

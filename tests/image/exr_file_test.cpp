// SPDX-License-Identifier: Apache-2.0
#include "keikan/image/exr_file.hpp"

#include <catch2/catch.hpp>

#include "../support/file_contents.hpp"
#include "../support/scratch_folder.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"

using namespace keikan;

namespace {

ExrPicture example() {
    Image<Rgb> colours({33, 17});
    Image<float> depth({33, 17});
    float value = 0;
    for (Rgb& colour : colours.values()) colour = {value += 0.001f, -3 * value, 1e30f * value};
    for (float& d : depth.values()) d = 1 / (value += 0.7f);
    ExrPicture picture = exr_picture(colours);
    picture.channels.emplace("depth", depth);
    picture.channels.emplace("coverage.tower-3", depth);
    picture.metadata = {{"filter", "box, one pixel"}, {"scene", "ridge_line.json"}};
    return picture;
}

}  // namespace

TEST_CASE("write_exr: every channel and every text comes back, bit for bit", "[image][exr]") {
    const ScratchFolder folder("exr");
    const ExrPicture picture = example();
    write_exr(folder / "a.exr", picture);
    const ExrPicture back = read_exr(folder / "a.exr");
    CHECK(back == picture);
    CHECK(exr_picture(rgb_image(back)).channels.at("G") == picture.channels.at("G"));
    write_exr(folder / "b.exr", back);
    CHECK(contents(folder / "a.exr") == contents(folder / "b.exr"));
}

TEST_CASE("write_exr: what cannot be written leaves nothing", "[image][exr]") {
    const ScratchFolder folder("exr");
    CHECK_THROWS_AS(write_exr(folder / "missing/a.exr", example()), InputError);
    ExrPicture wrong = example();
    wrong.channels["odd"] = Image<float>({2, 2});
    CHECK_THROWS_AS(write_exr(folder / "a.exr", wrong), CheckFailure);
    CHECK(folder.files() == 0);
}

TEST_CASE("read_exr: what is no such file is refused with the file's name", "[image][exr]") {
    const ScratchFolder folder("exr");
    const auto refused = [](const std::filesystem::path& file) {
        CHECK_THROWS_AS(read_exr(file), InputError);
        CHECK_THROWS_WITH(read_exr(file), Catch::StartsWith(file.string() + ": cannot be read: "));
    };
    refused(folder / "missing.exr");
    write_whole_file(folder / "text.exr", "this is no picture");
    refused(folder / "text.exr");
    write_exr(folder / "whole.exr", example());
    const std::string whole = contents(folder / "whole.exr");
    for (const std::size_t length : {whole.size() - 30, whole.size() / 2, std::size_t{100}}) {
        write_whole_file(folder / "cut.exr", whole.substr(0, length));
        refused(folder / "cut.exr");
    }
}

// SPDX-License-Identifier: Apache-2.0
#include "keikan/image/png_file.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "../support/file_contents.hpp"
#include "../support/scratch_folder.hpp"
#include "keikan/image/srgb.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"

using namespace keikan;

namespace {

/// Colours without pattern, some of them outside of [0, 1].
Image<Rgb> speckles(ImageSize size) {
    Image<Rgb> image(size);
    std::uint32_t state = 1;
    const auto next = [&] {
        return static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / 1.6e7f;
    };
    for (Rgb& colour : image.values()) colour = {next(), next(), 1.1f * next() - 0.05f};
    return image;
}

}  // namespace

TEST_CASE("write_png: reading gives the colour of each code, and writing that the same bytes",
          "[image][png]") {
    const ScratchFolder folder("png");
    const Image<Rgb> image = speckles({37, 21});
    for (const PngBits bits : {PngBits::Eight, PngBits::Sixteen}) {
        write_png(folder / "a.png", image, bits);
        const Image<Rgb> back = read_png(folder / "a.png");
        REQUIRE(back.size() == image.size());
        const SrgbCodes& codes = SrgbCodes::of_bits(static_cast<int>(bits));
        int wrong = 0;
        for (std::size_t i = 0; i < image.values().size(); ++i) {
            const Rgb p = image.values()[i], q = back.values()[i];
            wrong += codes(p.r) != codes(q.r) || codes(p.g) != codes(q.g) || codes(p.b) != codes(q.b);
        }
        CHECK(wrong == 0);
        write_png(folder / "b.png", back, bits);
        CHECK(contents(folder / "a.png") == contents(folder / "b.png"));
    }
}

TEST_CASE("write_png: half of linear light is sRGB code 188", "[image][png]") {
    const ScratchFolder folder("png");
    write_png(folder / "grey.png", Image<Rgb>({1, 1}, Rgb{0.5f, 0.5f, 0.5f}));
    const Rgb back = read_png(folder / "grey.png")[{0, 0}];
    CHECK(back.r == static_cast<float>(linear_from_srgb(188 / 255.0)));
}

TEST_CASE("write_png: the bytes do not depend on the number of threads", "[image][png]") {
    const ScratchFolder folder("png");
    const Image<Rgb> image = speckles({64, 200});  // more rows than are compressed in one piece
    std::string first;
    for (const int threads : {1, 2, 8}) {
        const ThreadLimit limit(threads);
        write_png(folder / "a.png", image);
        const std::string bytes = contents(folder / "a.png");
        if (first.empty()) first = bytes;
        CHECK(bytes == first);
    }
    write_png(folder / "b.png", read_png(folder / "a.png"));
    CHECK(contents(folder / "b.png") == first);
}

TEST_CASE("write_png: pictures of one pixel, one row and one column", "[image][png][degenerate]") {
    const ScratchFolder folder("png");
    for (const ImageSize size : {ImageSize{1, 1}, ImageSize{300, 1}, ImageSize{1, 300}}) {
        write_png(folder / "a.png", speckles(size));
        CHECK(read_png(folder / "a.png").size() == size);
    }
    CHECK_THROWS_AS(write_png(folder / "none.png", Image<Rgb>()), CheckFailure);
    CHECK(folder.files() == 1);
}

TEST_CASE("write_png: a colour that is not a number is our mistake, and leaves no file", "[image][png]") {
    const ScratchFolder folder("png");
    const Image<Rgb> image({2, 2}, Rgb{0, std::numeric_limits<float>::quiet_NaN(), 0});
    CHECK_THROWS_AS(write_png(folder / "nan.png", image), CheckFailure);
    CHECK(folder.files() == 0);
}

TEST_CASE("read_png_grey16: the values come back as they were written", "[image][png]") {
    const ScratchFolder folder("png");
    Image<std::uint16_t> grid({5, 3});
    for (std::size_t i = 0; i < grid.values().size(); ++i)
        grid.values()[i] = static_cast<std::uint16_t>(4369 * i);
    write_png_grey16(folder / "grid.png", grid);
    CHECK(read_png_grey16(folder / "grid.png") == grid);
}

TEST_CASE("read_png: what is no such picture is refused with the file's name", "[image][png]") {
    const ScratchFolder folder("png");
    const auto refused = [](const std::filesystem::path& file, const std::string& part) {
        CHECK_THROWS_AS(read_png(file), InputError);
        CHECK_THROWS_WITH(read_png_grey16(file), Catch::StartsWith(file.string()) && Catch::Contains(part));
    };
    refused(folder / "missing.png", "No such file");
    write_whole_file(folder / "text.png", "this is no picture");
    refused(folder / "text.png", "Not a PNG");
    write_whole_file(folder / "empty.png", "");
    refused(folder / "empty.png", "cannot be read");

    write_png(folder / "colour.png", speckles({9, 9}));
    CHECK_THROWS_WITH(read_png_grey16(folder / "colour.png"),
                      Catch::Contains("is not a grey PNG of 16 bits"));
    const std::string whole = contents(folder / "colour.png");
    for (const std::size_t length : {whole.size() - 14, whole.size() / 2, std::size_t{20}}) {
        write_whole_file(folder / "cut.png", whole.substr(0, length));
        CHECK_THROWS_AS(read_png(folder / "cut.png"), InputError);
    }
    std::string broken = whole;
    broken[broken.size() / 2] = static_cast<char>(broken[broken.size() / 2] ^ 0x40);
    write_whole_file(folder / "broken.png", broken);
    CHECK_THROWS_AS(read_png(folder / "broken.png"), InputError);
}

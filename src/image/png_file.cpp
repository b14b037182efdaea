// SPDX-License-Identifier: Apache-2.0
#include "keikan/image/png_file.hpp"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "keikan/image/srgb.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"

namespace keikan {

namespace fs = std::filesystem;

namespace {

// libpng reports an error by a long jump. So the functions that call it hold nothing with a destructor:
// what they fill belongs to their caller, and they answer whether they came to the end.

struct Trouble {
    char text[200] = "";
};

void keep_message(png_structp png, png_const_charp message) {
    auto* const trouble = static_cast<Trouble*>(png_get_error_ptr(png));
    std::snprintf(trouble->text, sizeof trouble->text, "%s", message);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

// ---------------------------------------------------------------- writing

struct PngWriter {
    Trouble trouble;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &trouble, keep_message, ignore_warning);
    png_infop info = png_create_info_struct(png);
    ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

void append(png_structp png, png_bytep bytes, png_size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

/// Filter and level were chosen by measuring: on pictures of landscapes, differences to the left pixel and
/// zlib's level 1 take a third of the time of the defaults for a tenth more bytes.
bool write_rows(PngWriter& writer, std::string& out, ImageSize size, int bits, int colour_type,
                const std::function<const png_byte*(int)>& row) {
    const png_structp png = writer.png;
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_write_fn(png, &out, append, nullptr);
    png_set_compression_level(png, 1);
    png_set_compression_strategy(png, Z_FILTERED);
    png_set_compression_buffer_size(png, 1 << 18);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_IHDR(png, writer.info, static_cast<png_uint_32>(size.width), static_cast<png_uint_32>(size.height), bits,
                 colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (colour_type == PNG_COLOR_TYPE_RGB) png_set_sRGB(png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, writer.info);
    if (bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
    for (int y = 0; y < size.height; ++y) png_write_row(png, row(y));
    png_write_end(png, writer.info);
    return true;
}

void write_file(const fs::path& file, ImageSize size, int bits, int colour_type,
                const std::function<const png_byte*(int)>& row) {
    AtomicFile out(file);
    PngWriter writer;
    std::string bytes;
    if (!write_rows(writer, bytes, size, bits, colour_type, row))
        throw InputError(file.string(), "", std::string("cannot be written: ") + writer.trouble.text);
    out.write(bytes);
    out.finish();
}

template <typename Code>
void encode_row(std::span<const Rgb> colours, const SrgbCodes& codes, Code* out) {
    bool all_numbers = true;
    for (const Rgb& colour : colours) {
        all_numbers &= colour.r == colour.r && colour.g == colour.g && colour.b == colour.b;
        *out++ = static_cast<Code>(codes(colour.r));
        *out++ = static_cast<Code>(codes(colour.g));
        *out++ = static_cast<Code>(codes(colour.b));
    }
    KEIKAN_CHECK(all_numbers, "a colour is not a number");
}

template <typename Code>
void write_codes(const fs::path& file, const Image<Rgb>& linear) {
    constexpr int kBits = 8 * sizeof(Code);
    const SrgbCodes& codes = SrgbCodes::of_bits(kBits);
    const std::size_t values = 3 * static_cast<std::size_t>(linear.width());
    std::vector<Code> picture(values * static_cast<std::size_t>(linear.height()));
    const auto row = [&](int y) { return picture.data() + values * static_cast<std::size_t>(y); };
    parallel_for(static_cast<std::size_t>(linear.height()), [&](std::size_t y) {
        encode_row(linear.row(static_cast<int>(y)), codes, row(static_cast<int>(y)));
    });
    write_file(file, linear.size(), kBits, PNG_COLOR_TYPE_RGB,
               [&](int y) { return reinterpret_cast<const png_byte*>(row(y)); });
}

// ---------------------------------------------------------------- reading

struct PngReader {
    Trouble trouble;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &trouble, keep_message, ignore_warning);
    png_infop info = png_create_info_struct(png);
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

bool read_header(PngReader& reader, std::FILE* in) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_init_io(reader.png, in);
    png_read_info(reader.png, reader.info);
    return true;
}

/// Asks for three channels of 16 bits in the machine's order, whatever the file holds.
bool expand_to_rgb16(PngReader& reader) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_set_expand_16(reader.png);
    png_set_gray_to_rgb(reader.png);
    png_set_strip_alpha(reader.png);
    return true;
}

bool read_rows(PngReader& reader, png_bytepp rows) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    if (std::endian::native == std::endian::little) png_set_swap(reader.png);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    png_read_image(reader.png, rows);
    png_read_end(reader.png, nullptr);
    return true;
}

/// A PNG file that has been opened: its header is read, its pixels are not.
class OpenPng {
  public:
    explicit OpenPng(const fs::path& file) : name_(file.string()), in_(std::fopen(file.c_str(), "rb"), std::fclose) {
        if (!in_) throw InputError(name_, "", std::string("cannot be read: ") + std::strerror(errno));
        require(read_header(reader_, in_.get()));
        const std::uint64_t pixels =
            std::uint64_t{png_get_image_width(png(), info())} * png_get_image_height(png(), info());
        if (pixels > kMaxPngPixels) throw InputError(name_, "", "holds " + std::to_string(pixels) + " pixels");
    }

    png_structp png() { return reader_.png; }
    png_infop info() { return reader_.info; }
    PngReader& reader() { return reader_; }
    ImageSize size() {
        return {static_cast<int>(png_get_image_width(png(), info())),
                static_cast<int>(png_get_image_height(png(), info()))};
    }

    void require(bool came_to_the_end) const {
        if (!came_to_the_end) throw InputError(name_, "", std::string("cannot be read: ") + reader_.trouble.text);
    }

    /// The pixels as `channels` values of 16 bits each.
    std::vector<std::uint16_t> values(int channels) {
        const std::size_t stride = static_cast<std::size_t>(size().width) * static_cast<std::size_t>(channels);
        std::vector<std::uint16_t> all(stride * static_cast<std::size_t>(size().height));
        std::vector<png_bytep> rows;
        for (std::size_t at = 0; at < all.size(); at += stride)
            rows.push_back(reinterpret_cast<png_bytep>(all.data() + at));
        require(read_rows(reader_, rows.data()));
        return all;
    }

  private:
    std::string name_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> in_;
    PngReader reader_;
};

}  // namespace

void write_png(const fs::path& file, const Image<Rgb>& linear, PngBits bits) {
    if (bits == PngBits::Eight) return write_codes<std::uint8_t>(file, linear);
    write_codes<std::uint16_t>(file, linear);
}

void write_png_grey16(const fs::path& file, const Image<std::uint16_t>& values) {
    write_file(file, values.size(), 16, PNG_COLOR_TYPE_GRAY,
               [&](int y) { return reinterpret_cast<const png_byte*>(values.row(y).data()); });
}

Image<Rgb> read_png(const fs::path& file) {
    OpenPng in(file);
    in.require(expand_to_rgb16(in.reader()));
    const std::vector<std::uint16_t> values = in.values(3);
    std::vector<float> linear(1 << 16);
    for (std::size_t code = 0; code < linear.size(); ++code)
        linear[code] = static_cast<float>(linear_from_srgb(static_cast<double>(code) / 65535));
    Image<Rgb> image(in.size());
    for (std::size_t i = 0; i < image.values().size(); ++i)
        image.values()[i] = {linear[values[3 * i]], linear[values[3 * i + 1]], linear[values[3 * i + 2]]};
    return image;
}

Image<std::uint16_t> read_png_grey16(const fs::path& file) {
    OpenPng in(file);
    const int bits = png_get_bit_depth(in.png(), in.info());
    if (png_get_color_type(in.png(), in.info()) != PNG_COLOR_TYPE_GRAY || bits != 16)
        throw InputError(file.string(), "", "is not a grey PNG of 16 bits");
    const std::vector<std::uint16_t> values = in.values(1);
    Image<std::uint16_t> image(in.size());
    std::copy(values.begin(), values.end(), image.values().begin());
    return image;
}

}  // namespace keikan

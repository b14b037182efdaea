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

/// What kind of picture it is, and its rows as PNG wants them: `fill_row` puts the bytes of row y, each value
/// with its high byte first.
struct PngContent {
    ImageSize size;
    int bits = 8;
    int colour_type = PNG_COLOR_TYPE_RGB;
    std::function<void(int y, png_byte* out)> fill_row;

    std::size_t pixel_bytes() const {
        return static_cast<std::size_t>(bits / 8) * (colour_type == PNG_COLOR_TYPE_RGB ? 3 : 1);
    }
    std::size_t row_bytes() const { return pixel_bytes() * static_cast<std::size_t>(size.width); }
};

/// Some rows, compressed: a piece of the zlib stream that can be put behind the piece before it.
struct PngPiece {
    std::string deflated;
    uLong check = 0;  ///< Adler-32 of what was compressed
    uLong length = 0;
};

/// Rows of a piece. A constant, so that the file does not depend on the number of threads; the pieces of a
/// picture of 1000 x 650 pixels are a tenth of a per cent longer than one stream.
constexpr int kPieceRows = 64;

/// Differences to the left pixel (filter 1), which is where landscapes are smoothest for its price.
std::vector<png_byte> filtered_rows(const PngContent& content, int first, int end) {
    const std::size_t stride = content.row_bytes(), left = content.pixel_bytes();
    std::vector<png_byte> bytes((stride + 1) * static_cast<std::size_t>(end - first));
    std::vector<png_byte> row(stride);
    png_byte* out = bytes.data();
    for (int y = first; y < end; ++y, out += stride) {
        content.fill_row(y, row.data());
        *out++ = PNG_FILTER_VALUE_SUB;
        std::copy_n(row.begin(), left, out);
        for (std::size_t i = left; i < stride; ++i) out[i] = static_cast<png_byte>(row[i] - row[i - left]);
    }
    return bytes;
}

/// zlib's level 1 takes a third of the time of the default for a tenth more bytes.
PngPiece deflated(const std::vector<png_byte>& bytes, bool last) {
    z_stream stream{};
    KEIKAN_CHECK(deflateInit2(&stream, 1, Z_DEFLATED, -15, 9, Z_FILTERED) == Z_OK, "zlib cannot begin");
    PngPiece piece;
    piece.length = static_cast<uLong>(bytes.size());
    piece.check = adler32(adler32(0, nullptr, 0), bytes.data(), static_cast<uInt>(bytes.size()));
    // A flush, which ends every piece but the last on a byte, takes up to 11 bytes beyond the bound.
    piece.deflated.resize(deflateBound(&stream, piece.length) + 16);
    stream.next_in = const_cast<png_bytep>(bytes.data());  // zlib does not write there
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<png_bytep>(piece.deflated.data());
    stream.avail_out = static_cast<uInt>(piece.deflated.size());
    const int result = deflate(&stream, last ? Z_FINISH : Z_SYNC_FLUSH);
    const bool complete =
        result == (last ? Z_STREAM_END : Z_OK) && stream.avail_in == 0 && stream.avail_out > 0;
    piece.deflated.resize(stream.total_out);
    deflateEnd(&stream);
    KEIKAN_CHECK(complete, "zlib answers " << result);
    return piece;
}

/// All rows as one zlib stream, compressed side by side.
std::string zlib_stream(const PngContent& content) {
    std::vector<PngPiece> pieces(
        static_cast<std::size_t>((content.size.height + kPieceRows - 1) / kPieceRows));
    parallel_for(pieces.size(), [&](std::size_t i) {
        const int first = static_cast<int>(i) * kPieceRows,
                  end = std::min(first + kPieceRows, content.size.height);
        pieces[i] = deflated(filtered_rows(content, first, end), i + 1 == pieces.size());
    });
    std::string stream("\x78\x01", 2);  // deflate, window of 32 KiB, fastest level
    uLong check = adler32(0, nullptr, 0);
    for (const PngPiece& piece : pieces) {
        stream += piece.deflated;
        check = adler32_combine(check, piece.check, static_cast<z_off_t>(piece.length));
    }
    for (const int shift : {24, 16, 8, 0}) stream += static_cast<char>((check >> shift) & 0xFF);
    return stream;
}

constexpr png_byte kIdat[] = "IDAT", kIend[] = "IEND";
constexpr std::size_t kLongestChunk = 1u << 30;

bool write_chunks(PngWriter& writer, std::string& out, const PngContent& content, const std::string& stream) {
    const png_structp png = writer.png;
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_write_fn(png, &out, append, nullptr);
    png_set_IHDR(png, writer.info, static_cast<png_uint_32>(content.size.width),
                 static_cast<png_uint_32>(content.size.height), content.bits, content.colour_type,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (content.colour_type == PNG_COLOR_TYPE_RGB) png_set_sRGB(png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, writer.info);
    for (std::size_t at = 0; at < stream.size(); at += kLongestChunk)
        png_write_chunk(png, kIdat, reinterpret_cast<png_const_bytep>(stream.data() + at),
                        std::min(kLongestChunk, stream.size() - at));
    png_write_chunk(png, kIend, nullptr, 0);
    return true;
}

void write_file(const fs::path& file, const PngContent& content) {
    KEIKAN_CHECK(content.size.width > 0 && content.size.height > 0, "a PNG needs a pixel");
    AtomicFile out(file);
    PngWriter writer;
    std::string bytes;
    if (!write_chunks(writer, bytes, content, zlib_stream(content)))
        throw InputError(file.string(), "", std::string("cannot be written: ") + writer.trouble.text);
    out.write(bytes);
    out.finish();
}

/// One value, its high byte first.
png_byte* put(std::uint16_t value, png_byte* out) {
    *out++ = static_cast<png_byte>(value >> 8);
    *out++ = static_cast<png_byte>(value & 0xFF);
    return out;
}

/// The codes of a row, each put by `put_code(value, out)`, which returns the place behind it.
template <typename PutCode>
void encode_row(std::span<const Rgb> colours, png_byte* out, const PutCode& put_code) {
    bool all_numbers = true;
    for (const Rgb& colour : colours) {
        all_numbers &= colour.r == colour.r && colour.g == colour.g && colour.b == colour.b;
        out = put_code(colour.r, out);
        out = put_code(colour.g, out);
        out = put_code(colour.b, out);
    }
    KEIKAN_CHECK(all_numbers, "a colour is not a number");
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
    explicit OpenPng(const fs::path& file)
        : name_(file.string()), in_(std::fopen(file.c_str(), "rb"), std::fclose) {
        if (!in_) throw InputError(name_, "", std::string("cannot be read: ") + std::strerror(errno));
        require(read_header(reader_, in_.get()));
        const std::uint64_t pixels =
            std::uint64_t{png_get_image_width(png(), info())} * png_get_image_height(png(), info());
        if (pixels > kMaxPngPixels)
            throw InputError(name_, "", "holds " + std::to_string(pixels) + " pixels");
    }

    png_structp png() { return reader_.png; }
    png_infop info() { return reader_.info; }
    PngReader& reader() { return reader_; }
    ImageSize size() {
        return {static_cast<int>(png_get_image_width(png(), info())),
                static_cast<int>(png_get_image_height(png(), info()))};
    }

    void require(bool came_to_the_end) const {
        if (!came_to_the_end)
            throw InputError(name_, "", std::string("cannot be read: ") + reader_.trouble.text);
    }

    /// The pixels as `channels` values of 16 bits each.
    std::vector<std::uint16_t> values(int channels) {
        const std::size_t stride =
            static_cast<std::size_t>(size().width) * static_cast<std::size_t>(channels);
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
    const SrgbCodes& codes = SrgbCodes::of_bits(static_cast<int>(bits));
    PngContent content{linear.size(), static_cast<int>(bits), PNG_COLOR_TYPE_RGB, {}};
    if (bits == PngBits::Eight) {
        content.fill_row = [&](int y, png_byte* row) {
            encode_row(linear.row(y), row,
                       [&](float x, png_byte* out) { return *out = codes.eight(x), out + 1; });
        };
    } else {
        content.fill_row = [&](int y, png_byte* row) {
            encode_row(linear.row(y), row, [&](float x, png_byte* out) { return put(codes(x), out); });
        };
    }
    write_file(file, content);
}

void write_png_grey16(const fs::path& file, const Image<std::uint16_t>& values) {
    write_file(file, {values.size(), 16, PNG_COLOR_TYPE_GRAY, [&](int y, png_byte* out) {
                          for (const std::uint16_t value : values.row(y)) out = put(value, out);
                      }});
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

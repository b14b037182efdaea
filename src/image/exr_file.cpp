// SPDX-License-Identifier: Apache-2.0
#include "keikan/image/exr_file.hpp"

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "keikan/support/atomic_file.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {

namespace {

constexpr std::int64_t kMaxPixels = 1 << 28;
constexpr std::size_t kLongestName = 255;  ///< of a channel

/// The file as OpenEXR writes it, going back to fill in its table of offsets.
class Memory : public Imf::OStream {
  public:
    explicit Memory(const char* name) : Imf::OStream(name) {}
    void write(const char from[], int n) override {
        const auto count = static_cast<std::size_t>(n);
        bytes_.resize(std::max(bytes_.size(), at_ + count));
        std::memcpy(bytes_.data() + at_, from, count);
        at_ += count;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t at) override { at_ = at; }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
    std::size_t at_ = 0;
};

/// A view of one channel for OpenEXR, which writes to it only when it reads a file. `first` is the pixel at
/// the data window's corner `min`.
Imf::Slice slice_of(const Image<float>& image, const Imath::V2i& min) {
    auto* const first = const_cast<float*>(image.values().data());  // Slice has no const form
    return Imf::Slice::Make(Imf::FLOAT, first, min, image.width(), image.height(), sizeof(float),
                            sizeof(float) * static_cast<std::size_t>(image.width()));
}

/// Rows that OpenEXR compresses together (ZIP_COMPRESSION).
constexpr int kRowsAtOnce = 16;

Imf::Header header_of(const ExrRows& rows) {
    Imf::Header header(rows.size.width, rows.size.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const std::string& name : rows.channels) {
        if (name.empty() || name.size() > kLongestName)
            throw Iex::ArgExc("channel \"" + name + "\": a name has 1 to 255 bytes");
        if (header.channels().findChannel(name)) throw Iex::ArgExc("channel \"" + name + "\" comes twice");
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    }
    for (const auto& [name, value] : rows.metadata) header.insert(name, Imf::StringAttribute(value));
    return header;
}

void write_rows(const ExrRows& rows, Imf::OStream& out) {
    const auto width = static_cast<std::size_t>(rows.size.width);
    Imf::OutputFile exr(out, header_of(rows), 0);  // no threads of OpenEXR's own
    std::vector<Image<float>> block(rows.channels.size(), Image<float>({rows.size.width, kRowsAtOnce}));
    std::vector<std::span<float>> row(block.size());
    for (int first = 0; first < rows.size.height; first += kRowsAtOnce) {
        const int count = std::min(kRowsAtOnce, rows.size.height - first);
        for (int y = 0; y < count; ++y) {
            for (std::size_t c = 0; c < block.size(); ++c)
                row[c] = std::span(block[c].values()).subspan(static_cast<std::size_t>(y) * width, width);
            rows.fill_row(first + y, row);
        }
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < block.size(); ++c)
            frame.insert(rows.channels[c], slice_of(block[c], {0, first}));
        exr.setFrameBuffer(frame);
        exr.writePixels(count);
    }
}

std::string reason_of(const std::exception& error) {
    std::string text = error.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

ExrPicture read_channels(Imf::InputFile& in, const std::string& name) {
    const Imath::Box2i window = in.header().dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width <= 0 || height <= 0 || width > kMaxPixels / height)
        throw InputError(name, "",
                         "holds " + std::to_string(width) + " x " + std::to_string(height) + " pixels");
    ExrPicture picture{{static_cast<int>(width), static_cast<int>(height)}, {}, {}};
    Imf::FrameBuffer frame;
    const Imf::ChannelList& channels = in.header().channels();
    for (auto c = channels.begin(); c != channels.end(); ++c) {
        if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
            throw InputError(name, "", std::string("channel ") + c.name() + " is sampled coarsely");
        const auto& image = picture.channels.emplace(c.name(), Image<float>(picture.size)).first->second;
        frame.insert(c.name(), slice_of(image, window.min));
    }
    for (auto a = in.header().begin(); a != in.header().end(); ++a)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
            picture.metadata.emplace(a.name(), text->value());
    in.setFrameBuffer(frame);
    in.readPixels(window.min.y, window.max.y);
    return picture;
}

}  // namespace

ExrPicture exr_picture(const Image<Rgb>& linear) {
    Image<float> r(linear.size()), g(linear.size()), b(linear.size());
    for (std::size_t i = 0; i < linear.values().size(); ++i) {
        const Rgb colour = linear.values()[i];
        r.values()[i] = colour.r;
        g.values()[i] = colour.g;
        b.values()[i] = colour.b;
    }
    ExrPicture picture{linear.size(), {}, {}};
    picture.channels.emplace("R", std::move(r));
    picture.channels.emplace("G", std::move(g));
    picture.channels.emplace("B", std::move(b));
    return picture;
}

Image<Rgb> rgb_image(const ExrPicture& picture) {
    for (const char* name : {"R", "G", "B"})
        KEIKAN_CHECK(picture.channels.contains(name), "the picture has no channel " << name);
    const auto &r = picture.channels.at("R"), &g = picture.channels.at("G"), &b = picture.channels.at("B");
    Image<Rgb> image(picture.size);
    for (std::size_t i = 0; i < image.values().size(); ++i)
        image.values()[i] = {r.values()[i], g.values()[i], b.values()[i]};
    return image;
}

void write_exr(const std::filesystem::path& file, const ExrPicture& picture) {
    ExrRows rows{picture.size, {}, picture.metadata, {}};
    std::vector<const Image<float>*> images;
    for (const auto& [name, image] : picture.channels) {
        KEIKAN_CHECK(image.size() == picture.size, "channel " << name << " has another size");
        rows.channels.push_back(name);
        images.push_back(&image);
    }
    rows.fill_row = [&](int y, std::span<const std::span<float>> channels) {
        for (std::size_t c = 0; c < channels.size(); ++c)
            std::ranges::copy(images[c]->row(y), channels[c].begin());
    };
    write_exr(file, rows);
}

void write_exr(const std::filesystem::path& file, const ExrRows& rows) {
    AtomicFile out(file);
    Memory memory(file.c_str());
    try {
        write_rows(rows, memory);
    } catch (const Iex::BaseExc& error) {
        throw InputError(file.string(), "", "cannot be written: " + reason_of(error));
    }
    out.write(memory.bytes());
    out.finish();
}

ExrPicture read_exr(const std::filesystem::path& file) {
    try {
        Imf::InputFile in(file.c_str(), 0);
        return read_channels(in, file.string());
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(file.string(), "", "cannot be read: " + reason_of(error));
    }
}

}  // namespace keikan

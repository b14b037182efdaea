// SPDX-License-Identifier: Apache-2.0
#include "keikan/image/exr_file.hpp"

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
    AtomicFile out(file);
    Imf::Header header(picture.size.width, picture.size.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    for (const auto& [name, image] : picture.channels) {
        KEIKAN_CHECK(image.size() == picture.size, "channel " << name << " has another size");
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        frame.insert(name, slice_of(image, {0, 0}));
    }
    for (const auto& [name, value] : picture.metadata) header.insert(name, Imf::StringAttribute(value));
    Memory memory(file.c_str());
    try {
        Imf::OutputFile exr(memory, header, 0);  // no threads of OpenEXR's own
        exr.setFrameBuffer(frame);
        exr.writePixels(picture.size.height);
    } catch (const std::exception& error) {
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

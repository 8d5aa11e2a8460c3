#include "exr_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfTestFile.h>
#include <ImfThreading.h>

#include <cstring>
#include <stdexcept>

namespace tp {
namespace {

class MemoryInput final : public Imf::IStream {
public:
    explicit MemoryInput(std::string_view bytes) : Imf::IStream("memory"), bytes_(bytes) {}
    bool read(char* out, int count) override {
        if (count < 0 || position_ > bytes_.size() ||
            static_cast<size_t>(count) > bytes_.size() - position_)
            throw std::runtime_error("the file ends too early");
        std::memcpy(out, bytes_.data() + position_, static_cast<size_t>(count));
        position_ += static_cast<size_t>(count);
        return position_ < bytes_.size();
    }
    uint64_t tellg() override { return position_; }
    void seekg(uint64_t position) override { position_ = position; }

private:
    std::string_view bytes_;
    size_t position_ = 0;
};

class MemoryOutput final : public Imf::OStream {
public:
    MemoryOutput() : Imf::OStream("memory") {}
    void write(const char* bytes, int count) override {
        const auto size = static_cast<size_t>(count);
        if (bytes_.size() < position_ + size) bytes_.resize(position_ + size);
        std::memcpy(bytes_.data() + position_, bytes, size);
        position_ += size;
    }
    uint64_t tellp() override { return position_; }
    void seekp(uint64_t position) override { position_ = position; }
    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
    size_t position_ = 0;
};

// A slice whose first pixel is (0, 0) of the data window.
Imf::Slice slice_at(Imf::PixelType type, char* data, const Imath::Box2i& window, size_t x_stride,
                    size_t y_stride) {
    const auto x =
        static_cast<std::ptrdiff_t>(window.min.x) * static_cast<std::ptrdiff_t>(x_stride);
    const auto y =
        static_cast<std::ptrdiff_t>(window.min.y) * static_cast<std::ptrdiff_t>(y_stride);
    return {type, data - x - y, x_stride, y_stride};
}

bool is_id(const ImageLayer& layer) {
    return layer.channels.size() == 1 && layer.channels[0] == "id";
}

}  // namespace

bool is_exr(std::string_view bytes) {
    return bytes.size() >= 4 && std::memcmp(bytes.data(), "\x76\x2f\x31\x01", 4) == 0;
}

uint64_t bytes_of_exr(std::string_view bytes) {
    try {
        MemoryInput stream(bytes);
        const Imath::Box2i window = Imf::InputFile(stream).header().dataWindow();
        const double width = double{1} + window.max.x - window.min.x,
                     height = double{1} + window.max.y - window.min.y;
        return width > 0 && height > 0 && width * height < 1e15
                   ? static_cast<uint64_t>(width * height) * 16
                   : 0;
    } catch (const std::exception&) {
        return 0;
    }
}

Image read_exr(std::string_view bytes) {
    MemoryInput stream(bytes);
    Imf::InputFile file(stream);
    const Imath::Box2i window = file.header().dataWindow();
    const int64_t width = int64_t{window.max.x} - window.min.x + 1,
                  height = int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width > 65536 || height > 65536 ||
        width * height > (int64_t{1} << 28))
        throw std::runtime_error("the picture is too large");
    const Imf::ChannelList& channels = file.header().channels();
    std::vector<const char*> names;
    if (channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B"))
        names = {"R", "G", "B"};
    else if (channels.findChannel("Y"))
        names = {"Y"};
    else
        throw std::runtime_error("there are no channels R, G, B or Y");
    if (channels.findChannel("A")) names.push_back("A");

    Image image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.channels = static_cast<int>(names.size());
    image.format = PixelFormat::F32;
    image.bytes.resize(static_cast<size_t>(width * height) * names.size() * sizeof(float));
    const size_t x_stride = names.size() * sizeof(float),
                 y_stride = x_stride * static_cast<size_t>(width);
    Imf::FrameBuffer buffer;
    for (size_t i = 0; i < names.size(); ++i)
        buffer.insert(
            names[i],
            slice_at(Imf::FLOAT, reinterpret_cast<char*>(image.bytes.data()) + i * sizeof(float),
                     window, x_stride, y_stride));
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return image;
}

std::string write_exr(const Picture& picture) {
    Imf::Header header(picture.width, picture.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [key, value] : picture.metadata)
        header.insert(key, Imf::StringAttribute(value));

    // Ids are integers; their values are exact in float up to 2^24, so they get planes of their
    // own.
    std::vector<std::vector<uint32_t>> ids;
    ids.reserve(picture.linear.size());
    Imf::FrameBuffer buffer;
    const auto width = static_cast<size_t>(picture.width);
    for (const ImageLayer& layer : picture.linear) {
        for (size_t c = 0; c < layer.channels.size(); ++c) {
            const std::string name =
                layer.name.empty() ? layer.channels[c] : layer.name + "." + layer.channels[c];
            const Imf::PixelType type = is_id(layer) ? Imf::UINT : Imf::FLOAT;
            header.channels().insert(name, Imf::Channel(type));
            if (is_id(layer)) {
                ids.emplace_back(layer.values.begin(), layer.values.end());
                buffer.insert(name, Imf::Slice(type, reinterpret_cast<char*>(ids.back().data()), 4,
                                               4 * width));
                continue;
            }
            const size_t stride = layer.channels.size() * sizeof(float);
            // OpenEXR takes the slice's address without const; it only reads.
            auto* data = const_cast<char*>(reinterpret_cast<const char*>(layer.values.data() + c));
            buffer.insert(name, Imf::Slice(type, data, stride, stride * width));
        }
    }
    MemoryOutput stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(buffer);
        file.writePixels(picture.height);
    }
    return stream.take();
}

}  // namespace tp

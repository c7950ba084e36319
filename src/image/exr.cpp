// OpenEXR files by way of the OpenEXR library, through AtomicFile when writing.
#include "image/exr.h"

#include "core/error.h"
#include "image/atomic_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTestFile.h>

#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <span>

namespace sunfleck {
namespace {

/// A claim beyond this many values for each byte of the file is refused before it is believed:
/// deflate, the usual packing, gives at most 1032 bytes for one.
constexpr std::uintmax_t kValuesPerByte = 1024;
constexpr std::uintmax_t kFreeValues = std::uintmax_t{1} << 20U;
constexpr std::uintmax_t kMostValues = std::uintmax_t{1} << 31U;
constexpr int kMostPixelsAcross = 1 << 17;
constexpr float kLargestHalf = 65504;

/// The library's way to an AtomicFile. Its destructors swallow faults of the last writes, so the
/// first fault is kept and thrown again by finish().
class FileStream : public Imf::OStream {
public:
    explicit FileStream(AtomicFile& file, const std::string& path)
        : Imf::OStream(path.c_str()), file_(file) {}

    void write(const char* bytes, int count) override {
        const auto size = static_cast<std::size_t>(count);
        attempt([&] { file_.write(std::as_bytes(std::span(bytes, size))); });
    }
    std::uint64_t tellp() override { return file_.position(); }
    void seekp(std::uint64_t position) override {
        attempt([&] { file_.seek(position); });
    }

    void finish() {
        if (fault_) std::rethrow_exception(fault_);
    }

private:
    template <class Task>
    void attempt(const Task& task) {
        try {
            task();
        } catch (const Error&) {
            if (!fault_) fault_ = std::current_exception();
            throw;
        }
    }

    AtomicFile& file_;
    std::exception_ptr fault_;
};

Imf::Header header_of(const Picture& picture, const ExrOptions& options) {
    Imf::Header header(picture.width, picture.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    const Imf::PixelType type = options.half ? Imf::HALF : Imf::FLOAT;
    for (const Channel& channel : picture.channels)
        header.channels().insert(channel.name, Imf::Channel(type));
    for (const auto& [name, text] : picture.metadata)
        header.insert(name, Imf::StringAttribute(text));
    return header;
}

std::vector<half> to_half(const std::vector<float>& values) {
    std::vector<half> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool large = std::isfinite(values[i]) && std::abs(values[i]) > kLargestHalf;
        result[i] = half(large ? std::copysign(kLargestHalf, values[i]) : values[i]);
    }
    return result;
}

/// A slice over values that stand row after row; the library wants a writable pointer, always.
template <class Value>
Imf::Slice slice(Imf::PixelType type, const Value* values, int width) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-*): the library's only interface
    auto* bytes = reinterpret_cast<char*>(const_cast<Value*>(values));
    return {type, bytes, sizeof(Value), sizeof(Value) * static_cast<std::size_t>(width)};
}

void write_channels(Imf::OStream& stream, const Picture& picture, const ExrOptions& options) {
    std::vector<std::vector<half>> halves;
    Imf::FrameBuffer buffer;
    for (const Channel& channel : picture.channels) {
        if (options.half) {
            halves.push_back(to_half(channel.values));
            buffer.insert(channel.name, slice(Imf::HALF, halves.back().data(), picture.width));
        } else {
            buffer.insert(channel.name, slice(Imf::FLOAT, channel.values.data(), picture.width));
        }
    }
    Imf::OutputFile output(stream, header_of(picture, options), 0);
    output.setFrameBuffer(buffer);
    output.writePixels(picture.height);
}

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw Error({path}, what, "convert the picture to a plain EXR, or write it again");
}

/// Width and height of the data window, both at least 1, and few enough for a file of that size.
Picture sized_picture(const std::string& path, const Imf::Header& header) {
    const Imath::Box2i& window = header.dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width > kMostPixelsAcross || height > kMostPixelsAcross)
        refuse(path, "cannot read a picture of " + std::to_string(width) + " x " +
                         std::to_string(height) + " pixels");
    std::uintmax_t channels = 0;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
        ++channels;
        if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
            refuse(path, std::string("channel \"") + c.name() + "\" is subsampled");
    }
    const std::uintmax_t values = static_cast<std::uintmax_t>(width * height) * channels;
    const std::uintmax_t bytes = std::filesystem::file_size(path);
    if (values > kMostValues || values > bytes * kValuesPerByte + kFreeValues)
        refuse(path, "claims " + std::to_string(values) + " values in " + std::to_string(bytes) +
                         " bytes");
    return {static_cast<int>(width), static_cast<int>(height), {}, {}};
}

Picture read_first_part(const std::string& path) {
    Imf::InputFile input(path.c_str(), 0);
    const Imf::Header& header = input.header();
    if (header.hasType() && Imf::isDeepData(header.type())) refuse(path, "holds deep pixels");
    Picture picture = sized_picture(path, header);
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
        picture.add(c.name());
    for (auto a = header.begin(); a != header.end(); ++a)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
            picture.metadata[a.name()] = text->value();

    const Imath::V2i corner = header.dataWindow().min;
    Imf::FrameBuffer buffer;
    for (const Channel& channel : picture.channels) {
        const Imf::Slice plain = slice(Imf::FLOAT, channel.values.data(), picture.width);
        // The library addresses pixels from the origin of its coordinates, not of the window.
        const auto before =
            static_cast<std::ptrdiff_t>(corner.x) * sizeof(float) +
            static_cast<std::ptrdiff_t>(corner.y) * static_cast<std::ptrdiff_t>(plain.yStride);
        buffer.insert(channel.name,
                      Imf::Slice(Imf::FLOAT, plain.base - before, plain.xStride, plain.yStride));
    }
    input.setFrameBuffer(buffer);
    input.readPixels(header.dataWindow().min.y, header.dataWindow().max.y);
    return picture;
}

}  // namespace

void write_exr(const std::string& path, const Picture& picture, const ExrOptions& options) {
    AtomicFile file(path);
    FileStream stream(file, path);
    write_channels(stream, picture, options);
    stream.finish();
    file.commit();
}

Picture read_exr(const std::string& path) {
    std::error_code code;
    if (!std::filesystem::is_regular_file(path, code))
        throw Error({path}, "there is no such file", "check the name");
    try {
        return read_first_part(path);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& fault) {
        refuse(path, std::string("cannot be read as EXR: ") + fault.what());
    }
}

}  // namespace sunfleck

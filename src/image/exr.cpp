// Writes OpenEXR files by the OpenEXR library through an AtomicFile.
#include "image/exr.h"

#include "core/machine_fault.h"
#include "image/atomic_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <span>

namespace sunfleck::engine {
namespace {

constexpr float kLargestHalf = 65504;

/// Adapts AtomicFile to the library's stream. The library's destructors swallow faults of the last
/// writes, so the first fault is kept and thrown again by finish().
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

/// Adapts bytes in memory to the library's stream.
class MemoryStream : public Imf::OStream {
public:
    MemoryStream() : Imf::OStream("picture") {}

    void write(const char* bytes, int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (bytes_.size() < place_ + size) bytes_.resize(place_ + size);
        std::copy(bytes, bytes + size, bytes_.begin() + static_cast<std::ptrdiff_t>(place_));
        place_ += size;
    }
    std::uint64_t tellp() override { return place_; }
    void seekp(std::uint64_t position) override { place_ = position; }

    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
    std::uint64_t place_ = 0;
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

/// Returns a slice over row-major values; the library demands a writable pointer.
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

/// Throws if rows are missing: the library ignores failures while it compresses rows.
void check_complete(const std::string& path, const AtomicFile& file) {
    if (!Imf::InputFile(file.temporary().c_str()).isComplete())
        throw MachineFault({path}, "cannot be compressed", "free some memory");
}

}  // namespace

void write_exr(const std::string& path, const Picture& picture, const ExrOptions& options) {
    AtomicFile file(path);
    FileStream stream(file, path);
    write_channels(stream, picture, options);
    stream.finish();
    check_complete(path, file);
    file.commit();
}

std::string exr_bytes(const Picture& picture, const ExrOptions& options) {
    MemoryStream stream;
    write_channels(stream, picture, options);
    return stream.take();
}

}  // namespace sunfleck::engine

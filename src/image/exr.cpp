// Writes OpenEXR files by the OpenEXR library through an AtomicFile.
#include "image/exr.h"

#include "core/machine_fault.h"
#include "image/atomic_file.h"
#include "image/exr_header.h"
#include "image/id_layers.h"

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>

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

/// Slices over the channels of some layers. Halves are kept here while they are written.
class Slices {
public:
    void add(const ExrLayer& layer, int width, const ExrOptions& options) {
        for (const Channel* channel : layer.channels) {
            if (is_half(layer, options)) {
                halves_.push_back(to_half(channel->values));
                buffer_.insert(channel->name, slice(Imf::HALF, halves_.back().data(), width));
            } else {
                buffer_.insert(channel->name, slice(Imf::FLOAT, channel->values.data(), width));
            }
        }
    }
    const Imf::FrameBuffer& buffer() const { return buffer_; }

private:
    std::vector<std::vector<half>> halves_;
    Imf::FrameBuffer buffer_;
};

void write_in_one(Imf::OStream& stream, const Picture& picture, const ExrOptions& options) {
    Imf::Header header = plain_exr_header(picture, options);
    insert_metadata(header, picture);
    Slices slices;
    for (const ExrLayer& layer : exr_layers(picture)) {
        insert_channels(header, layer, options);
        slices.add(layer, picture.width, options);
    }
    Imf::OutputFile output(stream, header, 0);
    output.setFrameBuffer(slices.buffer());
    output.writePixels(picture.height);
}

/// Writes each layer as a part; the first has the metadata.
void write_in_parts(Imf::OStream& stream, const Picture& picture, const ExrOptions& options) {
    const std::vector<ExrLayer> layers = exr_layers(picture);
    std::vector<Imf::Header> headers;
    for (const ExrLayer& layer : layers) {
        headers.push_back(plain_exr_header(picture, options));
        headers.back().setName(layer.name);
        headers.back().setType(Imf::SCANLINEIMAGE);
        insert_channels(headers.back(), layer, options);
    }
    insert_metadata(headers.front(), picture);
    Imf::MultiPartOutputFile output(stream, headers.data(), static_cast<int>(headers.size()), false,
                                    0);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        Slices slices;
        slices.add(layers[i], picture.width, options);
        Imf::OutputPart part(output, static_cast<int>(i));
        part.setFrameBuffer(slices.buffer());
        part.writePixels(picture.height);
    }
}

void write_channels(Imf::OStream& stream, const Picture& picture, const ExrOptions& options) {
    (options.parts ? write_in_parts : write_in_one)(stream, picture, options);
}

bool is_complete(const std::string& path, bool has_parts) {
    if (!has_parts) return Imf::InputFile(path.c_str()).isComplete();
    const Imf::MultiPartInputFile file(path.c_str());
    for (int part = 0; part < file.parts(); ++part)
        if (!file.partComplete(part)) return false;
    return true;
}

/// Throws if rows are missing: the library ignores failures while it compresses rows.
void check_complete(const std::string& path, const AtomicFile& file, bool has_parts) {
    if (!is_complete(file.temporary(), has_parts))
        throw MachineFault({path}, "cannot be compressed", "free some memory");
}

}  // namespace

void write_exr(const std::string& path, const Picture& picture, const ExrOptions& options) {
    check_ids_kept(picture, options);
    AtomicFile file(path);
    FileStream stream(file, path);
    write_channels(stream, picture, options);
    stream.finish();
    check_complete(path, file, options.parts);
    file.commit();
}

void check_exr_date() {
    exr_date();
}

std::string exr_bytes(const Picture& picture, const ExrOptions& options) {
    check_ids_kept(picture, options);
    MemoryStream stream;
    write_channels(stream, picture, options);
    return stream.take();
}

}  // namespace sunfleck::engine

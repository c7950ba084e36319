// Parts of reading OpenEXR files: the bytes, the checks before memory is allocated, the rows.
#pragma once

#include "math/vector.h"

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace sunfleck::engine {

/// @throws Error  always: what is wrong with the file `name`.
[[noreturn]] void refuse_exr(const std::string& name, const std::string& what);

/// Bytes in memory as the library's stream. They are checked first: the library allocates tables
/// of the sizes that the heads of all parts claim. (Its own limits are those of the process.)
class ExrBytes : public Imf::IStream {
public:
    /// @throws Error  for a head that claims more than any picture has.
    ExrBytes(std::string_view bytes, const std::string& name);

    bool read(char* to, int count) override;
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

    std::uint64_t size() const { return bytes_.size(); }
    bool has_parts() const;

private:
    /// Throws if these bytes are the size of an attribute that is longer than the file: the library
    /// allocates what is claimed. It reads name and type of an attribute letter by letter, each
    /// with a zero at its end, and then the size.
    void check_claim(const char* read, std::uint64_t count);

    std::string_view bytes_;
    std::uint64_t position_ = 0;
    int text_ends_ = 0;  // zeros among the single bytes that were read last
};

/// Returns the resolution of a part. @throws Error  for deep or subsampled pixels, and for sizes
/// that no picture has.
Vec2i exr_resolution(const Imf::Header& header, const std::string& name);

std::uint64_t exr_channel_count(const Imf::Header& header);

/// @param values  of all channels that are to be read.
/// @throws Error  if so many cannot be in the file or in memory.
void check_exr_values(std::uint64_t values, const ExrBytes& bytes, const std::string& name);

/// Where the channels of a part are read to.
class ExrRows {
public:
    ExrRows(const Imf::Header& header, const Vec2i& resolution)
        : corner_(header.dataWindow().min), resolution_(resolution) {}

    /// Directs a channel to `first` and every `step`-th value after it.
    template <class Value>
    void place(const char* channel, Value* first, std::size_t step) {
        const std::size_t across = sizeof(Value) * step;
        const std::size_t down = across * static_cast<std::size_t>(resolution_.x);
        // The library addresses pixels from the origin of its coordinates, not from the data
        // window.
        const std::ptrdiff_t before =
            static_cast<std::ptrdiff_t>(corner_.x) * static_cast<std::ptrdiff_t>(across) +
            static_cast<std::ptrdiff_t>(corner_.y) * static_cast<std::ptrdiff_t>(down);
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-*): the library's only interface
        auto* bytes = reinterpret_cast<char*>(first) - before;
        const auto type = std::is_same_v<Value, half> ? Imf::HALF : Imf::FLOAT;
        buffer_.insert(channel, Imf::Slice(type, bytes, across, down));
    }

    /// @param part  of the library, whose header this was made of.
    template <class Part>
    void read(Part& part) const {
        part.setFrameBuffer(buffer_);
        part.readPixels(corner_.y, corner_.y + resolution_.y - 1);
    }

private:
    Imath::V2i corner_;
    Vec2i resolution_;
    Imf::FrameBuffer buffer_;
};

}  // namespace sunfleck::engine

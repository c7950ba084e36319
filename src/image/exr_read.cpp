// Reads OpenEXR files from memory by way of the OpenEXR library.
#include "core/file_content.h"
#include "core/printable.h"
#include "image/exr.h"
#include "image/exr_colours.h"
#include "image/formats.h"
#include "image/image_memory.h"
#include "image/read_file.h"
#include "math/colour.h"
#include "sunfleck/error.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTileDescriptionAttribute.h>
#include <OpenEXR/ImfVersion.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <exception>
#include <stdexcept>

namespace sunfleck::engine {
namespace {

/// Files that claim more values per byte are refused before allocation: deflate, the usual
/// compression, expands a byte to at most 1032.
constexpr std::uint64_t kValuesPerByte = 1024;
constexpr std::uint64_t kFreeValues = std::uint64_t{1} << 20U;
constexpr std::uint64_t kMostValues = std::uint64_t{1} << 31U;
constexpr int kMostPixelsAcross = 1 << 17;
constexpr int kLibraryMost = 1 << 23;  // larger widths overflow the library's row tables

/// Adapts bytes in memory to the library's stream.
class ByteStream : public Imf::IStream {
public:
    ByteStream(std::string_view bytes, const std::string& name)
        : Imf::IStream(name.c_str()), bytes_(bytes) {}

    bool read(char* to, int count) override {
        const auto size = static_cast<std::uint64_t>(count);
        if (position_ > bytes_.size() || size > bytes_.size() - position_)
            throw std::runtime_error("the file is truncated");
        std::memcpy(to, bytes_.data() + position_, size);
        position_ += size;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    std::string_view bytes_;
    std::uint64_t position_ = 0;
};

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw Error({name}, what, "convert the picture to a plain EXR, or write it again");
}

void check_extent(const Imath::Box2i& window, const std::string& name) {
    const auto most = std::max(std::int64_t{window.max.x} - window.min.x,
                               std::int64_t{window.max.y} - window.min.y);
    if (most >= kLibraryMost)
        refuse(name, "its head claims " + std::to_string(most) + " pixels a side");
}

/// Checks the heads of all parts before the library allocates tables of their size. (The library's
/// own limits are global, and those of the whole process.)
/// @return the bytes.
std::string_view checked(std::string_view bytes, const std::string& name) {
    constexpr std::uint64_t kFirstHead = 8;  // after magic number and version
    ByteStream stream(bytes, name);
    stream.seekg(kFirstHead - sizeof(std::int32_t));
    int version = 0;
    std::array<char, sizeof version> little{};
    stream.read(little.data(), static_cast<int>(little.size()));
    std::memcpy(&version, little.data(), sizeof version);
    do {
        Imf::Header head;
        head.readFrom(stream, version);
        check_extent(head.dataWindow(), name);
        check_extent(head.displayWindow(), name);
        if (!head.hasTileDescription()) continue;
        const Imf::TileDescription& tile = head.tileDescription();
        if (std::max(tile.xSize, tile.ySize) > unsigned{kLibraryMost})
            refuse(name, "its head claims tiles of " + std::to_string(tile.xSize) + " x " +
                             std::to_string(tile.ySize) + " pixels");
    } while (Imf::isMultiPart(version) && stream.tellg() < bytes.size() &&
             bytes[stream.tellg()] != 0);
    return bytes;
}

/// An open file whose first part has a plausible size.
class OpenExr {
public:
    OpenExr(std::string_view bytes, const std::string& name)
        : stream_(checked(bytes, name), name), input_(stream_, 0) {
        const Imf::Header& header = input_.header();
        if (header.hasType() && Imf::isDeepData(header.type())) refuse(name, "holds deep pixels");
        const Imath::Box2i& window = header.dataWindow();
        const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
        const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
        if (width < 1 || height < 1 || width > kMostPixelsAcross || height > kMostPixelsAcross)
            refuse(name, "cannot read a picture of " + std::to_string(width) + " x " +
                             std::to_string(height) + " pixels");
        std::uint64_t channels = 0;
        for (auto c = this->channels().begin(); c != this->channels().end(); ++c) {
            ++channels;
            if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
                refuse(name, "channel \"" + printable(c.name(), 60) + "\" is subsampled");
        }
        const std::uint64_t values = static_cast<std::uint64_t>(width * height) * channels;
        if (values > kMostValues || values > bytes.size() * kValuesPerByte + kFreeValues)
            refuse(name, "claims " + std::to_string(values) + " values in " +
                             std::to_string(bytes.size()) + " bytes");
        const std::string fault = fault_of_size(values * sizeof(float));
        if (!fault.empty()) refuse(name, "cannot be read as EXR: " + fault);
        resolution_ = {static_cast<int>(width), static_cast<int>(height)};
    }

    const Imf::Header& header() const { return input_.header(); }
    const Imf::ChannelList& channels() const { return input_.header().channels(); }
    const Vec2i& resolution() const { return resolution_; }

    /// Directs a channel to `first` and every `step`-th value after it.
    template <class Value>
    void place(const char* channel, Value* first, std::size_t step) {
        const std::size_t across = sizeof(Value) * step;
        const std::size_t down = across * static_cast<std::size_t>(resolution_.x);
        // The library addresses pixels from the origin of its coordinates, not from the data
        // window.
        const Imath::V2i corner = header().dataWindow().min;
        const std::ptrdiff_t before =
            static_cast<std::ptrdiff_t>(corner.x) * static_cast<std::ptrdiff_t>(across) +
            static_cast<std::ptrdiff_t>(corner.y) * static_cast<std::ptrdiff_t>(down);
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-*): the library's only interface
        auto* bytes = reinterpret_cast<char*>(first) - before;
        const auto type = std::is_same_v<Value, half> ? Imf::HALF : Imf::FLOAT;
        buffer_.insert(channel, Imf::Slice(type, bytes, across, down));
    }

    void read() {
        input_.setFrameBuffer(buffer_);
        input_.readPixels(header().dataWindow().min.y, header().dataWindow().max.y);
    }

private:
    ByteStream stream_;
    Imf::InputFile input_;
    Imf::FrameBuffer buffer_;
    Vec2i resolution_;
};

Picture read_all_channels(std::string_view bytes, const std::string& name) {
    OpenExr file(bytes, name);
    Picture picture{file.resolution().x, file.resolution().y, {}, {}};
    for (auto c = file.channels().begin(); c != file.channels().end(); ++c) picture.add(c.name());
    const Imf::Header& header = file.header();
    for (auto a = header.begin(); a != header.end(); ++a)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
            picture.metadata[a.name()] = text->value();
    for (Channel& channel : picture.channels)
        file.place(channel.name.c_str(), channel.values.data(), 1);
    file.read();
    return picture;
}

template <class Value>
Image read_colours(OpenExr& file, const std::vector<std::string>& names) {
    const std::size_t count = names.size();
    std::vector<Value> texels(static_cast<std::size_t>(file.resolution().x) *
                              static_cast<std::size_t>(file.resolution().y) * count);
    for (std::size_t c = 0; c < count; ++c) file.place(names[c].c_str(), texels.data() + c, count);
    file.read();
    return {file.resolution(), static_cast<int>(count), std::move(texels)};
}

/// Converts texels of CIE XYZ to linear sRGB.
Image rgb_of(const Image& xyz) {
    std::vector<float> texels = std::get<std::vector<float>>(xyz.texels());
    for (std::size_t i = 0; i < texels.size(); i += 3) {
        const Triple rgb =
            rgb_of_xyz({double{texels[i]}, double{texels[i + 1]}, double{texels[i + 2]}});
        for (std::size_t c = 0; c < 3; ++c) texels[i + c] = static_cast<float>(rgb.at(c));
    }
    return {xyz.resolution(), 3, std::move(texels)};
}

/// Returns whether the file declares primaries other than Rec. 709; files without any have those.
bool has_other_primaries(const Imf::Header& header) {
    if (!Imf::hasChromaticities(header)) return false;
    constexpr float kAlike = 0.003F;
    const Imf::Chromaticities given = Imf::chromaticities(header);
    const Imf::Chromaticities usual;
    const auto differ = [](const Imath::V2f& a, const Imath::V2f& b) {
        return !a.equalWithAbsError(b, kAlike);
    };
    return differ(given.red, usual.red) || differ(given.green, usual.green) ||
           differ(given.blue, usual.blue) || differ(given.white, usual.white);
}

Image read_image(std::string_view bytes, const std::string& name) {
    OpenExr file(bytes, name);
    std::vector<std::string> all;
    for (auto c = file.channels().begin(); c != file.channels().end(); ++c)
        all.emplace_back(c.name());
    const ExrColours colours = exr_colours(all, name);
    const std::vector<std::string>& names = colours.channels;
    const bool all_half = !colours.are_xyz && std::all_of(names.begin(), names.end(), [&](auto& n) {
        return file.channels().findChannel(n)->type == Imf::HALF;
    });
    Image image = all_half ? read_colours<half>(file, names) : read_colours<float>(file, names);
    if (colours.are_xyz) image = rgb_of(image);
    if (names.size() >= 3 && !colours.are_xyz && has_other_primaries(file.header()))
        image.set_other_primaries();
    image.set_remark(colours.remark);
    return image;
}

/// Runs a task and converts exceptions of the library to Error.
template <class Task>
auto guarded(const std::string& name, const Task& task) {
    try {
        return task();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& fault) {
        refuse(name, "cannot be read as EXR: " + printable(fault.what(), 400));
    }
}

}  // namespace

Picture read_exr(const std::string& path) {
    const std::string bytes = read_file(path);
    if (!bytes.starts_with("\x76\x2F\x31\x01")) refuse_other_content(bytes, path, "an EXR picture");
    return guarded(path, [&] { return read_all_channels(bytes, path); });
}

Image parse_exr_image(std::string_view bytes, const std::string& name) {
    return guarded(name, [&] { return read_image(bytes, name); });
}

}  // namespace sunfleck::engine

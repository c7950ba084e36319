// Checks of OpenEXR files before the library and we allocate memory for them.
#include "image/exr_file.h"

#include "core/printable.h"
#include "image/image_memory.h"
#include "sunfleck/error.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTileDescriptionAttribute.h>
#include <OpenEXR/ImfVersion.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

namespace sunfleck::engine {
namespace {

/// Files that claim more values per byte are refused before allocation: deflate, the usual
/// compression, expands a byte to at most 1032.
constexpr std::uint64_t kValuesPerByte = 1024;
constexpr std::uint64_t kFreeValues = std::uint64_t{1} << 20U;
constexpr std::uint64_t kMostValues = std::uint64_t{1} << 31U;
constexpr int kMostExrPixelsAcross = 1 << 17;
constexpr int kLibraryMost = 1 << 23;  // larger widths overflow the library's row tables

void check_extent(const Imath::Box2i& window, const std::string& name) {
    const auto most = std::max(std::int64_t{window.max.x} - window.min.x,
                               std::int64_t{window.max.y} - window.min.y);
    if (most >= kLibraryMost)
        refuse_exr(name, "its head claims " + std::to_string(most) + " pixels a side");
}

/// Returns the word after the magic number, of which bits say what the file holds.
int version_of(std::string_view bytes) {
    constexpr std::size_t kPlace = 4;
    int version = 0;
    if (bytes.size() < kPlace + sizeof version) throw std::runtime_error("the file is truncated");
    std::memcpy(&version, bytes.data() + kPlace, sizeof version);
    return version;
}

}  // namespace

void refuse_exr(const std::string& name, const std::string& what) {
    throw Error({name}, what, "convert the picture to a plain EXR, or write it again");
}

ExrBytes::ExrBytes(std::string_view bytes, const std::string& name)
    : Imf::IStream(name.c_str()), bytes_(bytes) {
    constexpr std::uint64_t kFirstHead = 8;  // after magic number and version
    int version = version_of(bytes);
    seekg(kFirstHead);
    do {
        Imf::Header head;
        head.readFrom(*this, version);
        check_extent(head.dataWindow(), name);
        check_extent(head.displayWindow(), name);
        if (!head.hasTileDescription()) continue;
        const Imf::TileDescription& tile = head.tileDescription();
        if (std::max(tile.xSize, tile.ySize) > unsigned{kLibraryMost})
            refuse_exr(name, "its head claims tiles of " + std::to_string(tile.xSize) + " x " +
                                 std::to_string(tile.ySize) + " pixels");
    } while (Imf::isMultiPart(version) && tellg() < bytes.size() && bytes[tellg()] != 0);
    seekg(0);
}

bool ExrBytes::read(char* to, int count) {
    const auto size = static_cast<std::uint64_t>(count);
    if (position_ > bytes_.size() || size > bytes_.size() - position_)
        throw std::runtime_error("the file is truncated");
    std::memcpy(to, bytes_.data() + position_, size);
    position_ += size;
    check_claim(to, size);
    return position_ < bytes_.size();
}

void ExrBytes::check_claim(const char* read, std::uint64_t count) {
    if (count == 1) {
        text_ends_ += *read == 0 ? 1 : 0;
        return;
    }
    std::uint32_t size = 0;
    const bool is_size = count == sizeof size && text_ends_ >= 2;
    text_ends_ = 0;
    if (!is_size) return;
    std::memcpy(&size, read, sizeof size);
    if (size > bytes_.size() - position_) throw std::runtime_error("the file is truncated");
}

bool ExrBytes::has_parts() const {
    return Imf::isMultiPart(version_of(bytes_));
}

Vec2i exr_resolution(const Imf::Header& header, const std::string& name) {
    if (header.hasType() && Imf::isDeepData(header.type())) refuse_exr(name, "holds deep pixels");
    const Imath::Box2i& window = header.dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width > kMostExrPixelsAcross || height > kMostExrPixelsAcross)
        refuse_exr(name, "cannot read a picture of " + std::to_string(width) + " x " +
                             std::to_string(height) + " pixels");
    const Imf::ChannelList& channels = header.channels();
    for (auto c = channels.begin(); c != channels.end(); ++c)
        if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
            refuse_exr(name, "channel \"" + printable(c.name(), 60) + "\" is subsampled");
    return {static_cast<int>(width), static_cast<int>(height)};
}

std::uint64_t exr_channel_count(const Imf::Header& header) {
    std::uint64_t count = 0;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) ++count;
    return count;
}

void check_exr_values(std::uint64_t values, const ExrBytes& bytes, const std::string& name) {
    if (values > kMostValues || values > bytes.size() * kValuesPerByte + kFreeValues)
        refuse_exr(name, "claims " + std::to_string(values) + " values in " +
                             std::to_string(bytes.size()) + " bytes");
    const std::string fault = fault_of_size(values * sizeof(float));
    if (!fault.empty()) refuse_exr(name, "cannot be read as EXR: " + fault);
}

}  // namespace sunfleck::engine

// Attributes of OpenEXR files, in the library's types.
#include "image/exr_header.h"

#include "sunfleck/error.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace sunfleck::engine {
namespace {

constexpr const char* kDateVariable = "SOURCE_DATE_EPOCH";

Imf::Compression compression_of(ExrCompression compression) {
    switch (compression) {
        case ExrCompression::none:
            return Imf::NO_COMPRESSION;
        case ExrCompression::zip:
            return Imf::ZIP_COMPRESSION;
        case ExrCompression::piz:
            return Imf::PIZ_COMPRESSION;
        case ExrCompression::dwaa:
            return Imf::DWAA_COMPRESSION;
        case ExrCompression::dwab:
            return Imf::DWAB_COMPRESSION;
    }
    return Imf::ZIP_COMPRESSION;
}

}  // namespace

std::optional<std::string> exr_date() {
    const char* const given = std::getenv(kDateVariable);
    if (given == nullptr || *given == '\0') return {};
    constexpr std::int64_t kMost = 253402300799;  // the end of the year 9999
    const std::string text = given;
    std::int64_t seconds = -1;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), seconds);
    if (fault != std::errc() || end != text.data() + text.size() || seconds < 0 || seconds > kMost)
        throw Error({kDateVariable}, "\"" + text + "\" is no number of seconds since 1970",
                    "set it to such a number, or unset it");
    const auto time = static_cast<std::time_t>(seconds);
    std::tm utc{};
    ::gmtime_r(&time, &utc);
    std::array<char, 32> date{};
    std::strftime(date.data(), date.size(), "%Y:%m:%d %H:%M:%S", &utc);
    return date.data();
}

bool is_half(const ExrLayer& layer, const ExrOptions& options) {
    const std::vector<std::string>& some = options.half_layers;
    return !layer.holds_ids &&
           (options.half || std::find(some.begin(), some.end(), layer.name) != some.end());
}

Imf::Header plain_exr_header(const Picture& picture, const ExrOptions& options) {
    Imf::Header header(picture.width, picture.height, picture.pixel_aspect);
    header.compression() = compression_of(options.compression);
    Imf::addChromaticities(header, Imf::Chromaticities());  // Rec. 709 and D65
    return header;
}

void insert_channels(Imf::Header& header, const ExrLayer& layer, const ExrOptions& options) {
    const Imf::PixelType type = is_half(layer, options) ? Imf::HALF : Imf::FLOAT;
    for (const Channel* channel : layer.channels)
        header.channels().insert(channel->name, Imf::Channel(type));
}

void insert_metadata(Imf::Header& header, const Picture& picture) {
    for (const auto& [name, text] : picture.metadata)
        header.insert(name, Imf::StringAttribute(text));
    if (const auto date = exr_date()) Imf::addCapDate(header, *date);
}

}  // namespace sunfleck::engine

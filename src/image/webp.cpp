// WebP images by libwebp: lossy and lossless, with and without alpha; of films nothing.
#include "image/byte_source.h"
#include "image/formats.h"

#include <webp/decode.h>

#include <cstddef>

namespace sunfleck::engine {

Image parse_webp(std::string_view bytes, const std::string& name) {
    const ByteSource source(bytes, name, "WebP");
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): characters as bytes
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK)
        source.refuse("its head is damaged");
    if (features.has_animation != 0) source.refuse("it is a film of several pictures");
    const int channels = features.has_alpha != 0 ? 4 : 3;
    // An even picture takes no bits for its pixels.
    constexpr std::uint64_t kFreeTexels = 1U << 24U;
    constexpr std::uint64_t kTexelsPerByte = 1U << 14U;
    source.check_size(features.width, features.height, kFreeTexels + bytes.size() * kTexelsPerByte,
                      2 * static_cast<std::uint64_t>(channels));
    const std::size_t stride =
        static_cast<std::size_t>(features.width) * static_cast<std::size_t>(channels);
    std::vector<std::uint8_t> texels(stride * static_cast<std::size_t>(features.height));
    const auto decode = channels == 4 ? WebPDecodeRGBAInto : WebPDecodeRGBInto;
    if (decode(data, bytes.size(), texels.data(), texels.size(), static_cast<int>(stride)) ==
        nullptr)
        source.refuse("it is damaged or truncated");
    return {{features.width, features.height}, channels, std::move(texels)};
}

}  // namespace sunfleck::engine

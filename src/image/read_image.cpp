// Selects the decoder by the first bytes; TGA has no signature and is recognised by its ending.
#include "image/read_image.h"

#include "core/file_content.h"
#include "core/small_letters.h"
#include "image/formats.h"
#include "sunfleck/error.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

bool ends_in_tga(const std::string& name) {
    return name.size() >= 4 && small_letters(name.substr(name.size() - 4)) == ".tga";
}

/// Returns the beginning of a text in place of an image, such as the answer of a server.
std::string beginning_of(std::string_view bytes) {
    const std::string_view text = bytes.substr(0, 40);
    const bool is_text =
        std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7F; });
    return is_text ? " (it begins \"" + std::string(text) + "\")" : "";
}

Image parse_any(std::string_view bytes, const std::string& name, const Encoding& encoding) {
    const auto begins = [&](const auto& mark) {  // the literal without its final zero
        return bytes.starts_with(std::string_view(mark, sizeof mark - 1));
    };
    if (begins("\x89PNG")) return parse_png_image(bytes, name, encoding);
    if (begins("\xFF\xD8\xFF")) return parse_jpeg(bytes, name);
    if (begins("RIFF") && bytes.substr(4).find("WEBP") == 4) return parse_webp(bytes, name);
    if (begins("\x76\x2F\x31\x01")) return parse_exr_image(bytes, name);
    if (begins("#?")) return parse_hdr(bytes, name);
    if (begins("PF") || begins("Pf")) return parse_pfm(bytes, name);
    refuse_other_content(bytes, name, "a picture in PNG, JPEG, WebP, TGA, EXR, HDR or PFM");
    if (ends_in_tga(name)) return parse_tga(bytes, name);
    throw Error({name}, "unknown image format" + beginning_of(bytes),
                "convert it to PNG, JPEG, WebP, TGA (with that ending), EXR, HDR or PFM");
}

Image without_needless_alpha(const Image& image) {
    return image.channels() == 4 && !image.has_holes() ? image.with_channels(3) : image;
}

/// Returns an image of RGBA for one of grey and alpha.
Image repeated_grey(const Image& image, const Encoding& encoding) {
    return std::visit(
        [&](const auto& from) -> Image {
            std::remove_cvref_t<decltype(from)> texels;
            texels.reserve(2 * from.size());
            for (std::size_t i = 0; i < from.size(); i += 2)
                texels.insert(texels.end(), {from[i], from[i], from[i], from[i + 1]});
            return {image.resolution(), 4, std::move(texels), encoding};
        },
        image.texels());
}

}  // namespace

Image parse_image(std::string_view bytes, const std::string& name, const Encoding& encoding) {
    const Image image = parse_any(bytes, name, encoding);
    return image.channels() == 2 ? image.with_channels(1) : without_needless_alpha(image);
}

Image parse_image_with_alpha(std::string_view bytes, const std::string& name,
                             const Encoding& encoding) {
    const Image image = parse_any(bytes, name, encoding);
    return without_needless_alpha(image.channels() == 2 ? repeated_grey(image, encoding) : image);
}

}  // namespace sunfleck::engine

// Which format it is, by the first bytes; a TGA has none of its own, and is known by its ending.
#include "image/read_image.h"

#include "core/error.h"
#include "core/small_letters.h"
#include "image/formats.h"

namespace sunfleck {
namespace {

bool ends_in_tga(const std::string& name) {
    return name.size() >= 4 && small_letters(name.substr(name.size() - 4)) == ".tga";
}

Image parse_any(std::string_view bytes, const std::string& name, const Encoding& encoding) {
    const auto begins = [&](const auto& mark) {  // but for the zero that ends the literal
        return bytes.starts_with(std::string_view(mark, sizeof mark - 1));
    };
    if (begins("\x89PNG")) return parse_png_image(bytes, name, encoding);
    if (begins("\xFF\xD8\xFF")) return parse_jpeg(bytes, name);
    if (begins("\x76\x2F\x31\x01")) return parse_exr_image(bytes, name);
    if (begins("#?")) return parse_hdr(bytes, name);
    if (begins("PF") || begins("Pf")) return parse_pfm(bytes, name);
    if (ends_in_tga(name)) return parse_tga(bytes, name);
    throw Error({name}, "is no image that is known",
                "convert it to PNG, JPEG, TGA (with that ending), EXR, HDR or PFM");
}

}  // namespace

Image parse_image(std::string_view bytes, const std::string& name, const Encoding& encoding) {
    Image image = parse_any(bytes, name, encoding);
    if (image.channels() == 2) return image.with_channels(1);
    if (image.channels() == 4 && !image.has_holes()) return image.with_channels(3);
    return image;
}

}  // namespace sunfleck

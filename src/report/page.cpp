// Fills the template with style, scripts, numbers and pixels.
#include "report/page.h"

#include "report/assets.h"

#include <fmt/format.h>
#include <half.h>

#include <array>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// What stands in the template for a part that is put in.
struct Part {
    std::string_view mark;
    std::string text;
};

/// JSON that may stand in a script element: no "<" in it.
std::string for_script(const std::string& json) {
    std::string text;
    for (const char c : json) {
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    return text;
}

std::string block(const std::string& id, std::span<const std::uint8_t> bytes,
                  const std::string& attributes = "") {
    return "<script type=\"text/plain\" id=\"" + id + "\"" + attributes + ">" + base64(bytes) +
           "</script>\n";
}

std::string pixel_block(std::size_t number, const RgbImage& image) {
    const HalfPixels pixels = half_pixels(image);
    return block("pixels-" + std::to_string(number), pixels.bytes,
                 " data-scale=\"" + fmt::format("{}", pixels.scale) + "\"");
}

std::string flip_block(std::size_t number, const std::vector<float>& map) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(map.size());
    for (const float value : map)
        bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * value)));
    return block("flip-" + std::to_string(number), bytes);
}

/// The reference is number 0.
std::string pixel_blocks(const Comparison& comparison) {
    std::string text = pixel_block(0, comparison.reference.image);
    for (std::size_t i = 0; i < comparison.pictures.size(); ++i) {
        text += pixel_block(i + 1, comparison.pictures[i].image);
        text += flip_block(i + 1, comparison.pictures[i].measured.flip_map);
    }
    return text;
}

bool has_series(const Comparison& comparison) {
    for (const Compared& picture : comparison.pictures)
        if (picture.seeds > 0) return true;
    return false;
}

/// The template from its front to its end; what is put in is not looked at again.
std::string filled(std::string_view page, std::span<const Part> parts) {
    std::string text;
    for (const Part& part : parts) {
        const std::size_t at = page.find(part.mark);
        text += page.substr(0, at);
        text += part.text;
        page.remove_prefix(at + part.mark.size());
    }
    return text.append(page);
}

}  // namespace

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8U | (k < left ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= left ? kDigits[bits >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

HalfPixels half_pixels(const RgbImage& image) {
    float most = 0;
    for (const Vec3& pixel : image.pixels)
        for (int c = 0; c < 3; ++c)
            if (std::isfinite(pixel[c])) most = std::max(most, std::abs(pixel[c]));
    HalfPixels result;
    while (most * result.scale > 65504) result.scale /= 2;
    result.bytes.reserve(6 * image.pixels.size());
    for (const Vec3& pixel : image.pixels)
        for (int c = 0; c < 3; ++c) {
            const std::uint16_t bits = half(pixel[c] * result.scale).bits();
            result.bytes.push_back(static_cast<std::uint8_t>(bits & 255U));
            result.bytes.push_back(static_cast<std::uint8_t>(bits >> 8U));
        }
    return result;
}

std::string report_page(const Comparison& comparison) {
    const bool with_chart = has_series(comparison);
    const std::array parts = {
        Part{"<!-- style -->", "<style>\n" + std::string(kPageStyle) + "</style>"},
        Part{"<!-- numbers -->", for_script(comparison_json(comparison))},
        Part{"<!-- pixels -->", pixel_blocks(comparison)},
        // The library only where there is something to draw.
        Part{"<!-- chart -->",
             with_chart ? "<script>" + std::string(kChartLibrary) + "</script>" : std::string()},
        Part{"<!-- script -->", "<script>\n" + std::string(kPageScript) + "</script>"},
    };
    return filled(kPage, parts);
}

}  // namespace sunfleck::engine

// UTF-8 decoded, and the names of the characters that editors and word processors put in.
#include "import/pbrt/odd_characters.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace sunfleck::engine {
namespace {

struct Range {
    std::uint32_t first;
    std::uint32_t last;
    std::string_view name;
    std::string_view mend;
};

constexpr std::string_view kSpace = "write a plain space";
constexpr std::string_view kRemove = "remove it";
constexpr std::string_view kMinus = "write a plain -";
constexpr std::string_view kQuote = "write a plain \"";
constexpr std::string_view kAscii = "use plain ASCII here";

constexpr auto kRanges = std::to_array<Range>({
    {0x00, 0x00, "a zero byte", kRemove},
    {0x0B, 0x0C, "vertical tab or form feed", kSpace},
    {0x1A, 0x1A, "end-of-file mark of DOS", kRemove},
    {0x00, 0x1F, "control character", kRemove},
    {0x7F, 0x84, "control character", kRemove},
    {0x85, 0x85, "next line", "write a plain line end"},
    {0x86, 0x9F, "control character", kRemove},
    {0xA0, 0xA0, "no-break space", kSpace},
    {0xAB, 0xAB, "quotation mark", kQuote},
    {0xAD, 0xAD, "soft hyphen", kMinus},
    {0xBB, 0xBB, "quotation mark", kQuote},
    {0x1680, 0x1680, "Ogham space", kSpace},
    {0x2000, 0x200A, "typographic space", kSpace},
    {0x200B, 0x200F, "invisible character", kRemove},
    {0x2010, 0x2015, "hyphen or dash", kMinus},
    {0x2018, 0x201F, "quotation mark", kQuote},
    {0x2028, 0x2029, "line or paragraph separator", "write a plain line end"},
    {0x202A, 0x202E, "invisible character", kRemove},
    {0x202F, 0x202F, "narrow no-break space", kSpace},
    {0x205F, 0x205F, "mathematical space", kSpace},
    {0x2060, 0x206F, "invisible character", kRemove},
    {0x2212, 0x2212, "minus sign", kMinus},
    {0x3000, 0x3000, "ideographic space", kSpace},
    {0xFEFF, 0xFEFF, "byte order mark within the text", kRemove},
    {0xFF01, 0xFF5E, "full-width character", kAscii},
});

/// The code point that begins there, or nothing for bytes that are no UTF-8.
std::optional<std::uint32_t> code_point(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return byte(0);
    const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < length) return std::nullopt;
    std::uint32_t point = byte(0) & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80) return std::nullopt;
        point = point << 6U | (byte(i) & 0x3FU);
    }
    return point;
}

std::string hexadecimal(const char* format, std::uint32_t number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, number);
    return text.data();
}

}  // namespace

std::optional<OddCharacter> odd_character_in(std::string_view text) {
    const auto* const odd = std::find_if(
        text.begin(), text.end(), [](char c) { return !is_plain(c) && c != ' ' && c != '\t'; });
    if (odd == text.end()) return std::nullopt;
    const auto at = static_cast<std::size_t>(odd - text.begin());
    const auto point = code_point(text.substr(at));
    if (!point)
        return OddCharacter{
            at, hexadecimal("byte %02X, which is no UTF-8", static_cast<unsigned char>(text[at])),
            "save the file as UTF-8"};
    const auto* const range = std::find_if(kRanges.begin(), kRanges.end(), [&](const Range& r) {
        return r.first <= *point && *point <= r.last;
    });
    const std::string code = hexadecimal("U+%04X", *point);
    if (range == kRanges.end()) return OddCharacter{at, code, std::string(kAscii)};
    return OddCharacter{at, code + " (" + std::string(range->name) + ")", std::string(range->mend)};
}

}  // namespace sunfleck::engine

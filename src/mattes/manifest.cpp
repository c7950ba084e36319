// JSON by hand: an object of texts.
#include "mattes/manifest.h"

#include <fmt/format.h>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kKeyDigits = 7;  // the most that the specification allows

/// Returns a text in quotes, as JSON has it. @param text  in UTF-8.
std::string json_text(const std::string& text) {
    std::string json = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F)
            json += fmt::format("\\u{:04x}", byte);
        else if (c == '"' || c == '\\')
            json += {'\\', c};
        else
            json += c;
    }
    return json + '"';
}

}  // namespace

std::string manifest_json(const Manifest& manifest) {
    std::string json;
    for (const auto& [name, id] : manifest)
        json += fmt::format("{}{}:\"{}\"", json.empty() ? "" : ",", json_text(name), hex_of(id));
    return '{' + json + '}';
}

std::map<std::string, std::string> matte_metadata(const std::string& layer,
                                                  const Manifest& manifest) {
    const std::string key = "cryptomatte/" + hex_of(matte_id(layer)).substr(0, kKeyDigits) + '/';
    return {{key + "name", layer},
            {key + "hash", "MurmurHash3_32"},
            {key + "conversion", "uint32_to_float32"},
            {key + "manifest", manifest_json(manifest)}};
}

}  // namespace sunfleck::engine

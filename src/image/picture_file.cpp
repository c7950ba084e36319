// One row for each ending.
#include "image/picture_file.h"

#include "core/small_letters.h"
#include "image/atomic_file.h"
#include "image/exr.h"
#include "image/png.h"
#include "sunfleck/error.h"

#include <array>
#include <filesystem>
#include <string_view>

namespace sunfleck::engine {
namespace {

struct Format {
    std::string_view ending;
    bool holds_layers;
    void (*write)(const std::string& path, const Picture& picture,
                  const PictureFileOptions& options);
};

constexpr std::array kFormats = {
    Format{".exr", true,
           [](const std::string& path, const Picture& picture, const PictureFileOptions& options) {
               write_exr(path, picture, {options.half});
           }},
    Format{".png", false,
           [](const std::string& path, const Picture& picture, const PictureFileOptions& options) {
               write_png(path, picture, options.exposure);
           }},
};

/// By the ending of the name; null for another.
const Format* find_format(const std::string& path) {
    const std::string ending = small_letters(std::filesystem::path(path).extension().string());
    for (const Format& format : kFormats)
        if (format.ending == ending) return &format;
    return nullptr;
}

const Format& format_of(const std::string& path) {
    if (const Format* format = find_format(path)) return *format;
    std::string known;
    for (const Format& format : kFormats)
        known += (known.empty() ? "" : " or ") + std::string(format.ending);
    throw Error({path}, "has no ending of a picture", "end the name in " + known);
}

}  // namespace

bool is_picture_path(const std::string& path) {
    return find_format(path) != nullptr;
}

bool loses_aovs(const std::string& path) {
    const Format* format = find_format(path);
    return format != nullptr && !format->holds_layers;
}

void check_picture_path(const std::string& path) {
    format_of(path);
    check_writable(path);
}

void write_picture(const std::string& path, const Picture& picture,
                   const PictureFileOptions& options) {
    format_of(path).write(path, picture, options);
}

}  // namespace sunfleck::engine

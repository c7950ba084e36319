// The table of picture formats, one row per ending.
#include "image/picture_file.h"

#include "core/small_letters.h"
#include "image/atomic_file.h"
#include "image/png.h"
#include "sunfleck/error.h"

#include <array>
#include <string_view>

namespace sunfleck::engine {
namespace {

struct Format {
    std::string_view ending;
    bool holds_layers;
    void (*write)(const std::string& path, const Picture& picture,
                  const PictureFileOptions& options);
};

void write_as_exr(const std::string& path, const Picture& picture,
                  const PictureFileOptions& options) {
    write_exr(path, picture, options.exr);
}

void write_as_png(const std::string& path, const Picture& picture,
                  const PictureFileOptions& options) {
    write_png(path, picture, options.transform, options.png_bits);
}

void write_as_jpeg(const std::string& path, const Picture& picture,
                   const PictureFileOptions& options) {
    write_jpeg(path, picture, options.transform, options.jpeg_quality);
}

constexpr std::array kFormats = {
    Format{".exr", true, write_as_exr},
    Format{".png", false, write_as_png},
    Format{".jpg", false, write_as_jpeg},
    Format{".jpeg", false, write_as_jpeg},
};

/// Returns the format of a name's ending; null for an unknown one.
const Format* find_format(const std::string& path) {
    const std::string ending = small_ending(path);
    for (const Format& format : kFormats)
        if (format.ending == ending) return &format;
    return nullptr;
}

const Format& format_of(const std::string& path) {
    if (const Format* format = find_format(path)) return *format;
    throw Error({path}, "unknown picture format", "end the name in " + picture_endings());
}

}  // namespace

std::string picture_endings() {
    std::string known;
    for (const Format& format : kFormats) {
        const bool is_last = &format == &kFormats.back();
        known += (known.empty() ? "" : is_last ? " or " : ", ") + std::string(format.ending);
    }
    return known;
}

bool is_picture_path(const std::string& path) {
    return find_format(path) != nullptr;
}

bool loses_aovs(const std::string& path) {
    const Format* format = find_format(path);
    return format != nullptr && !format->holds_layers;
}

void check_picture_path(const std::string& path) {
    if (format_of(path).holds_layers) check_exr_date();
    check_writable(path);
}

void write_picture(const std::string& path, const Picture& picture,
                   const PictureFileOptions& options) {
    format_of(path).write(path, picture, options);
}

}  // namespace sunfleck::engine

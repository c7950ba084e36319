// One row for each ending.
#include "image/picture_file.h"

#include "core/error.h"
#include "image/atomic_file.h"
#include "image/exr.h"
#include "image/png.h"

#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

namespace sunfleck {
namespace {

struct Format {
    std::string_view ending;
    void (*write)(const std::string& path, const Picture& picture,
                  const PictureFileOptions& options);
};

constexpr std::array kFormats = {
    Format{".exr",
           [](const std::string& path, const Picture& picture, const PictureFileOptions& options) {
               write_exr(path, picture, {options.half});
           }},
    Format{".png",
           [](const std::string& path, const Picture& picture, const PictureFileOptions& options) {
               write_png(path, picture, options.exposure);
           }},
};

const Format& format_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    std::string known;
    for (const Format& format : kFormats) {
        if (format.ending == ending) return format;
        known += (known.empty() ? "" : " or ") + std::string(format.ending);
    }
    throw Error({path}, "unknown picture format \"" + ending + "\"", "end the name in " + known);
}

}  // namespace

void check_picture_path(const std::string& path) {
    format_of(path);
    check_writable(path);
}

void write_picture(const std::string& path, const Picture& picture,
                   const PictureFileOptions& options) {
    format_of(path).write(path, picture, options);
}

}  // namespace sunfleck

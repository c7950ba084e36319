// Which flags belong to which formats.
#include "apps/cli/picture_flags.h"

#include "apps/cli/flag_rows.h"
#include "core/small_letters.h"
#include "image/exr_layers.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace sunfleck::engine {
namespace {

/// Flags by the beginning of their names, and the endings that they are for.
struct FlagEndings {
    std::string_view begin;
    std::vector<std::string> endings;
};

const std::vector<std::string>& endings_of(const std::string& flag) {
    static const std::vector<std::string> kScreen = {".png", ".jpg", ".jpeg"};
    static const std::array<FlagEndings, 3> kRows = {
        {{"--png-", {".png"}}, {"--jpeg-", {".jpg", ".jpeg"}}, {"--exr-", {".exr"}}}};
    for (const FlagEndings& row : kRows)
        if (flag.starts_with(row.begin)) return row.endings;
    return kScreen;
}

bool has_ending(const std::string& file, const std::vector<std::string>& endings) {
    const std::string ending = small_ending(file);
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// Returns whether the page of --view does what the flag says.
bool is_of_page(const std::string& flag) {
    return flag == "--tone" || flag == "--white-balance";
}

}  // namespace

void add_page_flags(CLI::App& app, RenderFlags& flags) {
    for (const char* flag : {"--exposure", "--tone", "--white-balance"})
        add_flag(app, render_flag(flag), flags);
}

void add_picture_flags(CLI::App& app, RenderFlags& flags) {
    add_flag(app, render_flag("--exposure"), flags);
    for (const RenderFlag& row : render_flags())
        if (row.group == kPictureFilesGroup) add_flag(app, row, flags);
}

void check_picture_flags(const CLI::App& given, const std::vector<std::string>& files,
                         bool has_page) {
    for (const RenderFlag& row : render_flags()) {
        if (row.group != kPictureFilesGroup || given.count(row.name) == 0) continue;
        if (has_page && is_of_page(row.name)) continue;
        const std::vector<std::string>& endings = endings_of(row.name);
        if (std::any_of(files.begin(), files.end(),
                        [&](const std::string& file) { return has_ending(file, endings); }))
            continue;
        throw Error({row.name}, fmt::format("no output is a {}", fmt::join(endings, " or ")),
                    "leave it out, or add -o FILE" + endings.front());
    }
}

void check_half_layers(const ExrOptions& options, const std::vector<std::string>& layers) {
    for (const std::string& name : options.half_layers)
        if (std::find(layers.begin(), layers.end(), name) == layers.end())
            throw Error({"--exr-half"}, "the picture has no layer \"" + name + "\"",
                        fmt::format("use all, or some of {}", fmt::join(layers, ", ")));
}

void check_half_layers(const ExrOptions& options, const Picture& picture) {
    std::vector<std::string> layers;
    for (const ExrLayer& layer : exr_layers(picture)) layers.push_back(layer.name);
    check_half_layers(options, layers);
}

}  // namespace sunfleck::engine

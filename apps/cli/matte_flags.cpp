// Kinds of mattes by name; an .exr that keeps their IDs.
#include "apps/cli/matte_flags.h"

#include "apps/cli/flag_rows.h"
#include "core/named_rows.h"
#include "core/small_letters.h"
#include "image/id_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <sstream>

namespace sunfleck::engine {
namespace {

constexpr const char* kMatteFlag = "--cryptomatte";

std::vector<MatteKind> read_matte_kinds(const std::string& text, const std::string& flag) {
    std::vector<MatteKind> kinds;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        const auto* const row = row_named(kMatteKinds, word);
        if (row == nullptr)
            throw Error(
                {flag}, "there is no matte \"" + word + "\"",
                "use " + form_of_names(kMatteKinds, " or ") + ", or both with a comma between");
        if (std::find(kinds.begin(), kinds.end(), row->kind) == kinds.end())
            kinds.push_back(row->kind);
    }
    if (kinds.empty())
        throw Error({flag}, "names no matte", "use " + form_of_names(kMatteKinds, " or "));
    return kinds;
}

std::uint32_t read_matte_samples(const std::string& text, const std::string& flag) {
    constexpr std::int64_t kLeast = 16;
    constexpr std::int64_t kMost = 4096;
    const auto samples = static_cast<std::uint32_t>(whole_from(kLeast, kMost)(text, flag));
    if (std::has_single_bit(samples)) return samples;
    throw Error({flag}, text + " is no power of two",
                fmt::format("use {} or {}", std::bit_floor(samples), std::bit_ceil(samples)));
}

bool is_exr(const std::string& file) {
    return small_ending(file) == ".exr";
}

}  // namespace

void add_matte_flags(CLI::App& app, RenderOptions& o) {
    CLI::Option* const kinds =
        add_value(app,
                  {.name = kMatteFlag,
                   .form = form_of_names(kMatteKinds, ","),
                   .help = "Mattes of objects and materials for compositing, as EXR layers",
                   .group = "Picture"},
                  o.mattes.kinds, read_matte_kinds);
    kinds->option_text("NAME,...");
    add_value(app,
              {.name = "--cryptomatte-samples",
               .form = "N",
               .help = fmt::format("Camera rays of a pixel for mattes: a power of two, 16 to 4096 "
                                   "(default {})",
                                   kUsualMatteSamples),
               .group = "Picture"},
              o.mattes.samples, read_matte_samples)
        ->needs(kinds);
}

void check_mattes(const RenderOptions& o) {
    if (o.mattes.kinds.empty()) return;
    if (!o.outputs.empty() && std::none_of(o.outputs.begin(), o.outputs.end(), is_exr))
        throw Error({kMatteFlag}, "no output is an .exr", "leave it out, or add -o FILE.exr");
    if (!is_exact(o.request.files.exr.compression))
        throw Error({kMatteFlag}, "--exr-compression dwaa and dwab would change the IDs of mattes",
                    "use zip or piz");
}

}  // namespace sunfleck::engine

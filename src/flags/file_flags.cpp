// The rows of the flags of picture files: how light becomes values, and how these are stored.
#include "flags/flag_tables.h"
#include "image/picture_file.h"
#include "sunfleck/error.h"

#include <sstream>

namespace sunfleck::engine {
namespace {

constexpr double kLeastKelvin = 1000;
constexpr double kMostKelvin = 25000;
constexpr double kMostVignette = 20;

FlagValue kelvin_value() {
    FlagValue value = number(kLeastKelvin, kMostKelvin, [](auto& r, const auto& kelvin) {
        r.files.transform.white_balance = kelvin;
    });
    value.form = "KELVIN";
    return value;
}

/// "all", or names of layers, separated by commas.
FlagValue half_value() {
    return {.form = "all|NAME,...",
            .read = [](RenderRequest& r, const std::string& text, const std::string& flag) {
                if (text == "all") {
                    r.files.exr.half = true;
                    return;
                }
                std::istringstream names(text);
                for (std::string name; std::getline(names, name, ',');)
                    if (!name.empty()) r.files.exr.half_layers.push_back(name);
                if (r.files.exr.half_layers.empty())
                    throw Error({flag}, "names no layer",
                                "write all, or for instance albedo,normal");
            }};
}

std::vector<RenderFlag> transform_flags() {
    return {
        {.name = "--tone",
         .value = one_of(choices_of(kTones),
                         [](auto& r, const auto& name) {
                             r.files.transform.tone = row_named(kTones, name)->value;  // a choice
                         }),
         .help = "Tone curve of .png and .jpg"},
        {.name = "--white-balance",
         .value = kelvin_value(),
         .help = "Light of this temperature becomes white, in .png and .jpg",
         .default_value = "6504, which is as it is"},
        {.name = "--glare",
         .value = number(0, 1, [](auto& r, const auto& share) { r.files.transform.glare = share; }),
         .help = "Fraction of the light that the eye scatters, in .png and .jpg",
         .default_value = "0"},
        {.name = "--vignette",
         .value = number(0, kMostVignette,
                         [](auto& r, const auto& stops) { r.files.transform.vignette = stops; }),
         .help = "Stops by which the corners are darker, in .png and .jpg",
         .default_value = "0"},
    };
}

}  // namespace

std::vector<RenderFlag> file_flags() {
    std::vector<RenderFlag> rows = transform_flags();
    for (RenderFlag& row : std::vector<RenderFlag>{
             {.name = "--png-bits",
              .value =
                  one_of({{"8"}, {"16"}},
                         [](auto&r, const auto&bits) { r.files.png_bits = bits == "16" ? 16 : 8; }),
              .help = "Bits of a value of a .png"},
             {.name = "--jpeg-quality",
             .value = whole(1, 100,
                            [](auto&r, const auto&quality) {
                                r.files.jpeg_quality = static_cast<int>(quality);
                            }),
             .help = "Quality of a .jpg",
             .default_value = std::to_string(kUsualJpegQuality)},
             {.name = "--exr-compression",
             .value = one_of(choices_of(kExrCompressions),
                             [](auto&r, const auto&name) {
                                 r.files.exr.compression =
                                     row_named(kExrCompressions, name)->value;  // a choice
                             }),
             .help = "Compression of an .exr",
             .default_value = "zip"},
             {.name = "--exr-half",
             .value = half_value(),
             .help = "16-bit floats in an .exr: in all layers, or in these",
             .default_value = "none"},
             {.name = "--exr-parts",
             .value = one_of({{"one"}, {"layers", "each layer is a part that has its name"}},
                             [](auto&r, const auto&name) { r.files.exr.parts = name == "layers"; }),
             .help = "Parts of an .exr"},
         })
        rows.push_back(std::move(row));
    return rows;
}

}  // namespace sunfleck::engine

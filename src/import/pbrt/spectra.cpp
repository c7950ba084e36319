// Spectra as pbrt-v4 gives them: paramdict.cpp there, measured for lights.
#include "import/pbrt/spectra.h"

#include "core/file_content.h"
#include "import/pbrt/numbers.h"
#include "import/pbrt/version3.h"
#include "import/pbrt/words.h"
#include "math/colour.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace sunfleck::engine {
namespace {

using Points = std::vector<TabulatedSpectrum::Point>;

void want(bool right, const Parameter& parameter, const std::string& fault,
          const std::string& mend) {
    if (!right) throw Error(parameter.where, "parameter " + parameter.title() + fault, mend);
}

std::string shown(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", number);
    return text.data();
}

/// In linear sRGB, negative components cut with a warning.
Vec3 in_srgb(const Parameter& parameter, SpectrumUse use, ImportLog& log) {
    const auto& v = parameter.numbers;
    const Triple given{v[0], v[1], v[2]};
    const bool light = use == SpectrumUse::emission;
    Triple rgb =
        light ? srgb_of_light(parameter.space, given) : srgb_of_surface(parameter.space, given);
    const auto [least, most] = std::minmax_element(rgb.begin(), rgb.end());
    constexpr double kRounding = 1e-3;
    const bool too_bright = use == SpectrumUse::reflectance && *most > 1 + kRounding &&
                            parameter.space != ColourSpace::srgb;
    if (*least < -kRounding * *most || too_bright)
        log.warn(parameter.where, "parameter " + parameter.title() +
                                      " is no colour of sRGB: what is beyond it is cut off");
    for (double& c : rgb) c = std::max(c, 0.0);
    return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
}

/// A surface reflects at most all light: where it is made of a spectrum, the rest is cut off.
void warn_above_one(double most, const Parameter& parameter, const std::string& of,
                    ImportLog& log) {
    constexpr double kRounding = 1e-3;
    constexpr double kPercentages = 2;
    if (!(most > 1 + kRounding)) return;
    log.warn(parameter.where, "parameter " + parameter.title() + of + " goes up to " + shown(most) +
                                  ": what is above 1 is cut off" +
                                  (most >= kPercentages && most <= 100
                                       ? "; are these percentages? divide them by 100"
                                       : ""));
}

Spectrum rgb_curve(const Parameter& parameter, SpectrumUse use, ImportLog& log) {
    const auto& v = parameter.numbers;
    want(v.size() == 3, parameter, " has " + std::to_string(v.size()) + " numbers", "give 3");
    want(*std::min_element(v.begin(), v.end()) >= 0, parameter, " has a negative component",
         "use components of 0 or more");
    if (use == SpectrumUse::reflectance)
        warn_above_one(*std::max_element(v.begin(), v.end()), parameter, "", log);
    const Vec3 rgb = in_srgb(parameter, use, log);
    if (use == SpectrumUse::emission) return Spectrum::rgb_illuminant(rgb);
    if (use == SpectrumUse::reflectance) return Spectrum::rgb_albedo(rgb);
    return Spectrum::rgb_unbounded(rgb);
}

/// Warns of a table that says nothing of visible light.
void warn_invisible(const Points& points, const Parameter& parameter, const std::string& of,
                    ImportLog& log) {
    constexpr float kMicrometres = 100;
    if (points.back().nm >= kFirstNm && points.front().nm <= kLastNm) return;
    log.warn(parameter.where, "parameter " + parameter.title() + of +
                                  " has no point within 360 to 830 nm" +
                                  (points.back().nm < kMicrometres
                                       ? ": are its wavelengths micrometres? multiply them by 1000"
                                       : ""));
}

/// The first and the last value go on to the ends of visible light.
void extend(Points& points, const Parameter& parameter, const std::string& of, ImportLog& log) {
    const TabulatedSpectrum::Point first = points.front();
    const TabulatedSpectrum::Point last = points.back();
    if (first.nm <= kFirstNm && last.nm >= kLastNm) return;
    if (last.nm < kLastNm) points.push_back({kLastNm, last.value});
    if (first.nm > kFirstNm) points.insert(points.begin(), {kFirstNm, first.value});
    log.warn(parameter.where, "parameter " + parameter.title() + of + " is given from " +
                                  shown(first.nm) + " to " + shown(last.nm) +
                                  " nm: beyond, its end values go on");
}

/// @param of  the file it stands in, or "".
Spectrum sampled(const std::vector<double>& numbers, const Parameter& parameter, SpectrumUse use,
                 const std::string& of, ImportLog& log) {
    want(!numbers.empty() && numbers.size() % 2 == 0, parameter,
         of + " has " + std::to_string(numbers.size()) + " numbers",
         "give pairs of wavelength in nm and value");
    Points points;
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
        points.push_back({static_cast<float>(numbers[i]), static_cast<float>(numbers[i + 1])});
        want(i == 0 || points[i / 2 - 1].nm < points[i / 2].nm, parameter,
             of + " has wavelengths that do not rise", "sort the pairs by wavelength");
        want(points.back().value >= 0, parameter, of + " has a negative value",
             "use values of 0 or more");
    }
    warn_invisible(points, parameter, of, log);
    if (use == SpectrumUse::index) extend(points, parameter, of, log);
    if (use == SpectrumUse::reflectance) {
        const auto most = std::max_element(points.begin(), points.end(),
                                           [](auto& a, auto& b) { return a.value < b.value; });
        warn_above_one(most->value, parameter, of, log);
    }
    return Spectrum::table(std::move(points));
}

}  // namespace

/// Pairs of numbers in a text file, with # comments.
Spectrum SpectrumReader::from_file(const std::string& name, const Parameter& parameter,
                                   SpectrumUse use) {
    const auto numbers = files_.read_as(name, parameter.where, [](NamedFile file) {
        refuse_other_content(file.bytes, file.path, "a spectrum");
        Lexer lexer(std::move(file.bytes), file.path);
        std::vector<double> all;
        while (const auto token = lexer.next()) all.push_back(real_of(*token));
        return all;
    });
    return sampled(numbers, parameter, use, " (file " + in_quotes(name) + ")", log_);
}

Spectrum SpectrumReader::by_name(const Parameter& parameter, SpectrumUse use) {
    const std::string& name = parameter.texts[0];
    if (auto known = named_spectrum(name)) return *known;
    const bool prefix =
        name.starts_with("metal-") || name.starts_with("glass-") || name.starts_with("stdillum-");
    if (prefix && name.find('.') == std::string::npos) {
        const std::vector<std::string> names = named_spectra();
        const std::vector<std::string_view> views(names.begin(), names.end());
        throw Error(parameter.where, "unknown spectrum " + in_quotes(name),
                    did_you_mean(views, name));
    }
    return from_file(name, parameter, use);
}

Spectrum SpectrumReader::raw_curve(const Parameter& parameter, SpectrumUse use) {
    if (parameter.type == ParameterType::blackbody) {
        if (parameter.numbers.size() == 2)  // a temperature and a factor
            refuse_v3("the parameter " + parameter.title() + " of two numbers", parameter.where);
        want(parameter.numbers.size() == 1 && parameter.numbers[0] > 0, parameter,
             " is no temperature", "give one positive number of kelvin");
        return Spectrum(BlackbodySpectrum{static_cast<float>(parameter.numbers[0])});
    }
    want(parameter.type == ParameterType::spectrum, parameter, " is no spectrum",
         "write \"rgb " + parameter.name + "\" or \"spectrum " + parameter.name + "\"");
    if (parameter.texts.empty()) return sampled(parameter.numbers, parameter, use, "", log_);
    want(parameter.texts.size() == 1 && parameter.numbers.empty(), parameter,
         " mixes names and numbers", "give one name, or pairs of numbers");
    return by_name(parameter, use);
}

Spectrum SpectrumReader::curve(const Parameter& parameter, SpectrumUse use) {
    if (parameter.type == ParameterType::rgb) return rgb_curve(parameter, use, log_);
    Spectrum raw = raw_curve(parameter, use);
    if (use != SpectrumUse::emission) return raw;
    const float luminance = raw.luminance();
    if (luminance > 1e-30F) return raw.scaled(1 / luminance);
    log_.warn(parameter.where, "parameter " + parameter.title() + " emits nothing visible");
    return Spectrum::constant(0);
}

std::optional<Spectrum> SpectrumReader::find(const Statement& statement, std::string_view name,
                                             SpectrumUse use) {
    const Parameter* found = statement.find(name);
    if (!found) return std::nullopt;
    return curve(*found, use);
}

Spectrum SpectrumReader::emission(const Statement& statement, std::string_view name,
                                  ColourSpace present) {
    const auto given = find(statement, name, SpectrumUse::emission);
    if (given) return *given;
    if (present != ColourSpace::aces2065_1) return Spectrum::d65();
    const Spectrum white = *named_spectrum("illum-acesD60");
    return white.scaled(1 / white.luminance());
}

}  // namespace sunfleck::engine

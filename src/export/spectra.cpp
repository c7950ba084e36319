// Search for the colours of smooth spectra, and tables of others.
#include "export/spectra.h"

#include "math/colour.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace sunfleck::engine {
namespace {

using Points = std::vector<TabulatedSpectrum::Point>;

Spectrum of_colour(const Vec3& rgb, ColourUse use) {
    if (use == ColourUse::albedo) return Spectrum::rgb_albedo(rgb);
    return use == ColourUse::unbounded ? Spectrum::rgb_unbounded(rgb)
                                       : Spectrum::rgb_illuminant(rgb);
}

/// Returns whether two curves agree within `error` of their greatest value.
bool agree(const Spectrum& a, const Spectrum& b, float error) {
    float most = 0;
    float difference = 0;
    for (int nm = kFirstNm; nm <= kLastNm; ++nm) {
        const float at_a = a(static_cast<float>(nm));
        const float at_b = b(static_cast<float>(nm));
        most = std::max({most, std::abs(at_a), std::abs(at_b)});
        difference = std::max(difference, std::abs(at_a - at_b));
    }
    return difference <= error * most;
}

/// Returns the colour that has such a spectrum: with as few decimals as it takes for the very
/// curve, else as the spectrum shows it; nothing if no colour has it.
std::optional<Vec3> colour_of(SigmoidSpectrum curve, ColourUse use) {
    const Spectrum given(curve);
    const bool is_light = use == ColourUse::illuminant;
    if (curve.times_d65 != is_light) return {};
    if (use == ColourUse::albedo && curve.scale != 1) return {};
    curve.times_d65 = true;
    const Vec3 seen = Spectrum(curve).to_rgb();
    const float most = std::max({seen.x, seen.y, seen.z});
    constexpr float kSeen = 1e-4F;  // error of the colour seen, of its greatest component
    constexpr int kMostDigits = 7;
    double step = 1;
    for (int digit = 0; digit <= kMostDigits; ++digit, step *= 10) {
        Vec3 rgb;
        for (int c = 0; c < 3; ++c)
            rgb[c] = static_cast<float>(std::max(0.0, std::round(seen[c] * step)) / step);
        const Vec3 off = rgb - seen;
        if (std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}) > kSeen * most) continue;
        if (use == ColourUse::albedo && std::max({rgb.x, rgb.y, rgb.z}) > 1) continue;
        const bool is_last = digit == kMostDigits;
        if (agree(of_colour(rgb, use), given, is_last ? kCurveError : 0)) return rgb;
    }
    return {};
}

std::string table_text(const Points& points) {
    std::string text;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) text += i % 6 == 0 ? "\n        " : "  ";
        text += exact_number(points[i].nm) + ' ' + exact_number(points[i].value);
    }
    return text;
}

/// Returns the points of a table, or those of a sparse one.
Points points_of(const Spectrum& curve) {
    const auto values_at = [&](const Points& places) {
        Points points;
        for (const auto& place : places) points.push_back({place.nm, curve(place.nm)});
        return points;
    };
    if (const auto* table = std::get_if<TabulatedSpectrum>(&curve.kind());
        table && table->points && !table->points->empty())
        return values_at(*table->points);
    if (curve.is_constant()) return values_at({{kFirstNm, 0}, {kLastNm, 0}});
    return points_of(sparse_table(curve));
}

void add_table(StatementText& statement, std::string_view name, const Spectrum& curve) {
    statement.add("spectrum", name, table_text(points_of(curve)));
}

/// Adds an emission that pbrt-v4 divides by its luminance.
void add_other_emission(StatementText& statement, std::string_view name, const Spectrum& curve,
                        std::string_view scale) {
    if (!(curve.luminance() > 0)) return statement.add("rgb", name, Vec3(0));
    if (const auto* black_body = std::get_if<BlackbodySpectrum>(&curve.kind())) {
        statement.add("blackbody", name, exact_number(black_body->kelvin));
        return statement.add(scale, curve.luminance());
    }
    const Spectrum written = Spectrum::table(points_of(curve));
    add_table(statement, name, written);
    statement.add(scale, written.luminance());
}

}  // namespace

Spectrum sparse_table(const std::function<float(float)>& curve) {
    Points all;
    float most = 0;
    for (int nm = kFirstNm; nm <= kLastNm; ++nm) {
        all.push_back({static_cast<float>(nm), curve(static_cast<float>(nm))});
        most = std::max(most, std::abs(all.back().value));
    }
    const auto is_straight = [&](std::size_t from, std::size_t to) {
        const float slope = (all[to].value - all[from].value) / (all[to].nm - all[from].nm);
        for (std::size_t i = from + 1; i < to; ++i) {
            const float on_line = all[from].value + slope * (all[i].nm - all[from].nm);
            if (std::abs(on_line - all[i].value) > kCurveError * most) return false;
        }
        return true;
    };
    Points kept{all.front()};
    for (std::size_t at = 0; at + 1 < all.size();) {
        std::size_t next = at + 1;
        while (next + 1 < all.size() && is_straight(at, next + 1)) ++next;
        kept.push_back(all[next]);
        at = next;
    }
    return Spectrum::table(std::move(kept));
}

void add_spectrum(StatementText& statement, std::string_view name, const Spectrum& curve,
                  ColourUse use) {
    const float value = curve(kFirstNm);
    const bool is_grey = curve.is_constant() && value >= 0 &&
                         (use == ColourUse::unbounded || (use == ColourUse::albedo && value <= 1));
    if (is_grey) return statement.add("rgb", name, Vec3(value));
    if (const auto* smooth = std::get_if<SigmoidSpectrum>(&curve.kind())) {
        SigmoidSpectrum scaled = *smooth;
        scaled.scale *= curve.factor();
        if (const auto rgb = colour_of(scaled, use)) return statement.add("rgb", name, *rgb);
    }
    add_table(statement, name, curve);
}

void add_index(StatementText& statement, std::string_view name, const Spectrum& eta) {
    if (eta.is_constant()) return statement.add(name, eta(kFirstNm));
    add_table(statement, name, eta);
}

void add_emission(StatementText& statement, std::string_view name, const Spectrum& curve,
                  std::string_view scale) {
    if (is_d65(curve)) return statement.add("rgb", name, Vec3(curve.factor()));
    if (const auto* smooth = std::get_if<SigmoidSpectrum>(&curve.kind()))
        if (const auto rgb = colour_of(*smooth, ColourUse::illuminant)) {
            statement.add("rgb", name, *rgb);
            if (curve.factor() != 1) statement.add(scale, curve.factor());
            return;
        }
    add_other_emission(statement, name, curve, scale);
}

bool is_d65(const Spectrum& curve) {
    const auto* table = std::get_if<TabulatedSpectrum>(&curve.kind());
    static const Spectrum white_curve = Spectrum::d65();
    return table != nullptr &&
           table->points == std::get<TabulatedSpectrum>(white_curve.kind()).points;
}

}  // namespace sunfleck::engine

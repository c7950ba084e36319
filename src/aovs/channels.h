// The table of AOVs that a pass measures per pixel.
#pragma once

#include "core/named_rows.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace sunfleck::engine {

enum class Aov : std::size_t {
    total,     // all light, radiance
    direct,    // emitter to visible surface without scattering in between
    caustic,   // from an emitter by specular surfaces alone
    indirect,  // scattered by a rough surface before
    emission,  // emitters seen directly, through glass or in mirrors
    albedo,    // reflectance of the first surface in white light
    normal,    // shading normal of the first surface, in the world
    depth,     // distance to the first surface along the ray; 0 for none
    samples,   // photons gathered per pass, weighted like the pass; states of the paper's chain
               // count with their repeats
    transmittance,  // what media leave of white light from the first surface, or from afar
    count
};

struct AovRow {
    Aov aov;
    std::string_view name;      // in flags, and as prefix of EXR channels
    std::string_view channels;  // one letter each, at most three
};

inline constexpr std::size_t kAovCount = static_cast<std::size_t>(Aov::count);

inline constexpr std::array<AovRow, kAovCount> kAovs = {{
    {Aov::total, "", "RGB"},
    {Aov::direct, "direct", "RGB"},
    {Aov::caustic, "caustic", "RGB"},
    {Aov::indirect, "indirect", "RGB"},
    {Aov::emission, "emission", "RGB"},
    {Aov::albedo, "albedo", "RGB"},
    {Aov::normal, "normal", "XYZ"},
    {Aov::depth, "depth", "Z"},
    {Aov::samples, "samples", "N"},
    {Aov::transmittance, "transmittance", "RGB"},
}};

/// Returns whether a light group may have this name: a letter, then letters, digits, _ and -.
constexpr bool is_aov_name(std::string_view name) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    if (name.empty() || !is_letter(name[0])) return false;
    for (const char c : name)
        if (!is_letter(c) && !(c >= '0' && c <= '9') && c != '_' && c != '-') return false;
    return true;
}

/// Returns whether every picture has another AOV of that name.
constexpr bool is_taken_aov_name(std::string_view name) {
    return row_named(kAovs, name) != nullptr || name == "error" || name == "bias";
}

}  // namespace sunfleck::engine

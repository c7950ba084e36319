// The AOVs of light and features that a pass measures for each pixel: one row each.
#pragma once

#include "core/named_rows.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace sunfleck::engine {

enum class Aov : std::size_t {
    total,     // all light, radiance
    direct,    // light that comes straight from an emitter to what is seen
    caustic,   // light from an emitter by way of smooth glass or metal alone
    indirect,  // light that has met a rough surface before
    emission,  // emitters seen by themselves, through glass or in mirrors
    albedo,    // share of white light reflected by the first surface
    normal,    // shading normal of the first surface, world frame
    depth,     // distance to the first surface along the ray; 0 for none
    samples,   // photons gathered, a pass, each pass as often as it counts; a state of the paper's
               // chain as often as it stood
    count
};

struct AovRow {
    Aov aov;
    std::string_view name;      // as the user writes it and as EXR channels begin
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
}};

/// Can a light group be called so? A letter, then letters, digits, _ and -.
constexpr bool is_aov_name(std::string_view name) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    if (name.empty() || !is_letter(name[0])) return false;
    for (const char c : name)
        if (!is_letter(c) && !(c >= '0' && c <= '9') && c != '_' && c != '-') return false;
    return true;
}

/// Is there another AOV of that name in each picture?
constexpr bool is_taken_aov_name(std::string_view name) {
    return row_named(kAovs, name) != nullptr || name == "error" || name == "bias";
}

}  // namespace sunfleck::engine

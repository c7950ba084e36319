// The layers of light and features that a pass measures for each pixel: one row each.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace sunfleck {

enum class Layer : std::size_t {
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

struct LayerRow {
    Layer layer;
    std::string_view name;      // as the user writes it and as EXR channels begin
    std::string_view channels;  // one letter each, at most three
};

inline constexpr std::size_t kLayerCount = static_cast<std::size_t>(Layer::count);

inline constexpr std::array<LayerRow, kLayerCount> kLayers = {{
    {Layer::total, "", "RGB"},
    {Layer::direct, "direct", "RGB"},
    {Layer::caustic, "caustic", "RGB"},
    {Layer::indirect, "indirect", "RGB"},
    {Layer::emission, "emission", "RGB"},
    {Layer::albedo, "albedo", "RGB"},
    {Layer::normal, "normal", "XYZ"},
    {Layer::depth, "depth", "Z"},
    {Layer::samples, "samples", "N"},
}};

/// Can a layer of some lights be called so? A letter, then letters, digits, _ and -.
constexpr bool is_layer_name(std::string_view name) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    if (name.empty() || !is_letter(name[0])) return false;
    for (const char c : name)
        if (!is_letter(c) && !(c >= '0' && c <= '9') && c != '_' && c != '-') return false;
    return true;
}

/// Is there another layer of that name in each picture?
constexpr bool is_taken_layer_name(std::string_view name) {
    for (const LayerRow& row : kLayers)
        if (row.name == name) return true;
    return name == "error" || name == "bias";
}

}  // namespace sunfleck

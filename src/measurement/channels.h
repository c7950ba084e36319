// The layers of light and features that a pass measures for each pixel: one row each.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace sunfleck {

enum class Layer : std::size_t {
    total,
    direct,
    caustic,
    indirect,
    emission,
    albedo,
    normal,
    depth,
    samples,
    count
};

struct LayerRow {
    Layer layer;
    std::string_view name;      // as the user writes it and as EXR channels begin
    std::string_view channels;  // one letter each, at most three
    std::string_view what;
};

inline constexpr std::size_t kLayerCount = static_cast<std::size_t>(Layer::count);

inline constexpr std::array<LayerRow, kLayerCount> kLayers = {{
    {Layer::total, "", "RGB", "all light, radiance"},
    {Layer::direct, "direct", "RGB", "light that comes straight from an emitter to what is seen"},
    {Layer::caustic, "caustic", "RGB",
     "light from an emitter by way of smooth glass or metal alone"},
    {Layer::indirect, "indirect", "RGB", "light that has met a rough surface before"},
    {Layer::emission, "emission", "RGB",
     "emitters seen by themselves, through glass or in mirrors"},
    {Layer::albedo, "albedo", "RGB", "share of white light reflected by the first surface"},
    {Layer::normal, "normal", "XYZ", "shading normal of the first surface, world frame"},
    {Layer::depth, "depth", "Z", "distance to the first surface along the ray; 0 for none"},
    {Layer::samples, "samples", "N",
     "photons gathered, a pass, each pass as often as it counts; a state of the paper's chain as "
     "often as it stood"},
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

// Lights by source, and their weights.
#include "scene/scene_lights.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Returns the weight of a light, its emission in the visible range: power times luminance.
double weight_of(const Light& light, const SceneSphere& sphere) {
    return power(light, sphere) * std::max(0.0F, curve(light).luminance());
}

}  // namespace

void SceneLights::add(const std::vector<AreaLight>& of_shape, std::uint32_t stated_in) {
    sources_.push_back(
        {static_cast<std::uint32_t>(all_.size()), static_cast<std::uint32_t>(of_shape.size())});
    all_.insert(all_.end(), of_shape.begin(), of_shape.end());
    stated_in_.insert(stated_in_.end(), of_shape.size(), stated_in);
}

void SceneLights::add(const Light& light, std::uint32_t stated_in) {
    sources_.push_back({static_cast<std::uint32_t>(all_.size()), 1});
    all_.push_back(light);
    stated_in_.push_back(stated_in);
}

void SceneLights::finish(const SceneSphere& sphere) {
    sphere_ = sphere;
    std::vector<double> weights;
    for (std::size_t i = 0; i < all_.size(); ++i) {
        const bool infinite = is_infinite(all_[i]);
        if (infinite) infinite_.push_back(static_cast<std::uint32_t>(i));
        const auto* area = std::get_if<AreaLight>(&all_[i]);
        if (infinite || (area != nullptr && !area->unseen)) has_lights_to_hit_ = true;
        weights.push_back(weight_of(all_[i], sphere_));
    }
    choice_ = LightChoice(weights);
    for (std::size_t i = 0; i < all_.size(); ++i)
        if (std::holds_alternative<MediumLight>(all_[i])) weights[i] = 0;
    tree_ = LightTree(all_, weights);
}

}  // namespace sunfleck::engine

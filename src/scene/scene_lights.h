// The lights of a scene: the sources and the statements that they come from, and how they are
// chosen.
//
// Filled light by light, then finished; after that any number of threads may ask.
#pragma once

#include "light/light_clusters.h"
#include "light/light_tree.h"
#include "scene/description.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

class SceneLights {
public:
    explicit SceneLights(std::vector<LightStatement> statements)
        : statements_(std::move(statements)) {}

    /// Adds the area lights of one shape. @param stated_in  their statement, or kNone.
    void add(const std::vector<AreaLight>& of_shape, std::uint32_t stated_in);
    /// Adds a light by itself. @param stated_in  its statement, or kNone.
    void add(const Light& light, std::uint32_t stated_in);
    /// Makes the choices by power. @param sphere  around the surfaces of the scene.
    void finish(const SceneSphere& sphere);

    const std::vector<Light>& all() const { return all_; }
    /// Indices of those that are infinite.
    const std::vector<std::uint32_t>& infinite() const { return infinite_; }
    /// Lights that belong together: those of one shape, or one by itself; in the order of all().
    const std::vector<LightRange>& sources() const { return sources_; }
    /// What the file says of lights, in its order.
    const std::vector<LightStatement>& statements() const { return statements_; }
    /// By light, the one of these that it comes from, or kNone.
    const std::vector<std::uint32_t>& stated_in() const { return stated_in_; }
    /// By power: photons start at lights chosen by it.
    const LightChoice& choice() const { return choice_; }
    /// By what arrives at a point: direct light is sampled at lights chosen by it.
    const LightTree& tree() const { return tree_; }
    const SceneSphere& sphere() const { return sphere_; }
    /// Are there lights that a ray can meet (area, infinite)?
    bool has_lights_to_meet() const { return has_lights_to_meet_; }
    /// Does any light emit in the visible range?
    bool has_power() const { return has_power_; }

private:
    std::vector<LightStatement> statements_;
    std::vector<Light> all_;
    std::vector<std::uint32_t> stated_in_;
    std::vector<LightRange> sources_;
    std::vector<std::uint32_t> infinite_;
    SceneSphere sphere_;
    LightChoice choice_;
    LightTree tree_;
    bool has_lights_to_meet_ = false;
    bool has_power_ = false;
};

}  // namespace sunfleck::engine

// SceneLights: the lights of a scene, their sources and statements, and their selection.
//
// Lights are added one by one, then finish() is called; after that all methods are thread-safe.
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
    /// Adds a single light. @param stated_in  its statement, or kNone.
    void add(const Light& light, std::uint32_t stated_in);
    /// Builds the distributions by power. @param sphere  bounding sphere of the scene.
    void finish(const SceneSphere& sphere);

    const std::vector<Light>& all() const { return all_; }
    /// Returns the indices of infinite lights.
    const std::vector<std::uint32_t>& infinite() const { return infinite_; }
    /// Returns the sources: the lights of one shape, or a single light; in the order of all().
    const std::vector<LightRange>& sources() const { return sources_; }
    /// Returns the light statements of the file, in its order.
    const std::vector<LightStatement>& statements() const { return statements_; }
    /// Returns the statement of each light, or kNone.
    const std::vector<std::uint32_t>& stated_in() const { return stated_in_; }
    /// Returns the selection by power, used for photon paths.
    const LightChoice& choice() const { return choice_; }
    /// Returns the selection by estimated contribution, used for direct light: of those that can be
    /// sampled from a point, all but MediumLight.
    const LightTree& tree() const { return tree_; }
    const SceneSphere& sphere() const { return sphere_; }
    /// Returns whether there are lights that a ray can hit (area, infinite).
    bool has_lights_to_hit() const { return has_lights_to_hit_; }
    /// Returns whether any light emits in the visible range, so that choice() has one to choose.
    bool has_power() const { return !choice_.empty(); }

private:
    std::vector<LightStatement> statements_;
    std::vector<Light> all_;
    std::vector<std::uint32_t> stated_in_;
    std::vector<LightRange> sources_;
    std::vector<std::uint32_t> infinite_;
    SceneSphere sphere_;
    LightChoice choice_;
    LightTree tree_;
    bool has_lights_to_hit_ = false;
};

}  // namespace sunfleck::engine

// What is rendered: views with tables of several sizes, other procedural scenes, and scene files.
#pragma once

#include <string>
#include <vector>

namespace sunfleck::engine::bench {

/// A way to part of the reference's light.
struct ReferencePart {
    std::string name;  // of its folder; equal for scenes that share it
    std::string scene_file;
    std::vector<std::string> flags;  // for `render`
    bool caustic_alone = false;      // its AOV "caustic" counts, or all of its light
};

/// A scene under test.
struct TestScene {
    std::string name;     // "wine-glass-2@10"
    std::string view;     // "wine-glass-2"
    double surround = 1;  // side of the table over the scene's own
    std::string scene_file;
    std::vector<ReferencePart> reference;  // their sum
};

/// Returns the views whose tables may have any size.
std::vector<std::string> view_names();

/// Writes the files of a view with tables of each size, below `folder`.
///
/// Photons that start at independent random places find a caustic best where there is little else
/// to hit: its light comes from them, on the smallest table that the picture needs. All other light
/// comes from path tracing, which knows nothing of photons.
std::vector<TestScene> scenes_of_view(const std::string& folder, const std::string& view,
                                      const std::vector<double>& surrounds);

/// Writes the files of another procedural scene, or takes a scene file (*.pbrt) as it is.
/// @param flags  for `render`: how its reference is made.
TestScene other_scene(const std::string& folder, const std::string& scene,
                      const std::vector<std::string>& flags);

}  // namespace sunfleck::engine::bench

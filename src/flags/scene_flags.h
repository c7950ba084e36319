// The flags of a scene: what a user says about it besides its file. Commands that read scenes have
// them all.
#pragma once

#include "import/scene_request.h"

#include <functional>
#include <string>
#include <vector>

namespace sunfleck::engine {

struct SceneFlag {
    std::string name;
    std::string form;  // of the value: a word in small letters is literal
    std::string help;
    std::vector<SceneFormat> formats;  // for which it has a meaning
    bool repeats = false;              // may be given several times
    /// Reads the text into the request. @throws Error that names the flag.
    std::function<void(SceneRequest&, const std::string& text, const std::string& flag)> read{};
};

const std::vector<SceneFlag>& scene_flags();

/// Returns the flag of that name, which may lack its dashes ("ground_albedo"). @throws Error  for
/// an unknown one.
const SceneFlag& scene_flag(const std::string& name);

/// Sets a flag of the request. @throws Error  for a text that cannot be used, and for a flag that
/// is given twice.
void set_scene_flag(SceneRequest& request, const SceneFlag& flag, const std::string& text);

/// Returns all flags as given, one a line; empty for none.
std::string text_of(const SceneRequest& request);

}  // namespace sunfleck::engine

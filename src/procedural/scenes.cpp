// The list of our own scenes, and the door to each.

#include "procedural/scenes.h"

#include "core/error.h"
#include "procedural/cognac.h"
#include "procedural/cornell.h"
#include "procedural/diamond.h"
#include "procedural/iced_tea.h"
#include "procedural/window_room.h"

namespace sunfleck {

std::vector<ProceduralScene> procedural_scenes() {
    std::vector<ProceduralScene> scenes = {{"cornell", "the Cornell box, 36 triangles"}};
    for (const CognacView& view : kCognacViews)
        scenes.push_back({std::string(view.name), std::string(view.what)});
    scenes.push_back({"window-room", "the sun through one pane into a closed room"});
    scenes.push_back({"diamond", "a brilliant in the sun, and the colours that it throws"});
    scenes.push_back({"iced-tea", "a tumbler of tea with ice under a clear sky"});
    return scenes;
}

std::vector<SceneFile> make_scene(const std::string& name) {
    if (name == "cornell") return cornell_scene();
    if (name == "window-room") return window_room_scene();
    if (name == "diamond") return diamond_scene();
    if (name == "iced-tea") return iced_tea_scene();
    for (const CognacView& view : kCognacViews)
        if (view.name == name) return cognac_scene(view);
    std::string known;
    for (const ProceduralScene& scene : procedural_scenes())
        known += (known.empty() ? "" : ", ") + scene.name;
    throw Error({"sunfleck scene"}, "there is no scene \"" + name + "\"", "use one of: " + known);
}

}  // namespace sunfleck

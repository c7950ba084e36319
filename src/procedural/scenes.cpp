// The list of procedural scenes and their functions.

#include "procedural/scenes.h"

#include "procedural/box.h"
#include "procedural/brandy.h"
#include "procedural/cognac.h"
#include "procedural/cornell.h"
#include "procedural/cornell_door.h"
#include "procedural/diamond.h"
#include "procedural/fog_lamp.h"
#include "procedural/iced_tea.h"
#include "procedural/keyhole.h"
#include "procedural/lamp_room.h"
#include "procedural/magnifier.h"
#include "procedural/milk.h"
#include "procedural/opal.h"
#include "procedural/pool.h"
#include "procedural/room.h"
#include "procedural/smoke.h"
#include "procedural/statue.h"
#include "procedural/two_windows.h"
#include "procedural/watch.h"
#include "procedural/window_room.h"
#include "procedural/wine_glass.h"
#include "sunfleck/error.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

struct Entry {
    ProceduralScene scene;
    std::vector<SceneFile> (*make)(const ProceduralScene&);
};

template <std::vector<SceneFile> (*Make)()>
std::vector<SceneFile> nameless(const ProceduralScene& /*scene*/) {
    return Make();
}

std::vector<SceneFile> cognac(const ProceduralScene& scene) {
    return cognac_scene(*std::find_if(kCognacViews.begin(), kCognacViews.end(),
                                      [&](const auto& view) { return view.name == scene.name; }));
}

std::vector<SceneFile> wine_glass(const ProceduralScene& scene) {
    return wine_glass_scene(
        *std::find_if(kWineGlassViews.begin(), kWineGlassViews.end(),
                      [&](const auto& view) { return view.name == scene.name; }));
}

std::vector<SceneFile> keyhole(const ProceduralScene& scene) {
    return keyhole_scene(*std::find_if(kKeyholes.begin(), kKeyholes.end(), [&](const auto& known) {
        return known.name == scene.name;
    }));
}

std::vector<Entry> entries() {
    std::vector<Entry> all = {
        {{"cornell", "the Cornell box, 36 triangles"}, nameless<cornell_scene>}};
    for (const CloseUp& view : kCognacViews)
        all.push_back({{std::string(view.name), std::string(view.what)}, cognac});
    const std::vector<Entry> others = {
        {{"window-room", "the sun through one pane into a closed room"}, window_room_scene},
        {{"window-room-lamp", "the same, and a lamp of 1/500 of the sun's power in it"},
         window_room_scene},
        {{"brandy", "a glass of brandy in a gap of the shade of leaves, the scene of make demo"},
         nameless<brandy_scene>},
        {{"diamond", "a brilliant in the sun, and the colours that it throws"},
         nameless<diamond_scene>},
        {{"iced-tea", "a tumbler of tea with ice under a clear sky"}, nameless<iced_tea_scene>},
        {{"cornell-door", "a Cornell box lit through a door ajar"}, cornell_door_scene},
        {{"two-windows", "a hall that the sun enters through two windows far apart"},
         two_windows_scene},
        {{"light-shafts", "the same hall, its windows open and full of mist"}, two_windows_scene},
        {{"box", "mirrored and glass balls lit by two lamps behind lenses"}, box_scene},
        {{"watch", "a pocket watch, its dial lit through glass and by its lid"}, watch_scene},
        {{"room", "a furnished room in the sun behind its windows"}, room_scene},
        {{"statue-far", "a polished knot of bronze on a pedestal"}, statue_scene},
        {{"statue-near", "a part of it, its highlights close up"}, statue_scene},
        {{"magnifier", "print under a reading glass, lit by a lamp in a globe of glass"},
         magnifier_scene},
        {{"useful-light", "a room by night, lit by a lamp that shines at the ceiling"},
         lamp_room_scene},
        {{"useless-light", "the same by day: a strong sun outside, and hardly any of it inside"},
         lamp_room_scene},
        {{"milk", "a glass of milk, and a drop of milk that sinks in a glass of water"},
         milk_scene},
        {{"fog-lamp", "the beam of a lamp through a keyhole into a dark room full of fog"},
         fog_lamp_scene},
        {{"opal", "things on a table in the glow of a lantern of opal glass"}, opal_scene},
        {{"pool", "under the waves of a pool: the sun's shafts in murky water"}, pool_scene},
        {{"smoke", "smoke that rises from a bowl through a narrow beam of light"}, smoke_scene},
    };
    all.insert(all.end(), others.begin(), others.end());
    for (const CloseUp& view : kWineGlassViews)
        all.push_back({{std::string(view.name), std::string(view.what)}, wine_glass});
    for (const Keyhole& one : kKeyholes)
        all.push_back({{std::string(one.name), std::string(one.what)}, keyhole});
    return all;
}

}  // namespace

std::vector<ProceduralScene> procedural_scenes() {
    std::vector<ProceduralScene> scenes;
    for (const Entry& entry : entries()) scenes.push_back(entry.scene);
    return scenes;
}

std::vector<SceneFile> make_scene(const std::string& name) {
    std::string known;
    for (const Entry& entry : entries()) {
        if (entry.scene.name == name) return entry.make(entry.scene);
        known += (known.empty() ? "" : ", ") + entry.scene.name;
    }
    throw Error({"sunfleck scene"}, "there is no scene \"" + name + "\"", "use one of: " + known);
}

}  // namespace sunfleck::engine

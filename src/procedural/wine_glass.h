// The scenes wine-glass-1 ... wine-glass-4: a filled wine glass in the sun on a large table, seen
// whole, and from ever closer to the dark side of its caustic.
#pragma once

#include "procedural/close_up.h"
#include "procedural/filled_glass.h"
#include "procedural/scene_file.h"

#include <array>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// Half the side of the square table in cm. What lies beyond the picture should not matter.
inline constexpr double kWineTableHalfWidth = 450;

/// Vertices of each ring of the glass.
inline constexpr std::size_t kWineGlassSegments = 256;

GlassCurves wine_glass_curves();

/// Each sees a third of the width of the one before.
inline constexpr std::array<CloseUp, 4> kWineGlassViews = {{
    {"wine-glass-1", "a filled wine glass in the sun, and its caustic on a large table", "3 2 6",
     "35"},
    {"wine-glass-2", "the shadow of the bowl, and the caustic in it", "8 5 0", "12"},
    {"wine-glass-3", "the point of the caustic, and the dark beside it", "6 4 0", "4"},
    {"wine-glass-4", "the same from a third of the width", "5.6 4 0", "1.33"},
}};

/// The table that the scenes have.
inline Mesh wine_glass_table() {
    return square_mesh(static_cast<float>(kWineTableHalfWidth), 0);
}

/// Returns the files of one scene. @param view  one of kWineGlassViews. @param table  another one
/// shows what the surround costs.
std::vector<SceneFile> wine_glass_scene(const CloseUp& view,
                                        const Mesh& table = wine_glass_table());

}  // namespace sunfleck::engine

// The room: walls closed but for the window, and the window closed by the pane. With a lamp it is
// the same room.

#include "procedural/window_room.h"

#include "core/random.h"
#include "mesh_checks.h"
#include "scene_reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

TEST(WindowRoom, the_masonry_is_closed_and_faces_out) {
    const Mesh walls = room_walls();
    EXPECT_TRUE(open_edges(walls).empty());
    EXPECT_NEAR(volume(walls), 5.4 * 4.4 * 3.1 - 5.0 * 4.0 * 2.7 - 0.6 * 0.7 * 0.2, 1e-5);
}

TEST(WindowRoom, the_pane_is_a_closed_slab) {
    const Mesh pane = window_pane();
    EXPECT_TRUE(open_edges(pane).empty());
    EXPECT_NEAR(volume(pane), 0.62 * 0.72 * 0.006, 1e-6);
}

/// From a point in the room every line meets the walls, or leaves by both faces of the pane.
TEST(WindowRoom, light_enters_only_through_the_pane) {
    const Mesh walls = room_walls();
    const Mesh pane = window_pane();
    RandomStream random(2, Purpose::test, 0, 0);
    int outward = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d from(4.8 * random.next() - 2.4, 3.8 * random.next() - 1.9, 2.6 * random.next());
        // Half of the lines aim around the window, half anywhere.
        const bool aimed = i % 2 == 0;
        const Vec3d to =
            aimed ? Vec3d(random.next(), 2.1, 1.2 + random.next())
                  : Vec3d(10 * random.next() - 5, 10 * random.next() - 5, 10 * random.next() - 5);
        const std::size_t at_walls = all_hits(walls, from, to - from).size();
        ASSERT_EQ(at_walls % 2, 0) << "the room and the outside are both free of masonry";
        if (at_walls > 0) continue;
        ++outward;
        ASSERT_EQ(all_hits(pane, from, to - from).size(), 2);
    }
    EXPECT_GT(outward, 2000);
}

std::string text_of(const std::string& scene) {
    return make_scene(scene).at(0).bytes;
}

TEST(WindowRoom, the_lamp_is_all_that_is_added) {
    const auto world = [](const std::string& text) { return text.substr(text.find("WorldBegin")); };
    const std::string with = world(text_of("window-room-lamp"));
    EXPECT_EQ(with.substr(0, with.find("\n# The lamp")), world(text_of("window-room")));
}

/// The sun's photons start on a disc that covers all there is: the ground, and the house on it.
TEST(WindowRoom, the_lamp_has_one_five_hundredth_of_the_suns_power) {
    const std::vector<std::string> words = pbrt_words(text_of("window-room-lamp"));
    const auto after = [&](const char* statement, const char* parameter) {
        const auto at = std::find(words.begin(), words.end(), statement);
        return std::stod(*(std::find(at, words.end(), parameter) + 1));
    };
    const double pi = std::acos(-1.0);
    const double radius = after("AttributeBegin", "\"float radius");
    const double lamp = pi * after("AreaLightSource", "\"float scale") * 4 * pi * radius * radius;
    const double sun = after("LightSource", "\"float scale") * pi * (2 * 10 * 10 + 1.55 * 1.55);
    EXPECT_NEAR(sun / lamp, 500, 25);
}

}  // namespace
}  // namespace sunfleck::engine

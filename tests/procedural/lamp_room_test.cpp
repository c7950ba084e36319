// The room by night and by day: one scene, but for a sun that no surface in view sees; nor the
// lamp.

#include "procedural/lamp_room.h"

#include "scene_parts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

std::string without(std::string text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin);
    if (from == std::string::npos) return text;
    return text.erase(from, text.find(end, from) + end.size() - from);
}

TEST(LampRoom, day_differs_from_night_by_the_sun_alone) {
    std::vector<SceneFile> night = make_scene("useful-light");
    std::vector<SceneFile> day = make_scene("useless-light");
    ASSERT_EQ(night.size(), day.size());
    for (std::size_t i = 1; i < day.size(); ++i) EXPECT_EQ(day[i].bytes, night[i].bytes);
    EXPECT_EQ(night[0].bytes.find("LightSource \"distant\""), std::string::npos);
    EXPECT_NE(day[0].bytes.find("LightSource \"distant\""), std::string::npos);
    const auto common = [](const std::string& text) {
        return without(without(text, "\n# The sun", "\"float scale\" 16\n"), "#", "WorldBegin");
    };
    EXPECT_EQ(common(day[0].bytes), common(night[0].bytes));
}

/// From the room no line goes out towards the sun; from the hall some do, through the slit.
TEST(LampRoom, the_sun_comes_into_the_hall_alone) {
    const Vec3d sun(0.02, 0.64, 0.77);
    const std::vector<Part> parts = parts_of("useless-light");
    RandomStream random(5, Purpose::test, 0, 0);
    int lit = 0;
    for (int i = 0; i < 4000; ++i) {
        const double y = -1.9 + 3.8 * random.next();
        const Vec3d room(-2.4 + 4.8 * random.next(), y, 0.1 + 2.4 * random.next());
        ASSERT_GT(faces_between(parts, room, room + sun * 30).opaque, 0U) << room;
        const Vec3d hall(-4.1 + 1.3 * random.next(), y, 0.1 + 2.4 * random.next());
        lit += faces_between(parts, hall, hall + sun * 30).opaque == 0 ? 1 : 0;
    }
    EXPECT_GT(lit, 5);
    EXPECT_LT(lit, 200);
}

/// The lamp shines up, from above all that the camera looks at.
TEST(LampRoom, no_surface_in_view_sees_the_lamp) {
    const std::vector<std::string> words = pbrt_words(make_scene("useful-light").at(0).bytes);
    const auto look = std::find(words.begin(), words.end(), "LookAt");
    const auto number = [&](int i) { return std::stod(*(look + 1 + i)); };
    const Vec3d from(number(0), number(1), number(2));
    const Vec3d ahead = (Vec3d(number(3), number(4), number(5)) - from).normalized();
    const Vec3d right = ahead.cross({0, 0, 1}).normalized();
    const Vec3d up = right.cross(ahead);
    const double edge = std::tan(20 * 3.14159265358979 / 180);
    for (const double side : {-1.0, 1.0})
        EXPECT_LT((ahead + (up + right * side) * edge).z, 0) << "the picture's upper corners";
    bool found = false;
    for (const Part& part : parts_of("useful-light")) {
        if (part.mesh.triangles.size() != 2 || part.mesh.points[0][2] < 0) continue;
        found = true;
        for (const auto& point : part.mesh.points) EXPECT_GT(point[2], from.z);
        const auto vertex = [&](std::size_t i) {
            const auto& p = part.mesh.points[part.mesh.triangles[0][i]];
            return Vec3d(p[0], p[1], p[2]);
        };
        EXPECT_GT((vertex(1) - vertex(0)).cross(vertex(2) - vertex(0)).z, 0);
    }
    EXPECT_TRUE(found);
}

}  // namespace
}  // namespace sunfleck::engine

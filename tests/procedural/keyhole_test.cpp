// The box with the keyhole: closed but for the hole, and the light that falls through it meets the
// pane.
#include "procedural/keyhole.h"

#include "scene_parts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

class EveryKeyhole : public testing::TestWithParam<Keyhole> {
protected:
    const KeyholeRoom& room_ = kKeyholeRoom;
    double half_ = GetParam().width / 2;
    std::vector<Part> parts_ = parts_of(std::string(GetParam().name));
    RandomStream random_{3, Purpose::test, 0, 0};

    double between(double low, double high) { return low + (high - low) * random_.next(); }

    /// Where light starts, above a place of the roof's plane.
    Vec3d above(double x, double y) {
        const Vec3d back = -room_.way * room_.lamp_distance;
        if (GetParam().light == KeyholeLight::sun) return Vec3d(x, y, room_.high[2]) + back;
        const double half_lamp = room_.lamp_width / 2;
        return Vec3d(0, 0, room_.high[2]) + back +
               Vec3d(between(-half_lamp, half_lamp), between(-half_lamp, half_lamp), -1e-6);
    }

    /// The material that a line meets first beyond its start; none: nothing.
    std::string met_first(const Vec3d& from, const Vec3d& direction) const {
        std::string met;
        double nearest = 1e9;
        for (const Part& part : parts_)
            for (const MeshHit& hit : all_hits(part.mesh, from, direction))
                if (hit.distance < nearest) {
                    nearest = hit.distance;
                    met = part.material;
                }
        return met;
    }
};

/// With a lid that fits the hole it is closed.
TEST_P(EveryKeyhole, is_closed_but_for_the_hole) {
    Mesh box = keyhole_walls(GetParam().width);
    box.append(keyhole_floor());
    EXPECT_EQ(open_edges(box).size(), 4);
    const auto half = static_cast<float>(half_);
    box.append(square_mesh(half, room_.high[2]));
    EXPECT_TRUE(open_edges(box).empty());
    EXPECT_NEAR(volume(box), 4.2 * 2.4 * 4, 1e-5);
}

/// Half of the lines aim at the hole, half at the roof around it.
TEST_P(EveryKeyhole, light_through_the_hole_meets_the_pane_first) {
    int through = 0;
    for (int i = 0; i < 4000; ++i) {
        const double reach = i % 2 == 0 ? 0.999 * half_ : 40 * half_;
        const double x = between(-reach, reach);
        const double y = between(-reach, reach);
        const bool inside = std::abs(x) < half_ && std::abs(y) < half_;
        const Vec3d from = above(x, y);
        const std::string met = met_first(from, Vec3d(x, y, room_.high[2]) - from);
        if (inside)
            ASSERT_EQ(met, "milk-glass") << x << ' ' << y;
        else
            ASSERT_NE(met, "milk-glass") << x << ' ' << y;
        through += inside ? 1 : 0;
    }
    EXPECT_GE(through, 2000);
}

/// From the camera to places of the view, and from the pane to them.
TEST_P(EveryKeyhole, the_view_is_floor_and_nothing_hides_the_pane) {
    const double half_view = room_.camera_height * std::tan(kPiDouble / 8);
    EXPECT_LT(room_.camera_height, room_.pane_height);
    const double half_pane = room_.pane_width / 2;
    for (int i = 0; i < 1000; ++i) {
        const Vec3d seen(between(-half_view, half_view), between(-half_view, half_view), 0);
        const Vec3d eye(0, 0, room_.camera_height);
        const Vec3d pane(between(-half_pane, half_pane), between(-half_pane, half_pane),
                         room_.pane_height - 1e-6);
        const Vec3d middle(room_.pane_x, 0, 0);
        ASSERT_EQ(met_first(middle + eye, seen - eye), "floor");
        ASSERT_EQ(met_first(middle + pane, seen - pane), "floor");
    }
}

/// What the scene's text says and the truth is worked out from.
TEST_P(EveryKeyhole, writes_its_numbers_into_the_file) {
    const std::string text = make_scene(std::string(GetParam().name)).at(0).bytes;
    EXPECT_EQ(text.find("LightSource \"distant\"") != std::string::npos,
              GetParam().light == KeyholeLight::sun);
    const std::vector<std::string> words = pbrt_words(text);
    const auto after = [&](const std::string& word, std::ptrdiff_t i) {
        return std::stod(*(std::find(words.begin(), words.end(), word) + i));
    };
    EXPECT_EQ(after("\"float scale", 1), GetParam().strength);
    EXPECT_EQ(after("\"float fov", 1), room_.field_of_view);
    const std::array<double, 9> look = {
        room_.pane_x, 0, room_.camera_height, room_.pane_x, 0, 0, 0, 1, 0};
    for (std::size_t i = 0; i < look.size(); ++i)
        EXPECT_EQ(after("LookAt", static_cast<std::ptrdiff_t>(i) + 1), look.at(i));
    const auto material = [&](const char* name) {
        return static_cast<std::size_t>(
            std::find(words.begin(), words.end(), std::string("\"") + name) - words.begin());
    };
    const auto grey = [](double value) { return std::vector<float>(3, static_cast<float>(value)); };
    EXPECT_EQ(pbrt_numbers(words, material("black"), "rgb reflectance"), grey(0));
    EXPECT_EQ(pbrt_numbers(words, material("floor"), "rgb reflectance"), grey(room_.reflectance));
    EXPECT_EQ(pbrt_numbers(words, material("milk-glass"), "rgb reflectance"), grey(0));
    EXPECT_EQ(pbrt_numbers(words, material("milk-glass"), "rgb transmittance"),
              grey(room_.transmittance));
    if (GetParam().light == KeyholeLight::sun) {
        const std::vector<float> from = {static_cast<float>(-room_.way.x), 0,
                                         static_cast<float>(-room_.way.z)};
        EXPECT_EQ(pbrt_numbers(words, 0, "point3 from"), from);
    }
}

INSTANTIATE_TEST_SUITE_P(all, EveryKeyhole, testing::ValuesIn(kKeyholes), [](const auto& info) {
    std::string name(info.param.name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace sunfleck::engine

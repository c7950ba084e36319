// The chambers of fog: light goes from the lamp to the room through the keyhole alone, and the
// camera does not see the lamp.

#include "procedural/fog_lamp.h"

#include "scene_parts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

const Vec3d kLamp(-1.1, 0, 1.83);
const Vec3d kCamera(1.8, -2.32, 1.22);

std::vector<Part> solid_parts() {
    std::vector<Part> parts = parts_of("fog-lamp");
    std::erase_if(parts, [](const Part& part) { return part.material == "nothing"; });
    return parts;
}

TEST(FogLamp, light_enters_the_room_through_the_keyhole_alone) {
    const std::vector<Part> parts = solid_parts();
    RandomStream random(5, Purpose::test, 0, 0);
    int through = 0;
    for (int i = 0; i < 4000; ++i) {
        // Half of the lines aim at the keyhole, half anywhere into the room.
        const double near = i % 2 == 0 ? 0.15 : 2.4;
        const Vec3d aim(0.02, near * (2 * random.next() - 1),
                        1.42 + std::min(near, 0.98) * (2 * random.next() - 1));
        const Vec3d in_room = kLamp + (aim - kLamp) * 1.1;
        if (faces_between(parts, kLamp, in_room).opaque > 0) continue;
        ++through;
        ASSERT_LT(std::abs(aim.y), 0.06);
        ASSERT_LT(std::abs(aim.z - 1.42), 0.15);
    }
    EXPECT_GT(through, 100);
}

TEST(FogLamp, the_camera_does_not_see_the_lamp) {
    const std::vector<Part> parts = solid_parts();
    for (const double y : {-0.025, 0.0, 0.025})
        for (const double z : {-0.025, 0.0, 0.025})
            EXPECT_GT(faces_between(parts, kCamera, kLamp + Vec3d(0, y, z)).opaque, 0);
}

}  // namespace
}  // namespace sunfleck::engine

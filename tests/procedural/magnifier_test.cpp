// The desk: whatever leaves the lamp leaves it through glass.

#include "procedural/magnifier.h"

#include "core/random.h"
#include "math/warp.h"
#include "scene_parts.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Magnifier, light_leaves_the_lamp_through_its_globe_only) {
    const std::vector<Part> parts = parts_of("magnifier");
    RandomStream random(7, Purpose::test, 0, 0);
    int through_glass = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 way = uniform_sphere({random.next(), random.next()});
        double nearest = 1e9;
        bool glass = false;
        for (const Part& part : parts) {
            if (part.material == "ink") continue;
            for (const MeshHit& hit : all_hits(part.mesh, {11, 6, 14}, Vec3d(way)))
                if (hit.distance > kGlowRadius && hit.distance < nearest) {
                    nearest = hit.distance;
                    glass = is_glass(part);
                }
        }
        ASSERT_LT(nearest, 6.5) << way;  // within the lamp
        through_glass += glass ? 1 : 0;
    }
    EXPECT_GT(through_glass, 200);
}

}  // namespace
}  // namespace sunfleck::engine

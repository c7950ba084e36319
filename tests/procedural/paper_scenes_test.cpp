// The scenes after the paper's: closed glass, no two faces in one place, light only where it should
// come from, and what single scenes promise.

#include "core/random.h"
#include "mesh_checks.h"
#include "procedural/scenes.h"
#include "procedural/statue.h"
#include "scene_reading.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sunfleck {
namespace {

struct Part {
    std::string material;
    Mesh mesh;
};

std::vector<Part> parts_of(const std::string& scene) {
    const std::vector<SceneFile> files = make_scene(scene);
    const std::vector<Mesh> meshes = scene_meshes(files);
    const std::vector<std::string> words = pbrt_words(files.at(0).bytes);
    std::vector<Part> parts;
    std::string material;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] == "NamedMaterial") material = words[i + 1].substr(1);
        if (words[i] == "Shape") parts.push_back({material, meshes.at(parts.size())});
    }
    return parts;
}

bool is_glass(const Part& part) {
    return part.material == "glass" || part.material == "pane";
}

class PaperScene : public testing::TestWithParam<const char*> {
protected:
    std::vector<Part> parts_ = parts_of(GetParam());
};

TEST_P(PaperScene, has_closed_glass_that_faces_out) {
    for (const Part& part : parts_) {
        if (!is_glass(part)) continue;
        EXPECT_TRUE(open_edges(part.mesh).empty());
        EXPECT_GT(volume(part.mesh), 0);
    }
}

/// A triangle in a plane across an axis, seen along it.
struct Flat {
    std::array<Vec2d, 3> corners;
    double low = 0;  // of its first coordinate
    double high = 0;
};

/// Do two triangles share some area? One of their six edges parts them otherwise.
bool overlap(const Flat& a, const Flat& b) {
    for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2d& from = one->corners.at(i);
            const Vec2d way = one->corners.at((i + 1) % 3) - from;
            const double inside = way.cross(one->corners.at((i + 2) % 3) - from);
            const auto beyond = [&](const Vec2d& p) { return way.cross(p - from) / inside < 1e-4; };
            if (std::all_of(other->corners.begin(), other->corners.end(), beyond)) return false;
        }
    return true;
}

/// Where two faces coincide, light may meet either.
TEST_P(PaperScene, has_no_two_level_faces_in_one_place) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::map<float, std::vector<Flat>> planes;
        for (const Part& part : parts_)
            for (const auto& t : part.mesh.triangles) {
                const auto& p = part.mesh.points;
                if (p[t[0]].at(axis) != p[t[1]].at(axis) || p[t[0]].at(axis) != p[t[2]].at(axis))
                    continue;
                Flat flat;
                for (std::size_t i = 0; i < 3; ++i)
                    flat.corners.at(i) = {p[t.at(i)].at((axis + 1) % 3),
                                          p[t.at(i)].at((axis + 2) % 3)};
                const auto [low, high] =
                    std::minmax({flat.corners[0].x, flat.corners[1].x, flat.corners[2].x});
                flat.low = low;
                flat.high = high;
                planes[p[t[0]].at(axis)].push_back(flat);
            }
        for (auto& [place, flats] : planes) {
            std::sort(flats.begin(), flats.end(),
                      [](const Flat& a, const Flat& b) { return a.low < b.low; });
            for (std::size_t i = 0; i < flats.size(); ++i)
                for (std::size_t j = i + 1; j < flats.size() && flats[j].low < flats[i].high; ++j)
                    ASSERT_FALSE(overlap(flats[i], flats[j]))
                        << "axis " << axis << " at " << place << ", near " << flats[j].corners[0].x
                        << ' ' << flats[j].corners[0].y;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(all, PaperScene,
                         testing::Values("cornell-door", "two-windows", "box", "watch", "room",
                                         "statue-far", "magnifier"),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

struct Met {
    std::size_t opaque = 0;
    std::size_t glass = 0;
};

/// Faces between two points, of all parts that are not large (furniture, which only hides more).
Met faces_between(const std::vector<Part>& parts, const Vec3d& a, const Vec3d& b) {
    Met met;
    for (const Part& part : parts) {
        if (part.mesh.triangles.size() > 1000) continue;
        for (const MeshHit& hit : all_hits(part.mesh, a, b - a))
            if (hit.distance < 1) ++(is_glass(part) ? met.glass : met.opaque);
    }
    return met;
}

/// What a line towards the sun meets, from random points of a box.
void expect_sun_through_panes_only(const std::string& scene, const Vec3d& low, const Vec3d& high,
                                   const Vec3d& sun) {
    const std::vector<Part> parts = parts_of(scene);
    RandomStream random(5, Purpose::test, 0, 0);
    int lit = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3d from(low.x + (high.x - low.x) * random.next(),
                         low.y + (high.y - low.y) * random.next(),
                         low.z + (high.z - low.z) * random.next());
        const Met met = faces_between(parts, from, from + sun * 30);
        if (met.opaque > 0) continue;
        ++lit;
        ASSERT_EQ(met.glass, 2) << from;
    }
    EXPECT_GT(lit, 60);
}

TEST(PaperScenes, the_hall_gets_the_sun_through_panes_only) {
    expect_sun_through_panes_only("two-windows", {-3.9, 0.1, 0.1}, {3.9, 8.9, 4.4},
                                  {0.75, -0.14, 0.65});
}

TEST(PaperScenes, the_room_gets_the_sun_through_panes_only) {
    expect_sun_through_panes_only("room", {-2.5, 0.1, 0.1}, {2.4, 5.5, 2.6}, {0.76, -0.24, 0.6});
}

TEST(PaperScenes, light_comes_into_the_cornell_box_through_the_doorway_only) {
    const std::vector<Part> parts = parts_of("cornell-door");
    RandomStream random(6, Purpose::test, 0, 0);
    int lit = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d here(-135 + 270 * random.next(), 2 + 276 * random.next(),
                         1 + 272 * random.next());
        const Vec3d there(152 + 276 * random.next(), 8 + 270 * random.next(),
                          1 + 272 * random.next());
        if (faces_between(parts, here, there).opaque > 0) continue;
        ++lit;
        const Vec3d at = here + (there - here) * ((145 - here.x) / (there.x - here.x));
        ASSERT_TRUE(at.y > 95 && at.y < 185 && at.z < 205) << at;
    }
    EXPECT_GT(lit, 20);
}

TEST(PaperScenes, the_box_has_the_triangles_of_its_nine_meshes_and_two_sources) {
    std::vector<std::size_t> counts;
    for (const Part& part : parts_of("box")) counts.push_back(part.mesh.triangles.size());
    EXPECT_EQ(counts, (std::vector<std::size_t>{170, 2, 2, 720, 720, 320, 672, 640, 216, 2, 2}));
}

TEST(PaperScenes, the_statue_is_the_same_from_far_and_near) {
    const std::vector<SceneFile> far = make_scene("statue-far");
    const std::vector<SceneFile> near = make_scene("statue-near");
    ASSERT_EQ(far.size(), near.size());
    for (std::size_t i = 1; i < far.size(); ++i) EXPECT_EQ(far[i].bytes, near[i].bytes);
    const auto world = [](const SceneFile& file) {
        return file.bytes.substr(file.bytes.find("WorldBegin"));
    };
    EXPECT_EQ(world(far[0]), world(near[0]));
    EXPECT_NE(far[0].bytes, near[0].bytes);
}

TEST(PaperScenes, the_knot_is_closed_and_faces_out) {
    const Mesh knot = fluted_knot(240, 40);
    EXPECT_EQ(knot.triangles.size(), 2 * 240 * 40);
    EXPECT_TRUE(open_edges(knot).empty());
    EXPECT_GT(volume(knot), 0);
    for (std::size_t i = 0; i < 240; ++i) {  // the flutes meet at the seam
        const Vec3d step = corner(knot, static_cast<std::uint32_t>((i + 1) % 240 * 40)) -
                           corner(knot, static_cast<std::uint32_t>(i * 40));
        ASSERT_LT(step.length(), 2.6);
    }
}

}  // namespace
}  // namespace sunfleck

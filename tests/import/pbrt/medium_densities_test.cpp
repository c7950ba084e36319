// Media that vary in space, as scene files tell them: where they stand, and what is refused.
#include "import/pbrt/medium_densities.h"

#include "import/pbrt/scene_text.h"
#include "medium/medium.h"

namespace sunfleck::engine {
namespace {

const std::string kGrid = "MakeNamedMedium \"smoke\" \"string type\" \"uniformgrid\" ";
const std::string kSmokyBall = "MediumInterface \"smoke\" \"\" Shape \"sphere\" ";
const std::string kTwo = "\"integer nx\" 2 \"float density\" [1 3] ";

const Density& density_in(const SceneDescription& scene) {
    return *scene.media.all.at(1).density;
}

TEST(ReadDensities, of_a_grid_have_their_values_at_the_centres_of_voxels) {
    const SceneDescription scene = read_world(
        kGrid + "\"integer nx\" 2 \"integer ny\" 1 \"integer nz\" 2 \"float density\" [1 2 3 4] " +
        kSmokyBall);
    const Density& density = density_in(scene);
    EXPECT_FLOAT_EQ(density_at(density, {0.25F, 0.5F, 0.25F}), 1);
    EXPECT_FLOAT_EQ(density_at(density, {0.75F, 0.5F, 0.25F}), 2);
    EXPECT_FLOAT_EQ(density_at(density, {0.25F, 0.5F, 0.75F}), 3);
    EXPECT_FLOAT_EQ(density_at(density, {0.75F, 0.5F, 0.75F}), 4);
    EXPECT_FLOAT_EQ(density_at(density, {0.5F, 0.5F, 0.5F}), 2.5F);
    EXPECT_EQ(density_at(density, {0.5F, 0.5F, 1.1F}), 0);
    EXPECT_TRUE(scene.warnings.entries().empty());
}

TEST(ReadDensities, stand_in_their_box_by_the_matrix_of_their_statement) {
    const SceneDescription scene =
        read_world("AttributeBegin Translate 10 0 0 Scale 2 1 1 " + kGrid + kTwo +
                   "\"point3 p0\" [-1 0 0] \"point3 p1\" [1 1 1] AttributeEnd " + kSmokyBall);
    EXPECT_FLOAT_EQ(density_at(density_in(scene), {9, 0.5F, 0.5F}), 1);
    EXPECT_FLOAT_EQ(density_at(density_in(scene), {11, 0.5F, 0.5F}), 3);
    EXPECT_EQ(density_at(density_in(scene), {12.1F, 0.5F, 0.5F}), 0);
}

/// pbrt-v4's box has its least corner first, whichever is given.
TEST(ReadDensities, take_corners_in_any_order) {
    const SceneDescription scene =
        read_world(kGrid + kTwo + "\"point3 p0\" [1 1 1] \"point3 p1\" [0 0 0] " + kSmokyBall);
    EXPECT_FLOAT_EQ(density_at(density_in(scene), {0.25F, 0.5F, 0.5F}), 1);
}

TEST(ReadDensities, of_even_media_are_none) {
    const SceneDescription scene =
        read_world("MakeNamedMedium \"smoke\" \"string type\" \"homogeneous\" " + kSmokyBall);
    EXPECT_EQ(scene.media.all.at(1).density, nullptr);
}

TEST(ReadDensities, warn_of_nothing) {
    for (const char* parameters :
         {"\"float temperature\" [1000 2000] ", "\"rgb Le\" [1 1 1] \"float Lescale\" [1 2] "}) {
        const SceneDescription fire = read_world(kGrid + kTwo + parameters + kSmokyBall);
        EXPECT_TRUE(fire.warnings.entries().empty());
    }
    const SceneDescription cloud = read_world(
        "MakeNamedMedium \"smoke\" \"string type\" \"cloud\" \"float density\" 2 "
        "\"point3 p1\" [.1 .1 .1] " +
        kSmokyBall);
    EXPECT_TRUE(cloud.warnings.entries().empty());
    EXPECT_FLOAT_EQ(density_at(density_in(cloud), {0.05F, 0.05F, 0.05F}), 1);
}

TEST(ReadDensities, that_cannot_be_are_told_by_their_parameter) {
    const auto fault = [](const std::string& parameters) {
        return world_error(kGrid + parameters + kSmokyBall);
    };
    const auto says = [&](const std::string& parameters, const std::string& part) {
        EXPECT_TRUE(contains(fault(parameters), part)) << fault(parameters);
    };
    says("", "no \"density\"");
    says("\"float density\" [1 2 3] ", "\"density\" has 3 values, but the grid 1 x 1 x 1");
    says("\"integer nx\" 0 \"float density\" [1] ", "\"nx\" is less than 1");
    says("\"integer nx\" 2147483647 \"integer ny\" 2147483647 \"float density\" [1] ", "values");
    says("\"integer nx\" 2 \"float density\" [1 -2] ", "number 2 of 2");
    says("\"float density\" [1e30] ", "above 1e18");
    says(kTwo + "\"float temperature\" [1] ", "\"temperature\" has 1 values");
    says(kTwo + "\"point3 p0\" [0 0 1] ", "no volume");
    says(kTwo + "\"point3 p0\" [0 0 1e300] ", "");
    says(kTwo + "\"rgb sigma_a\" [1e30 1e30 1e30] \"float scale\" 1e9 ", "too dense");
    EXPECT_TRUE(contains(world_error("Scale 1 1 0 " + kGrid + kTwo + kSmokyBall), ""));
}

TEST(ReadDensities, of_nanovdb_need_their_file) {
    const std::string statement = "MakeNamedMedium \"smoke\" \"string type\" \"nanovdb\" ";
    EXPECT_TRUE(contains(world_error(statement + kSmokyBall), "no \"filename\""));
    const std::string named = statement + "\"string filename\" \"a.nvdb\" ";
    EXPECT_TRUE(contains(world_error(named + kSmokyBall), "a.nvdb"));
    const std::string fault =
        error_of("WorldBegin " + named + kSmokyBall, {{"a.nvdb", "no volume at all"}});
    EXPECT_TRUE(contains(fault, "a.nvdb: is no NanoVDB file") && contains(fault, "main.pbrt:1:"))
        << fault;
}

}  // namespace
}  // namespace sunfleck::engine

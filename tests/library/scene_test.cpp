// Scenes of files take the flags of the command line.
#include "sunfleck/scene.h"

#include "image/temporary_folder.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <fstream>

namespace sunfleck {
namespace {

class SceneOfFile : public engine::testing_support::TemporaryFolder {
protected:
    std::string written(const std::string& name, const std::string& text) const {
        std::ofstream(path(name)) << text;
        return path(name);
    }
};

TEST_F(SceneOfFile, takes_flags_by_their_names) {
    const std::string file = written("dark.pbrt", "WorldBegin\nShape \"sphere\"\n");
    EXPECT_TRUE(Scene::load(file).lights().empty());
    SceneOptions options;
    options.flags = {{"sun", "225,40"}, {"ground_albedo", "0.5"}};
    const std::vector<LightInfo> lights = Scene::load(file, options).lights();
    ASSERT_EQ(lights.size(), 2U);
    EXPECT_EQ(lights[0].what, "sky");
    EXPECT_EQ(lights[0].where, "--sun");
    options.flags = {{"camera", "main"}};
    EXPECT_THROW(Scene::load(file, options), Error);
    options.flags = {{"moon", "1"}};
    EXPECT_THROW(Scene::load(file, options), Error);
    EXPECT_THROW(Scene::parse("WorldBegin\n", "x.pbrt", options), Error);
}

}  // namespace
}  // namespace sunfleck

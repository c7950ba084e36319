// `sunfleck scene` and `sunfleck info`.
#include "procedural/scenes.h"

#include "app/program.h"

namespace sunfleck::engine {
namespace {

using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::write_text;

class Scenes : public ProgramTest {
protected:
    std::string info(const std::string& scene) const {
        const Ran ran = run({"info", scene});
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.err, "");
        return ran.out;
    }
};

bool has_line(const std::string& text, const std::string& line) {
    return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

TEST_F(Scenes, are_listed) {
    const Ran ran = run({"scene"});
    EXPECT_EQ(ran.code, 0);
    for (const ProceduralScene& scene : procedural_scenes()) {
        EXPECT_NE(ran.out.find(scene.name + " "), std::string::npos) << scene.name;
        EXPECT_NE(ran.out.find(scene.what + "\n"), std::string::npos) << scene.what;
    }
}

TEST_F(Scenes, are_written_and_can_be_read) {
    for (const ProceduralScene& scene : procedural_scenes()) {
        const Ran ran = run({"scene", scene.name, "-o", "new/folder"});
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.out, "new/folder/" + scene.name + ".pbrt\n");
        info("new/folder/" + scene.name + ".pbrt");
    }
}

TEST_F(Scenes, info_of_the_cornell_box) {
    ASSERT_EQ(run({"scene", "cornell"}).code, 0);
    const std::string text = info("cornell.pbrt");
    for (const char* line :
         {"scene       cornell.pbrt", "file        cornell.pbrt",
          "shapes      8 in the world, 0 in objects, 0 instances",
          "triangles   36 (instances counted each)", "materials   4 diffuse",
          "lights      2 area (100% of the photons)", "film        256 x 256, rendered 256 x 256"})
        EXPECT_TRUE(has_line(text, line)) << line << "\nin\n" << text;
    EXPECT_NE(text.find("bounds      centre 278 274.4 279.6, radius "), std::string::npos) << text;
}

TEST_F(Scenes, info_of_the_glass_names_its_files) {
    ASSERT_EQ(run({"scene", "cognac-0"}).code, 0);
    const std::string text = info("cognac-0.pbrt");
    for (const char* line :
         {"file        geometry/glass-air.ply", "triangles   16456 (instances counted each)",
          "materials   3 dielectric", "lights      1 distant (100% of the photons)"})
        EXPECT_TRUE(has_line(text, line)) << line << "\nin\n" << text;
}

TEST_F(Scenes, info_counts_instances_lights_and_crops) {
    write_text(path("many.pbrt"), R"(
Film "rgb" "integer xresolution" 40 "integer yresolution" 20 "float cropwindow" [0 0.5 0 1]
Camera "perspective"
Integrator "volpath"
WorldBegin
LightSource "point" "rgb I" [1 1 1]
LightSource "point" "rgb I" [1 1 1]
LightSource "spot" "rgb I" [0 0 0]
ObjectBegin "pair"
Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0 0 0 1] "integer indices" [0 1 2 0 1 3]
ObjectEnd
Shape "sphere"
ObjectInstance "pair"
Translate 3 0 0
ObjectInstance "pair"
)");
    const std::string text = info("many.pbrt");
    for (const char* line :
         {"shapes      1 in the world, 1 in objects, 2 instances",
          "triangles   4 (instances counted each)", "lights      2 point (100% of the photons)",
          "lights      1 spot (0% of the photons)", "film        40 x 20, rendered 20 x 20"})
        EXPECT_TRUE(has_line(text, line)) << line << "\nin\n" << text;
}

/// The scene's integrator: one line, whichever it is.
TEST_F(Scenes, info_tells_the_integrator_once) {
    for (const std::string& word : testing_support::Words{"sppm", "volpath"}) {
        write_text(path("asks.pbrt"), "Camera \"perspective\"\nIntegrator \"" + word +
                                          "\"\nWorldBegin\nLightSource \"infinite\"\n");
        const std::string text = info("asks.pbrt");
        const std::size_t first = text.find("integrator");
        EXPECT_NE(text.find("\"" + word + "\"", first), std::string::npos) << text;
        EXPECT_EQ(text.find("integrator", first + 1), std::string::npos) << text;
    }
    write_text(path("asks.pbrt"), "Camera \"perspective\"\nWorldBegin\nShape \"sphere\"\n");
    EXPECT_EQ(info("asks.pbrt").find("integrator"), std::string::npos);
}

TEST_F(Scenes, info_repeats_warnings) {
    write_text(path("dark.pbrt"), "Camera \"perspective\"\nWorldBegin\nShape \"sphere\"\n");
    const std::string text = info("dark.pbrt");
    EXPECT_NE(text.find("no light"), std::string::npos) << text;
    EXPECT_TRUE(has_line(text, "lights      none"));
}

}  // namespace
}  // namespace sunfleck::engine

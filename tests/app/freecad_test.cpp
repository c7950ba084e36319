// The call of FreeCAD's Render workbench, on scenes in the form that its pbrt plug-in writes.
#include "app/program.h"
#include "image/png.h"

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::Process;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::Words;

class FreeCad : public ProgramTest {
protected:
    void SetUp() override {
        ProgramTest::SetUp();
        const std::string script = SUNFLECK_SOURCE_DIR "/tests/scenes/freecad/write_scenes.py";
        const Ran written =
            Process(path(""), {"python3", "-B", script, ".", "16", "12"}, "/usr/bin/env").wait();
        ASSERT_EQ(written.code, 0) << written.err;
    }

    /// PROGRAM PARAMETERS --outfile OUT --spp N FILE. @return  the warnings, without their places.
    Words warnings_of_call(const std::string& scene) const {
        const Words parameters{"render", "--photon-sampler", "uniform", "--photons-per-pass",
                               "500",    "--nthreads",       "1"};
        const Ran ran = run(parameters + Words{"--outfile", path(scene + ".png"), "--spp", "1",
                                               path(scene + ".pbrt")});
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(read_png(path(scene + ".png")).width, 16);
        Words warnings;
        std::istringstream lines(ran.err);
        const std::string mark = "warning: ";
        for (std::string line; std::getline(lines, line);)
            if (const auto at = line.find(mark); at != std::string::npos)
                warnings.push_back(line.substr(at + mark.size()));
        std::sort(warnings.begin(), warnings.end());
        return warnings;
    }
};

const std::string kIntegrator = "integrator \"path\" is ignored except \"maxdepth\"";

/// A word that was no longer read would be a warning more, or an error.
TEST_F(FreeCad, scenes_are_read_and_all_that_is_not_is_named) {
    for (const std::string scene : {"bracket", "lens"}) {
        const Words warnings = warnings_of_call(scene);
        ASSERT_EQ(warnings.size(), 1U) << scene;
        EXPECT_EQ(warnings[0].find(kIntegrator), 0U) << warnings[0];
    }
    const Words warnings = warnings_of_call("knob");
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_EQ(warnings[0].find(kIntegrator), 0U) << warnings[0];
    EXPECT_NE(warnings[1].find("latitude and longitude"), std::string::npos) << warnings[1];
}

}  // namespace
}  // namespace sunfleck::engine

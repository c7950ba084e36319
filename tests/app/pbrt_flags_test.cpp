// Flags as pbrt has them, for plug-ins of exporters and scripts that call it.
#include "app/program.h"
#include "image/exr.h"

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::Words;

using PbrtFlags = ProgramTest;

/// As plug-ins of exporters call pbrt.
TEST_F(PbrtFlags, outfile_is_the_output) {
    const Ran ran = run({"render", "--outfile", "y.exr", "--spp", "1", "--nthreads", "1", "--quiet",
                         "--seed", "3", "--photons-per-pass", "100", "room.pbrt"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(read_exr(path("y.exr")).width, 16);
}

/// 16 x 12 pixels; rounded up, as pbrt-v4 does.
TEST_F(PbrtFlags, a_crop_window_is_the_crop_of_its_pixels) {
    const Words passes{"--spp", "2"};
    ASSERT_EQ(render(passes + Words{"-o", "pixels.exr", "--crop", "4,12,5,12"}).code, 0);
    ASSERT_EQ(render(passes + Words{"-o", "window.exr", "--cropwindow", "0.25,0.75,0.4,1"}).code,
              0);
    const Picture pixels = read_exr(path("pixels.exr"));
    EXPECT_EQ(pixels.width, 8);
    EXPECT_EQ(read_exr(path("window.exr")).channels, pixels.channels);
}

}  // namespace
}  // namespace sunfleck::engine

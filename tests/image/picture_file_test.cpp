// The ending of the name chooses the format.
#include "image/picture_file.h"

#include "image/exr.h"
#include "image/png.h"
#include "sunfleck/error.h"
#include "temporary_folder.h"

namespace sunfleck::engine {
namespace {

using PictureFile = testing_support::TemporaryFolder;

Picture quarter() {
    Picture picture{1, 1, {}, {}};
    for (const char* name : {"B", "G", "R"}) picture.add(name).values = {0.25F};
    return picture;
}

TEST_F(PictureFile, the_ending_chooses) {
    write_picture(path("a.exr"), quarter());
    write_picture(path("A.EXR"), quarter());
    write_picture(path("a.png"), quarter(), {2, false});
    EXPECT_EQ(read_exr(path("a.exr")), quarter());
    EXPECT_EQ(read_exr(path("A.EXR")), quarter());
    EXPECT_EQ(read_png(path("a.png")).values[0], 255);
}

TEST_F(PictureFile, options_reach_the_format) {
    Picture third = quarter();
    third.channels[0].values[0] = 1.0F / 3;
    write_picture(path("a.exr"), third, {0, true});
    EXPECT_NE(read_exr(path("a.exr")).channels[0].values[0], 1.0F / 3);
}

TEST_F(PictureFile, others_are_refused_before_work_begins) {
    try {
        check_picture_path(path("a.jpg"));
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()), path("a.jpg") +
                                                 ": has no ending of a picture; end the name "
                                                 "in .exr or .png");
    }
    EXPECT_THROW(check_picture_path(path("exr")), Error);
    EXPECT_THROW(check_picture_path(path("no/a.exr")), Error);
    check_picture_path(path("a.png"));
    EXPECT_EQ(files(), 0);
}

}  // namespace
}  // namespace sunfleck::engine

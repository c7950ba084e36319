// The ending of the name chooses the format.
#include "image/picture_file.h"

#include "image/exr.h"
#include "image/png.h"
#include "image/read_file.h"
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
    write_picture(path("a.png"), quarter(), {.transform = {.exposure = 2}});
    EXPECT_EQ(read_exr(path("a.exr")), quarter());
    EXPECT_EQ(read_exr(path("A.EXR")), quarter());
    EXPECT_EQ(read_png(path("a.png")).values[0], 255);
    for (const char* name : {"a.jpg", "a.jpeg", "A.JPG"}) {
        write_picture(path(name), quarter());
        EXPECT_TRUE(read_file(path(name)).starts_with("\xFF\xD8\xFF")) << name;
    }
}

TEST_F(PictureFile, options_reach_the_format) {
    Picture third = quarter();
    third.channels[0].values[0] = 1.0F / 3;
    write_picture(path("a.exr"), third, {.exr = {.half = true}});
    EXPECT_NE(read_exr(path("a.exr")).channels[0].values[0], 1.0F / 3);
    write_picture(path("a.png"), third, {.png_bits = 16});
    EXPECT_EQ(read_png(path("a.png")).bits, 16);
    const auto size_at = [&](int quality) {
        write_picture(path("a.jpg"), third, {.jpeg_quality = quality});
        return read_file(path("a.jpg"));
    };
    EXPECT_NE(size_at(95), size_at(50));
}

TEST_F(PictureFile, others_are_refused_before_work_begins) {
    try {
        check_picture_path(path("a.tif"));
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()), path("a.tif") +
                                                 ": unknown picture format; end the name "
                                                 "in .exr, .png, .jpg or .jpeg");
    }
    EXPECT_THROW(check_picture_path(path("exr")), Error);
    EXPECT_THROW(check_picture_path(path("no/a.exr")), Error);
    check_picture_path(path("a.png"));
    EXPECT_EQ(files(), 0);
}

}  // namespace
}  // namespace sunfleck::engine

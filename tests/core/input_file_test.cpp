// Input files: what a name stands for, where it is no file.
#include "core/input_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

class InputFile : public testing::Test {
public:
    InputFile() { fs::create_directories(folder_ / "tex"); }
    ~InputFile() override { fs::remove_all(folder_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    InputFile(InputFile&&) = delete;
    InputFile& operator=(InputFile&&) = delete;

protected:
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    std::string fault(const std::string& name) const {
        try {
            read_input_file(path(name), {"a.pbrt", 3, 7});
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    void expect_fault(const std::string& name, const std::string& part) const {
        EXPECT_NE(fault(name).find(part), std::string::npos) << fault(name);
        EXPECT_EQ(fault(name).find("a.pbrt:3:7: "), 0U) << fault(name);
    }

private:
    fs::path folder_ = fs::path(testing::TempDir()) / "sunfleck_input_file_test";
};

TEST_F(InputFile, is_read_whole) {
    const std::string bytes("a\0b\r\n", 5);
    std::ofstream(path("a.bin"), std::ios::binary) << bytes;
    EXPECT_EQ(read_input_file(path("a.bin"), {}), bytes);
    std::ofstream(path("empty"), std::ios::binary) << "";
    EXPECT_EQ(read_input_file(path("empty"), {}), "");
}

TEST_F(InputFile, that_is_missing_is_told_from_what_is_none) {
    expect_fault("none.ply", "there is no file");
    expect_fault("none/deeper.ply", "there is no file");
    expect_fault("tex", "is a folder");
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    expect_fault("pipe", "is a pipe");
    expect_fault("../../../../../../../../../../dev/null", "is a device");
    fs::create_symlink("gone.ply", path("link.ply"));
    expect_fault("link.ply", "is a link to \"gone.ply\", which does not exist");
    EXPECT_THROW(read_input_file(path("none.ply"), {}), MissingFile);
}

TEST_F(InputFile, of_another_case_is_named) {
    std::ofstream(path("tex/Wall.PNG")) << "x";
    expect_fault("tex/wall.png", "tex/Wall.PNG");
    expect_fault("Tex/wall.png", "tex/Wall.PNG");
    expect_fault("TEX/WALL.PNG", "check upper and lower case");
    EXPECT_EQ(fault("tex/walls.jpg").find("Wall"), std::string::npos);
}

TEST_F(InputFile, of_another_ending_is_named) {
    std::ofstream(path("tex/wall.png")) << "x";
    std::ofstream(path("tex/wall.tga")) << "x";
    for (const char* name : {"tex/wall.jpg", "tex/wall", "tex/Wall.JPG", "tex/wall.png "})
        expect_fault(name, "tex/wall.png\"");
    EXPECT_EQ(fault("tex/walls.png").find("there is \""), std::string::npos);
    EXPECT_EQ(fault("none/wall.jpg").find("there is \""), std::string::npos);
}

TEST_F(InputFile, of_another_machine_is_told) {
    expect_fault("C:/art/wall.png", "drive of Windows");
    expect_fault("https:/example.org/wall.png", "download the file");
    expect_fault("file:/art/wall.png", "is an address");
    for (const char* name : {"a:b.png", "1:/b.png", ":/b.png", "a b:/c.png"})
        expect_fault(name, "check the name");
}

TEST_F(InputFile, is_named_on_one_line) {
    expect_fault("tex\tiles\n.png", R"(tex\tiles\n.png")");
    EXPECT_EQ(fault("a\x01\nb").find('\n'), std::string::npos);
}

}  // namespace
}  // namespace sunfleck::engine

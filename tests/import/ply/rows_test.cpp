// Numbers of a PLY body beside positions.
#include "import/ply/rows.h"

#include "import/ply/reader.h"

#include <gtest/gtest.h>

#include <string>

namespace sunfleck::engine {
namespace {

/// Of bytes, of words of 16 bits, and of floats; what is beyond [0,1] is held.
TEST(PlyRows, have_colours_of_vertices) {
    const auto colours = [](const std::string& type, const std::string& numbers) {
        std::string head =
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
            "property float y\nproperty float z\n";
        for (const char* name : {"red", "green", "blue"})
            head += "property " + type + " " + name + "\n";
        head += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
        return parse_ply(head + "0 0 0 " + numbers + "\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n",
                         "a.ply")
            .colours;
    };
    EXPECT_EQ(colours("uchar", "255 51 0").at(0), Vec3(1, 0.2F, 0));
    EXPECT_EQ(colours("ushort", "65535 13107 0").at(0), Vec3(1, 0.2F, 0));
    EXPECT_EQ(colours("float", "7 0.2 nan").at(0), Vec3(1, 0.2F, 0));
    EXPECT_EQ(colours("uchar", "1 2 3").size(), 3U);
}

}  // namespace
}  // namespace sunfleck::engine

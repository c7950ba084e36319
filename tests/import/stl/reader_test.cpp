// Both forms of STL, how they are told apart, and what files of other programs have in them.
#include "import/stl/reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace sunfleck::engine {
namespace {

/// Corners of a tetrahedron's triangles, three numbers each.
const std::vector<float> kTetrahedron = {0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,
                                         0, 0, 0, 0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};

std::string number(std::uint32_t value) {
    std::string bytes;
    for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 255U);
    return bytes;
}

/// Returns a binary file. @param count  as its head says.
std::string binary(const std::vector<float>& corners, std::uint32_t count,
                   const std::string& head = "made for a test") {
    std::string bytes = head + std::string(80 - head.size(), ' ') + number(count);
    for (std::size_t i = 0; i + 8 < corners.size(); i += 9) {
        bytes += std::string(12, '\0');  // the normal
        std::string row(36, '\0');
        std::memcpy(row.data(), corners.data() + i, row.size());
        bytes += row + std::string(2, '\0');
    }
    return bytes;
}

std::string facet(const std::string& a, const std::string& b, const std::string& c,
                  const std::string& normal = "0 0 1") {
    return "facet normal " + normal + "\n outer loop\n  vertex " + a + "\n  vertex " + b +
           "\n  vertex " + c + "\n endloop\nendfacet\n";
}

std::string fault_of(const std::string& bytes) {
    try {
        parse_stl(bytes, "a.stl");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Stl, welds_the_vertices_of_a_binary_file) {
    const StlMesh mesh = parse_stl(binary(kTetrahedron, 4), "a.stl");
    EXPECT_EQ(mesh.positions.size(), 4U);
    const std::vector<std::array<std::uint32_t, 3>> expected = {
        {0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 3}};
    EXPECT_EQ(mesh.triangles, expected);
    EXPECT_TRUE(mesh.remarks.empty());
}

/// SolidWorks and others begin binary files with that word, and even with what follows in text.
TEST(Stl, is_told_by_its_size_and_not_by_the_word_solid) {
    for (const char* head : {"solid part", "solid x\nfacet normal 0 0 0", "SOLID"})
        EXPECT_EQ(parse_stl(binary(kTetrahedron, 4, head), "a.stl").triangles.size(), 4U) << head;
}

TEST(Stl, reads_text_of_any_case_with_several_solids) {
    const std::string text =
        "solid first facet\r\n" + facet("0 0 0", "1 0 0", "0 1e0 0", "nan x") +
        "endsolid first facet\nSOLID \xE7\xA9\xBF\n" +
        "FACET NORMAL 0 0 1 OUTER LOOP\n OUTER LOOP VERTEX 0 0 0\tVERTEX 1 0 0 "
        "VERTEX +0 0 -1.5\nENDLOOP ENDFACET endsolid";
    const StlMesh mesh = parse_stl(text, "a.stl");
    EXPECT_EQ(mesh.triangles.size(), 2U);
    ASSERT_EQ(mesh.positions.size(), 4U);
    EXPECT_EQ(mesh.positions[3], Vec3(0, 0, -1.5F));
    EXPECT_TRUE(mesh.remarks.empty());
    EXPECT_EQ(parse_stl("\xEF\xBB\xBFsolid\n" + facet("0 0 0", "1 0 0", "0 1 0"), "a.stl").remarks,
              std::vector<std::string>{"the file ends without endsolid"});
    EXPECT_EQ(parse_stl("\n" + facet("0 0 0", "1 0 0", "0 1 0"), "a.stl").triangles.size(), 1U);
}

TEST(Stl, leaves_out_triangles_that_are_none) {
    std::vector<float> corners = kTetrahedron;
    corners.insert(corners.end(), {5, 5, 5, 5, 5, 5, 1, 2, 3});
    const StlMesh mesh = parse_stl(binary(corners, 5), "a.stl");
    EXPECT_EQ(mesh.triangles.size(), 4U);
    EXPECT_EQ(mesh.remarks, std::vector<std::string>{
                                "triangles with two corners at one place were left out (1)"});
    EXPECT_EQ(fault_of(binary({5, 5, 5, 5, 5, 5, 1, 2, 3}, 1)),
              "a.stl: has triangles without area alone; export the part again");
}

TEST(Stl, leaves_out_colours_and_bytes_behind_its_triangles) {
    std::string coloured = binary(kTetrahedron, 4);
    coloured[84 + 48] = '\x1F';
    const std::vector<std::string> colours = {
        "colours of triangles (attribute bytes) are left out"};
    EXPECT_EQ(parse_stl(coloured, "a.stl").remarks, colours);
    EXPECT_EQ(parse_stl(binary(kTetrahedron, 4, "COLOR=abcd"), "a.stl").remarks, colours);
    EXPECT_EQ(parse_stl(binary(kTetrahedron, 4) + "end", "a.stl").remarks,
              std::vector<std::string>{"bytes behind the last triangle were left out (3)"});
}

/// Writers that cannot go back in a file leave the count as it was.
TEST(Stl, takes_the_size_for_a_count_of_0_or_minus_1) {
    for (const std::uint32_t count : {0U, 0xFFFFFFFFU})
        EXPECT_EQ(parse_stl(binary(kTetrahedron, count), "a.stl").triangles.size(), 4U) << count;
}

TEST(Stl, that_is_cut_off_or_damaged_is_refused) {
    const std::string whole = binary(kTetrahedron, 4);
    EXPECT_EQ(fault_of(whole.substr(0, whole.size() - 1)),
              "a.stl: claims 4 triangles, and has bytes for 3; it is truncated, or no STL: export "
              "or copy it again");
    EXPECT_EQ(fault_of(binary(kTetrahedron, 0xFFFFFFF0U)),
              "a.stl: claims 4294967280 triangles, and has bytes for 4; it is truncated, or no "
              "STL: export or copy it again");
    EXPECT_EQ(fault_of(binary({}, 0)), "a.stl: has no triangle; export the part again");
    EXPECT_NE(fault_of("solid"), "");
    EXPECT_EQ(fault_of(""), "a.stl: is empty, where an STL mesh is read; get the file again");
    EXPECT_EQ(fault_of("solid a\nendsolid a\n"), "a.stl: has no triangle; export the part again");
    std::vector<float> broken = kTetrahedron;
    broken[9 + 2] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(fault_of(binary(broken, 4)),
              "a.stl: triangle 1 (byte 134): a corner that is not finite; export the part again "
              "without it");
}

TEST(Stl, tells_the_place_of_a_wrong_statement) {
    EXPECT_EQ(fault_of("solid a\n" + facet("0 0 0", "1 0", "0 1 0")),
              "a.stl:5:13: the line ends where a coordinate is expected; give all numbers of "
              "the statement");
    EXPECT_EQ(fault_of("solid a\n" + facet("0 0 0", "1,0 0 0", "0 1 0")),
              "a.stl:5:10: \"1,0\" is no number; write a point in place of the comma");
    EXPECT_EQ(fault_of("solid a\n" + facet("0 0 0", "1 0 0", "0 inf 0")),
              "a.stl:6:12: a corner that is not finite; export the part without it");
    EXPECT_EQ(fault_of("solid a\nfacet\n outer loop\n vertex 0 0 0\n endloop"),
              "a.stl:5:2: \"endloop\" where vertex is expected; export the part again");
    EXPECT_EQ(fault_of("solid a\n" + facet("0 0 0", "1 0 0", "0 1 0\nvertex 1 1 0")),
              "a.stl:7:1: a facet of more than three corners; export triangles");
    EXPECT_EQ(fault_of("solid a\nfacet normal 0 0 1\n outer loop\n"),
              "a.stl:4:1: the file ends within a facet; export or copy the file again");
}

TEST(Stl, that_is_another_file_is_named) {
    EXPECT_EQ(fault_of("ply\nformat ascii 1.0\n"),
              "a.stl: is a PLY mesh, where an STL mesh is read; give an STL mesh");
    EXPECT_NE(fault_of("<html><body>404</body></html>").find("a web page"), std::string::npos);
}

}  // namespace
}  // namespace sunfleck::engine

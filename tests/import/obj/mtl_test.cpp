// MTL files as programs write them.
#include "import/obj/mtl.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

std::string mtl_remarks_of(const MtlLibrary& library) {
    std::string all;
    for (const MtlRemark& remark : library.remarks)
        all += remark.where.text() + ": " + remark.text + "\n";
    return all;
}

MtlMaterial one(const std::string& lines) {
    const MtlLibrary library = parse_mtl("newmtl a\n" + lines, "a.mtl");
    EXPECT_EQ(mtl_remarks_of(library), "");
    return library.materials.at(0);
}

std::string mtl_fault_of(const std::string& text) {
    try {
        parse_mtl(text, "a.mtl");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Mtl, reads_colours_and_numbers_of_each_material) {
    const MtlLibrary library = parse_mtl(
        "# Blender MTL File\r\nnewmtl red paint \r\n\tKd 1 .5 0\r\nKs 0.25\r\nd -halo 0.5\r\n"
        "NEWMTL b\r\nke -1 2e0 3\r\nillum 7\r\nPr .1 # rough\r\n",
        "a.mtl");
    EXPECT_TRUE(library.is_of_blender);
    ASSERT_EQ(library.materials.size(), 2U);
    const MtlMaterial& red = library.materials[0];
    EXPECT_EQ(red.name, "red paint");
    EXPECT_EQ(red.where.text(), "a.mtl:2:1");
    EXPECT_EQ(red.colour("kd"), Vec3d(1, 0.5, 0));
    EXPECT_EQ(red.colour("ks"), Vec3d(0.25));
    EXPECT_EQ(red.number("d"), 0.5);
    EXPECT_FALSE(red.colour("ke"));
    EXPECT_EQ(library.materials[1].colour("ke"), Vec3d(0, 2, 3));
    EXPECT_EQ(library.materials[1].number("illum"), 7);
    EXPECT_EQ(library.materials[1].number("pr"), 0.1);
}

/// Options stand before the name, by the manual; some writers have them behind.
TEST(Mtl, reads_options_of_pictures_and_names_with_blanks) {
    const MtlMaterial m = one(
        "map_Kd -s 2 3 1 -o 0.5 -clamp on -texres 512 textures\\my wood 2.png\n"
        "map_Bump normal map.png -bm 0.5\nbump -imfchan r -bm 2 b.png\nnorm -blendu off 3d.png\n"
        "map_Pr\t-mm 0 1 #1.png\nmap_d -s 1 2 -5.png -clamp on\n");
    EXPECT_EQ(m.map("map_kd")->file, "textures\\my wood 2.png");
    EXPECT_EQ(m.map("map_kd")->scale, Vec2d(2, 3));
    EXPECT_EQ(m.map("map_kd")->offset, Vec2d(0.5, 0));
    EXPECT_TRUE(m.map("map_kd")->clamps);
    EXPECT_EQ(m.map("map_bump")->file, "normal map.png");
    EXPECT_EQ(m.map("map_bump")->bump, 0.5);
    EXPECT_EQ(m.map("bump")->channel, 'r');
    EXPECT_EQ(m.map("norm")->file, "3d.png");
    EXPECT_EQ(m.map("map_pr")->file, "#1.png");
    EXPECT_EQ(m.map("map_d")->file, "-5.png");
    EXPECT_TRUE(m.map("map_d")->clamps);
    EXPECT_EQ(m.map("map_ks"), nullptr);
}

TEST(Mtl, tells_what_it_leaves_out) {
    const MtlLibrary library = parse_mtl(
        "Kd 1 1 1\nnewmtl a\nKd spectral gold.rfl\nmap_Kd\nmap_Kd -mm 0.1 2 -t 1 a.png\nhalf 3\n",
        "a.mtl");
    EXPECT_EQ(mtl_remarks_of(library),
              "a.mtl:1:1: \"kd\" stands before any newmtl, and is left out\n"
              "a.mtl:3:1: \"kd\" by spectral or xyz is left out\n"
              "a.mtl:4:1: \"map_kd\" names no picture, and is left out\n"
              "a.mtl:5:1: \"map_kd\" has base and gain (-mm), which are left out\n"
              "a.mtl:5:1: \"map_kd\" has turbulence (-t), which is left out\n"
              "a.mtl:6:1: \"half\" is no statement of MTL, and is left out\n");
}

TEST(Mtl, tells_the_place_of_what_is_wrong) {
    EXPECT_EQ(mtl_fault_of("newmtl a\nKd 1 0,5 1\n"),
              "a.mtl:2:6: \"0,5\" is no number; write a point in place of the comma");
    EXPECT_EQ(mtl_fault_of("newmtl a\nKd 1 1\n"),
              "a.mtl:2:7: the line ends where a number is expected; give all numbers of the "
              "statement");
    EXPECT_EQ(mtl_fault_of("newmtl a\nNs nan\n"),
              "a.mtl:2:1: a number that is not finite; give a finite one");
    EXPECT_EQ(mtl_fault_of("newmtl a\nKd red\n"),
              "a.mtl:2:1: \"kd\" without a colour; give red, green and blue");
    EXPECT_NE(mtl_fault_of("<html>").find("a web page"), std::string::npos);
    EXPECT_EQ(mtl_fault_of(""), "");
}

}  // namespace
}  // namespace sunfleck::engine

// IES files: layouts, symmetries, stated lumens, and what is wrong with a file.
#include "import/ies/photometry.h"

#include "import/ies/light.h"
#include "math/warp.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace sunfleck::engine {
namespace {

/// A file of the horizontal angles and intensities; vertical angles are 0, 90 and 180.
Photometry made(const std::string& horizontals, const std::string& candela,
                const std::string& factors = "1 1 0", const std::string& multiplier = "1") {
    const auto count = std::count(horizontals.begin(), horizontals.end(), ' ') + 1;
    return Photometry("IESNA:LM-63-1995\n[TEST] none\nTILT=NONE\n1 -1 " + multiplier + " 3 " +
                          std::to_string(count) + " 1 2 0 0 0\n" + factors + "\n0 90 180\n" +
                          horizontals + "\n" + candela,
                      "lamp.ies");
}

std::string fault_of(const std::string& text) {
    try {
        const Photometry read(text, "lamp.ies");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// Lumens by midpoints over the sphere.
double lumens(const Photometry& photometry) {
    constexpr int kSide = 250;
    double sum = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            sum += photometry.candela(uniform_sphere({(x + 0.5) / kSide, (y + 0.5) / kSide}));
    return sum * 4 * kPiDouble / (kSide * kSide);
}

TEST(Photometry, is_linear_between_angles_and_goes_from_the_nadir_up) {
    const Photometry lamp = made("0", "10 20 40");
    EXPECT_EQ(lamp.candela(0, 77), 10);
    EXPECT_EQ(lamp.candela(45, 300), 15);
    EXPECT_EQ(lamp.candela(180, 0), 40);
    EXPECT_NEAR(lamp.candela(Vec3d(0, 0, -1)), 10, 1e-4);
    EXPECT_NEAR(lamp.candela(Vec3d(1, 0, 0)), 20, 1e-4);
    EXPECT_NEAR(lamp.candela(Vec3d(0, 0, 1)), 40, 1e-4);
}

TEST(Photometry, has_the_symmetry_of_its_horizontal_angles) {
    const Photometry quadrant = made("0 90", "0 0 0 0 90 0");
    for (const double angle : {45.0, 135.0, 225.0, 315.0})
        EXPECT_NEAR(quadrant.candela(90, angle), 45, 1e-12) << angle;
    const Photometry half = made("0 180", "0 0 0 0 180 0");
    EXPECT_NEAR(half.candela(90, 90), 90, 1e-12);
    EXPECT_NEAR(half.candela(90, 270), 90, 1e-12);
    EXPECT_NEAR(half.candela(90, 350), 10, 1e-12);
    const Photometry side = made("90 180 270", "0 90 0 0 180 0 0 270 0");
    EXPECT_NEAR(side.candela(90, 80), 100, 1e-12);
    EXPECT_NEAR(side.candela(90, 0), 180, 1e-12);
    EXPECT_NEAR(side.candela(90, 280), 260, 1e-12);
    const Photometry whole = made("0 120 240 360", "0 1 0 0 2 0 0 3 0 0 1 0");
    EXPECT_NEAR(whole.candela(90, 300), 2, 1e-12);
}

/// Some makers leave out 360, which is 0 again.
TEST(Photometry, closes_the_circle_where_the_last_angle_is_left_out) {
    const Photometry open = made("0 120 240", "0 1 0 0 2 0 0 3 0");
    EXPECT_NEAR(open.candela(90, 300), 2, 1e-12);
    EXPECT_NEAR(open.candela(90, 359.999), 1, 1e-3);
}

TEST(Photometry, is_multiplied_by_its_factors_and_dark_where_nothing_was_measured) {
    EXPECT_NEAR(made("0", "10 20 40", "0.9 0.5 0", "2").candela(0, 0), 9, 1e-12);
    const std::string rest = "\n1 -1 1 1 1 1 2 0 0 0 0.9 0.5 0 0 0 100";
    EXPECT_NEAR(Photometry("IESNA91\nTILT=NONE" + rest, "lamp.ies").candela(0, 0), 45, 1e-9);
    for (const char* line : {"IESNA:LM-63-2002", "IES:LM-63-2019"})
        EXPECT_NEAR(Photometry(line + ("\nTILT=NONE" + rest), "lamp.ies").candela(0, 0), 90, 1e-9);
    const Photometry down("TILT=NONE\n1,-1,1,2,1,1,2,0,0,0\n1,1,0\n0,80\n0\n5,5\n", "lamp.ies");
    EXPECT_EQ(down.candela(79, 0), 5);
    EXPECT_EQ(down.candela(81, 0), 0);
}

TEST(Photometry, that_is_damaged_is_told_with_its_place) {
    const std::string begin = "IESNA91\r\nTILT=NONE\r\n1 -1 1 ";
    EXPECT_EQ(fault_of("hello"),
              "lamp.ies: has no line TILT=, so it is no IES file; name a file of luminaire data "
              "(ANSI/IES LM-63)");
    EXPECT_NE(fault_of(begin + "2 1 1 2 0 0 0 1 1 0 0 90 0 5").find("lamp.ies:3:"),
              std::string::npos);
    EXPECT_NE(fault_of(begin + "2 1 2 2 0 0 0 1 1 0 0 90 0 5 5").find("type B"), std::string::npos);
    for (const char* rest :
         {"", "0 1 1 2 0 0 0 1 1 0 0 5", "2.5 1 1 2 0 0 0 1 1 0 0 90 0 5 5",
          "99999999999 1 1 2 0 0 0 1 1 0 0 90 0 5 5", "2 1 1 2 0 0 0 1 1 0 0 0 0 5 5",
          "2 1 1 2 0 0 0 1 1 0 0 90 0 -5 5", "2 1 1 2 0 0 0 1 1 0 0 90 0 nan 5",
          "2 1 1 2 0 0 0 1 1 0 0 90 0 5x 5", "2 2 1 2 0 0 0 1 1 0 0 90 0 45 5 5 5 5",
          "2 1 1 2 0 0 0 1 1 0 0 400 0 5 5"})
        EXPECT_NE(fault_of(begin + rest), "") << rest;
}

TEST(Photometry, of_shared_files_has_the_lumens_that_they_state) {
    const std::string folder = std::string(SUNFLECK_SOURCE_DIR) + "/../shared/data/ies/";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "there is no ../shared/data/ies";
    for (const auto& [name, stated] : {std::pair("lambert-downlight.ies", 3139.6),
                                       {"narrow-spot-quadrant.ies", 1631.1},
                                       {"asymmetric-tilt-include.ies", 845.8}}) {
        std::ifstream file(folder + name);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const Photometry photometry(text, name);
        EXPECT_NEAR(lumens(photometry) / stated, 1, 2e-3) << name;
    }
}

TEST(Photometry, keeps_its_lumens_as_a_map_of_directions) {
    const Photometry lamp = made("0 90", "10 20 0 10 60 5");
    EXPECT_NEAR(intensity_map(lamp)->mean() * 4 * kPiDouble / lumens(lamp), 1, 1e-3);
}

}  // namespace
}  // namespace sunfleck::engine

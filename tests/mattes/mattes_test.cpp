// Mattes of scenes whose coverages are known.
#include "mattes/mattes.h"

#include "core/parallel.h"
#include "import/pbrt/reader.h"
#include "mattes/matte_id.h"

#include <gtest/gtest.h>

#include <bit>

namespace sunfleck::engine {
namespace {

/// A film of 4 x 4 pixels that shows x and y from -1 to 1, seen along z.
std::string front_view(
    const std::string& filter = R"("box" "float xradius" .5 "float yradius" .5)") {
    return R"(LookAt 0 0 -5  0 0 0  0 1 0
Camera "orthographic" "float screenwindow" [-1 1 -1 1]
Film "rgb" "integer xresolution" 4 "integer yresolution" 4
PixelFilter )" +
           filter + "\nWorldBegin\n";
}

/// A rectangle of an object of its own, as high as the film. @param more  of its shape.
std::string object(const std::string& name, double x0, double x1, double z,
                   const std::string& more = "") {
    const auto corner = [&](double x, int y) {
        return std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z) + ' ';
    };
    return "ObjectBegin \"" + name + "\"\nShape \"bilinearmesh\" \"point3 P\" [" + corner(x0, -2) +
           corner(x1, -2) + corner(x0, 2) + corner(x1, 2) + "] " + more +
           "\nObjectEnd\nObjectInstance \"" + name + "\"\n";
}

Mattes mattes_of(const std::string& scene, MatteSettings settings = {{MatteKind::object}}) {
    return make_mattes(Scene(read_pbrt_text(scene, "test.pbrt")), settings);
}

float coverage(const Mattes& mattes, const std::string& name, std::size_t pixel,
               const std::string& layer = "CryptoObject") {
    const Picture picture{4, 4, mattes.channels, {}};
    float sum = 0;
    for (const std::string rank : {"00", "01", "02"})
        for (const auto& [id, part] : {std::pair("R", "G"), std::pair("B", "A")}) {
            const float found = picture.find(layer + rank + "." + id)->values[pixel];
            if (std::bit_cast<MatteId>(found) == matte_id(name))
                sum += picture.find(layer + rank + "." + part)->values[pixel];
        }
    return sum;
}

/// Edges at halves and quarters of a pixel: nets of points count them exactly.
TEST(Mattes, coverages_are_the_shares_of_a_pixel) {
    const Mattes mattes =
        mattes_of(front_view() + object("left", -2, 0.25, 0) + object("behind", -2, 0.875, 1));
    for (std::size_t row = 0; row < 4; ++row) {
        EXPECT_EQ(coverage(mattes, "left", 4 * row + 1), 1);
        EXPECT_EQ(coverage(mattes, "left", 4 * row + 2), 0.5F);
        EXPECT_EQ(coverage(mattes, "behind", 4 * row + 2), 0.5F);
        EXPECT_EQ(coverage(mattes, "left", 4 * row + 3), 0);
        EXPECT_EQ(coverage(mattes, "behind", 4 * row + 3), 0.75F);
    }
    EXPECT_EQ(mattes.crowded, 0U);
}

TEST(Mattes, the_background_has_no_id) {
    const Mattes mattes = mattes_of(front_view() + object("left", -2, 0, 0));
    for (const Channel& channel : mattes.channels) {
        EXPECT_EQ(channel.values[3], 0) << channel.name;
    }
}

TEST(Mattes, are_channels_of_three_layers_a_kind) {
    const Mattes mattes = mattes_of(front_view() + object("left", -2, 0, 0),
                                    {{MatteKind::object, MatteKind::material}});
    std::string names;
    for (const Channel& channel : mattes.channels) names += channel.name + ' ';
    EXPECT_EQ(names,
              "CryptoObject00.R CryptoObject00.G CryptoObject00.B CryptoObject00.A "
              "CryptoObject01.R CryptoObject01.G CryptoObject01.B CryptoObject01.A "
              "CryptoObject02.R CryptoObject02.G CryptoObject02.B CryptoObject02.A "
              "CryptoMaterial00.R CryptoMaterial00.G CryptoMaterial00.B CryptoMaterial00.A "
              "CryptoMaterial01.R CryptoMaterial01.G CryptoMaterial01.B CryptoMaterial01.A "
              "CryptoMaterial02.R CryptoMaterial02.G CryptoMaterial02.B CryptoMaterial02.A ");
    EXPECT_EQ(mattes.metadata.at("cryptomatte/3ae39a5/manifest"),
              "{\"left\":\"" + hex_of(matte_id("left")) + "\"}");
    EXPECT_EQ(mattes.metadata.at("cryptomatte/be359d6/manifest"), "{\"default\":\"42c9679f\"}");
}

TEST(Mattes, of_materials_are_by_their_names) {
    const Mattes mattes = mattes_of(front_view() +
                                        R"(MakeNamedMaterial "red" "string type" "diffuse"
NamedMaterial "red"
)" + object("left", -2, 0, 0) + object("right", 0.75, 2, 0),
                                    {{MatteKind::material}});
    EXPECT_EQ(coverage(mattes, "red", 0, "CryptoMaterial"), 1);
    EXPECT_EQ(coverage(mattes, "red", 3, "CryptoMaterial"), 0.5F);
    EXPECT_EQ(coverage(mattes, "red", 2, "CryptoMaterial"), 0);
}

/// Of two instances of one name, and of two objects of one name.
TEST(Mattes, things_of_one_name_are_one_thing) {
    const std::string again = "Translate .5 0 1\nObjectInstance \"bar\"\n";
    const Mattes mattes = mattes_of(front_view() + object("bar", -2, 0.25, 0) + again);
    EXPECT_EQ(coverage(mattes, "bar", 2), 1);
    EXPECT_EQ(coverage(mattes, "bar", 3), 0.5F);
}

TEST(Mattes, rays_pass_holes_of_alpha_and_null_interfaces) {
    const std::string behind = object("behind", -2, 2, 3);
    const Mattes holes =
        mattes_of(front_view() + object("leaves", -2, 2, 0, "\"float alpha\" .25") + behind,
                  {.kinds = {MatteKind::object}, .samples = 1024});
    // The alpha test is a hash of each ray: within 5 deviations of 1024 tries.
    EXPECT_NEAR(coverage(holes, "leaves", 5), 0.25F, 5 * 0.0135F);
    EXPECT_FLOAT_EQ(coverage(holes, "leaves", 5) + coverage(holes, "behind", 5), 1);
    const Mattes fog = mattes_of(front_view() + R"(MakeNamedMedium "fog" "string type" "homogeneous"
AttributeBegin
Material "interface"
MediumInterface "fog" ""
Shape "sphere" "float radius" 2
AttributeEnd
)" + behind);
    EXPECT_EQ(coverage(fog, "behind", 5), 1);
}

TEST(Mattes, glass_counts_as_itself) {
    const Mattes mattes = mattes_of(front_view() + "Material \"dielectric\"\n" +
                                    object("pane", -2, 2, 0) + object("behind", -2, 2, 1));
    EXPECT_EQ(coverage(mattes, "pane", 5), 1);
}

/// Nine strips in one pixel, the wider the farther to the right.
TEST(Mattes, more_than_six_ids_leave_the_least_out) {
    std::string scene = front_view();
    double x = 0;
    for (int i = 1; i <= 9; ++i) {
        const double width = 0.5 * i / 45;
        scene += object("strip" + std::to_string(i), x, x + width, 0);
        x += width;
    }
    const Mattes mattes = mattes_of(scene, {.kinds = {MatteKind::object}, .samples = 4096});
    EXPECT_EQ(mattes.crowded, 4U);
    for (int i = 1; i <= 9; ++i)
        EXPECT_NEAR(coverage(mattes, "strip" + std::to_string(i), 6),
                    i > 3 ? static_cast<float>(i) / 45 : 0, 1e-3F)
            << i;
}

/// The pixel filter reaches over the pixel's edges. Triangle of radius 1: from the pixel's middle
/// outwards the share beyond a distance d is (1 - d)^2 / 2.
TEST(Mattes, pixels_are_filtered_as_the_picture_is) {
    const Mattes mattes = mattes_of(
        front_view(R"("triangle" "float xradius" 1 "float yradius" 1)") + object("left", -2, 0, 0),
        {.kinds = {MatteKind::object}, .samples = 1024});
    EXPECT_NEAR(coverage(mattes, "left", 4), 1, 1e-6);
    EXPECT_NEAR(coverage(mattes, "left", 5), 1 - 0.125F, 2e-3F);
    EXPECT_NEAR(coverage(mattes, "left", 6), 0.125F, 2e-3F);
    EXPECT_EQ(coverage(mattes, "left", 7), 0);
}

TEST(Mattes, are_the_same_for_any_number_of_threads) {
    std::string scene = front_view();
    for (int i = 0; i < 20; ++i)
        scene += object("bar" + std::to_string(i), -0.9 + 0.09 * i, -0.85 + 0.1 * i, i);
    const auto with = [&](std::size_t threads) {
        const ThreadLimit limit(threads);
        const Mattes mattes = mattes_of(scene, {{MatteKind::object, MatteKind::material}});
        return std::pair(mattes.channels, mattes.metadata);
    };
    EXPECT_EQ(with(1), with(2));
}

}  // namespace
}  // namespace sunfleck::engine

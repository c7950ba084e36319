// A relit picture is the sum of its lights, each as bright as it is to be.
#include "film/relight.h"

#include "film/film_picture.h"
#include "sunfleck/error.h"
#include "synthetic.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::film_of;
using testing_support::numbers;
using testing_support::small_key;

/// Two pixels: RGB, of which "sun" and "lamp" are parts; and an AOV of each other kind.
Picture two_lights() {
    Picture picture{2, 1, {}, {{kLightGroupNames, "sun lamp"}, {"software", "x"}}};
    const auto add = [&](const std::string& name, float first, float second) {
        picture.add(name).values = {first, second};
    };
    add("R", 10, 4);
    add("G", 20, 5);
    add("B", 30, 6);
    for (const char* channel : {"sun.R", "sun.G", "sun.B"}) add(channel, 4, 0);
    for (const char* channel : {"lamp.R", "lamp.G", "lamp.B"}) add(channel, 2, 3);
    add("direct.R", 1, 1);
    add("depth.Z", 7, 8);
    add("error.Y", 1, 1);
    return picture;
}

std::vector<float> values(const Picture& picture, const std::string& name) {
    const Channel* channel = picture.find(name);
    return channel == nullptr ? std::vector<float>() : channel->values;
}

TEST(Relight, adds_what_each_layer_gains) {
    const Relit one = relit(two_lights(), {{"lamp", {0, 0.5F, 2}}}, "x.exr");
    EXPECT_EQ(values(one.picture, "R"), (std::vector<float>{8, 1}));
    EXPECT_EQ(values(one.picture, "G"), (std::vector<float>{19, 3.5F}));
    EXPECT_EQ(values(one.picture, "B"), (std::vector<float>{32, 9}));
    EXPECT_EQ(values(one.picture, "lamp.G"), (std::vector<float>{1, 1.5F}));
    EXPECT_EQ(values(one.picture, "sun.R"), (std::vector<float>{4, 0}));
    const Relit both = relit(two_lights(), {{"lamp", Vec3(0)}, {"sun", Vec3(3)}}, "x.exr");
    EXPECT_EQ(values(both.picture, "R"), (std::vector<float>{16, 1}));
}

/// And can be relit again: back to what it was.
TEST(Relight, is_undone_by_the_inverse) {
    const Relit there = relit(two_lights(), {{"lamp", Vec3(4)}, {"sun", Vec3(0.5F)}}, "x.exr");
    const Relit back = relit(there.picture, {{"lamp", Vec3(0.25F)}, {"sun", Vec3(2)}}, "x.exr");
    for (const char* channel : {"R", "G", "B", "sun.G", "lamp.B"})
        EXPECT_EQ(values(back.picture, channel), values(two_lights(), channel)) << channel;
}

TEST(Relight, leaves_out_what_no_longer_holds) {
    const Relit result = relit(two_lights(), {{"sun", Vec3(1)}}, "x.exr");
    EXPECT_EQ(result.left_out, (std::vector<std::string>{"direct", "error"}));
    EXPECT_TRUE(values(result.picture, "direct.R").empty());
    EXPECT_TRUE(values(result.picture, "error.Y").empty());
    EXPECT_EQ(values(result.picture, "depth.Z"), (std::vector<float>{7, 8}));
    EXPECT_EQ(result.picture.metadata, two_lights().metadata);
}

TEST(Relight, of_a_film_keeps_its_picture_when_nothing_changes) {
    const Picture before = film_picture(film_of(small_key(), numbers(0, 40)));
    const Relit after = relit(before, {{"sun", Vec3(1)}, {"lamp", Vec3(1)}}, "x.exr");
    for (const char* channel : {"R", "G", "B", "sun.R", "lamp.B", "depth.Z"})
        EXPECT_EQ(values(after.picture, channel), values(before, channel)) << channel;
}

TEST(Relight, leaves_what_is_in_no_group) {
    EXPECT_EQ(light_groups_of(two_lights()), (std::vector<std::string>{"lamp", "sun"}));
    const Picture rest = rest_of_light(two_lights());
    ASSERT_EQ(rest.channels.size(), 3U);
    EXPECT_EQ(values(rest, "R"), (std::vector<float>{4, 1}));
    EXPECT_EQ(values(rest, "B"), (std::vector<float>{24, 3}));
    Picture plain = two_lights();
    plain.metadata.clear();
    EXPECT_TRUE(light_groups_of(plain).empty());
    EXPECT_EQ(values(rest_of_light(plain), "R"), (std::vector<float>{10, 4}));
}

TEST(Relight, refuses_what_is_not_there) {
    const auto fault = [](const Picture& picture, const std::vector<LightGroupFactor>& factors) {
        try {
            relit(picture, factors, "x.exr");
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(fault(two_lights(), {{"moon", Vec3(1)}}),
              "x.exr: has no light group \"moon\"; use some of lamp, sun");
    EXPECT_EQ(fault(two_lights(), {{"direct", Vec3(1)}}),
              "x.exr: has no light group \"direct\"; use some of lamp, sun");
    EXPECT_EQ(fault(two_lights(), {{"sun", Vec3(1)}, {"sun", Vec3(2)}}),
              "x.exr: the light group \"sun\" is named twice; name each once");
    Picture plain = two_lights();
    plain.metadata.clear();
    EXPECT_EQ(fault(plain, {{"sun", Vec3(1)}}),
              "x.exr: has no light groups; render it with --light-group, as .exr");
    Picture cut = two_lights();
    cut.channels.erase(cut.channels.begin() + 4);  // sun.G
    EXPECT_EQ(fault(cut, {{"sun", Vec3(1)}}),
              "x.exr: has no channel \"sun.G\"; use a picture rendered by sunfleck");
}

}  // namespace
}  // namespace sunfleck::engine

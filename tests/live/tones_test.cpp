// What a page makes of light by a table is what a .png has.
#include "live/tones.h"

#include "image/tone.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <bit>
#include <cmath>
#include <cstdint>

namespace sunfleck::engine {
namespace {

/// As the page does it: matrix, table, matrix, power.
Vec3 shown_by_page(const nlohmann::json& tone, const Vec3& light) {
    const auto times = [&](const char* rows, const Triple& v) {
        Triple product{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                product[i] += tone.at(rows).at(i).at(j).get<double>() * v[j];
        return product;
    };
    Triple channels = times("in", {light.x, light.y, light.z});
    for (double& channel : channels) {
        const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(channel));
        channel = channel > 0 ? tone.at("values").at(bits >> 16U).get<double>() : 0;
    }
    channels = times("out", channels);
    Vec3 shown;
    for (int c = 0; c < 3; ++c)
        shown[c] = static_cast<float>(
            std::pow(std::clamp(channels.at(static_cast<std::size_t>(c)), 0.0, 1.0),
                     tone.at("decoding").get<double>()));
    return shown;
}

TEST(LiveTones, are_those_of_files_to_the_table_s_width) {
    for (const auto& row : kTones) {
        const nlohmann::json tone = nlohmann::json::parse(tone_json(row.name));
        ASSERT_EQ(tone.at("values").size(), 0x8000U);
        for (const float brightness : {0.0F, 0.004F, 0.05F, 0.18F, 0.9F, 4.0F, 1e4F}) {
            for (const Vec3& colour : {Vec3(1), Vec3(1, 0.5F, 0.1F), Vec3(0, 0.2F, 1)}) {
                const Vec3 file = toned(row.value, colour * brightness);
                const Vec3 page = shown_by_page(tone, colour * brightness);
                for (int c = 0; c < 3; ++c) {
                    EXPECT_NEAR(page[c], file[c], 0.012) << row.name << " " << brightness;
                }
            }
        }
    }
}

TEST(LiveTones, of_no_name_are_light_itself) {
    EXPECT_EQ(tone_json("<script>"), tone_json("none"));
    EXPECT_NE(tone_json("agx"), tone_json("none"));
}

}  // namespace
}  // namespace sunfleck::engine

// Manifests as JSON, attributes by key, IDs by rank.
#include "mattes/manifest.h"

#include "mattes/ranking.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Manifest, is_json_in_the_order_of_names) {
    EXPECT_EQ(manifest_json({}), "{}");
    EXPECT_EQ(manifest_json({{"default", matte_id("default")}, {"bunny", matte_id("bunny")}}),
              R"({"bunny":"13851a76","default":"42c9679f"})");
}

TEST(Manifest, escapes_what_json_does_not_take) {
    EXPECT_EQ(manifest_json({{"a \"b\" \\ \n", 0x12345678}}),
              R"({"a \"b\" \\ \u000a":"12345678"})");
}

TEST(Manifest, has_attributes_by_a_key_of_seven_digits) {
    const auto attributes = matte_metadata("CryptoObject", {{"bunny", matte_id("bunny")}});
    ASSERT_EQ(attributes.size(), 4U);
    EXPECT_EQ(attributes.at("cryptomatte/3ae39a5/name"), "CryptoObject");
    EXPECT_EQ(attributes.at("cryptomatte/3ae39a5/hash"), "MurmurHash3_32");
    EXPECT_EQ(attributes.at("cryptomatte/3ae39a5/conversion"), "uint32_to_float32");
    EXPECT_EQ(attributes.at("cryptomatte/3ae39a5/manifest"), R"({"bunny":"13851a76"})");
}

TEST(Ranking, goes_by_coverage_and_then_by_id) {
    std::vector<MatteId> samples = {7, 5, 0, 9, 5, 9, 7, 3, 9, 0, 0, 0};
    const std::vector<RankedId> ranked = ranked_ids(samples);
    EXPECT_EQ(ranked, (std::vector<RankedId>{{9, 3}, {5, 2}, {7, 2}, {3, 1}}));
}

TEST(Ranking, of_nothing_is_empty) {
    std::vector<MatteId> samples(16, kNoMatteId);
    EXPECT_TRUE(ranked_ids(samples).empty());
}

}  // namespace
}  // namespace sunfleck::engine

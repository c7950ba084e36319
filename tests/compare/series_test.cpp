// Folders of snapshots, and bands over seeds.
#include "compare/series.h"

#include "image/temporary_folder.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <fstream>

namespace sunfleck::engine {
namespace {

class Series : public testing_support::TemporaryFolder {
protected:
    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
        std::ofstream(path(name)) << text;
    }

    /// A picture's name and its stats; the picture itself is not looked at here.
    void snapshot(const std::string& name, int passes, double seconds) const {
        write(name + ".exr", "");
        write(name + ".json", "{\"passes\": " + std::to_string(passes) +
                                  ", \"cpu_seconds\": " + std::to_string(2 * seconds) +
                                  ", \"seconds\": {\"total\": " + std::to_string(seconds) + "}}");
    }

    std::string refusal() const {
        try {
            read_series(path(""));
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(Series, of_one_seed_is_a_folder_in_the_order_of_passes) {
    snapshot("b", 2, 0.5);
    snapshot("a", 16, 3);
    snapshot("c", 1, 0.25);
    const auto seeds = read_series(path(""));
    ASSERT_EQ(seeds.size(), 1U);
    ASSERT_EQ(seeds[0].size(), 3U);
    EXPECT_EQ(seeds[0][0].passes, 1U);
    EXPECT_EQ(seeds[0][1].seconds, 0.5);
    EXPECT_EQ(seeds[0][2].cpu_seconds, 6);
    EXPECT_EQ(seeds[0][2].picture, path("a.exr"));
}

/// A render puts it there, without statistics. A picture of that name that has some is one as any.
TEST_F(Series, leaves_out_the_newest_picture_once_more) {
    snapshot("passes-000001", 1, 1);
    write("latest.exr", "");
    write("latest.png", "");
    EXPECT_EQ(read_series(path("")).at(0).size(), 1U);
    snapshot("latest", 2, 2);
    EXPECT_EQ(read_series(path("")).at(0).size(), 2U);
}

TEST_F(Series, of_several_seeds_are_subfolders) {
    snapshot("seed2/x", 1, 1);
    snapshot("seed1/x", 1, 2);
    snapshot("seed1/y", 2, 3);
    write("notes/readme.txt", "no pictures");
    const auto seeds = read_series(path(""));
    ASSERT_EQ(seeds.size(), 2U);
    EXPECT_EQ(seeds[0].size(), 2U);
    EXPECT_EQ(seeds[0][0].seconds, 2);
    EXPECT_EQ(seeds[1].size(), 1U);
}

TEST_F(Series, stats_without_cpu_seconds_are_read) {
    write("x.exr", "");
    write("x.json", R"({"passes": 3, "seconds": {"total": 1.5}})");
    EXPECT_EQ(read_series(path(""))[0][0].cpu_seconds, 0);
}

TEST_F(Series, what_is_no_series_is_refused) {
    EXPECT_NE(refusal().find("contains no .exr"), std::string::npos);
    write("x.exr", "");
    EXPECT_NE(refusal().find("there is no x.json"), std::string::npos);
    write("x.json", "");
    EXPECT_NE(refusal().find("is empty"), std::string::npos) << refusal();
    for (const char* text : {"[1, 2]", "{\"passes\": 3}", "{\"passes\": \"x\", \"seconds\": {}}",
                             "{\"passes\": 3, \"seconds\": {\"total\": null}}"}) {
        write("x.json", text);
        EXPECT_NE(refusal().find("is not a statistics file"), std::string::npos) << text;
    }
    write("x.json", R"({"passes": 3, "seconds": {"total": 0}})");
    EXPECT_NE(refusal().find("render time of zero"), std::string::npos);
    snapshot("x", 1, 1);
    snapshot("below/y", 1, 1);
    EXPECT_NE(refusal().find("so do its subfolders"), std::string::npos);
}

TEST(Bands, are_quartiles_and_median) {
    const Band five = band_of({5, 1, 3, 2, 4});
    EXPECT_EQ(five.low, 2);
    EXPECT_EQ(five.middle, 3);
    EXPECT_EQ(five.high, 4);
    const Band two = band_of({1, 2});
    EXPECT_EQ(two.low, 1.25);
    EXPECT_EQ(two.middle, 1.5);
    EXPECT_EQ(two.high, 1.75);
    EXPECT_EQ(band_of({Metrics::kNone, 7}).high, 7);
    EXPECT_TRUE(std::isnan(band_of({Metrics::kNone}).middle));
}

SeriesSample sample(std::uint64_t passes, double seconds, double mse) {
    SeriesSample s{{"", passes, seconds, 2 * seconds}, {}};
    s.metrics.mse = mse;
    return s;
}

/// Passes 1 and 2 are common, 4 is not; the ends, at 5 and 4 passes, make a point of their own.
TEST(Points, are_where_all_seeds_have_as_many_passes_and_at_the_ends) {
    const auto points = series_points({{sample(1, 1, 8), sample(2, 2, 4), sample(5, 4, 2)},
                                       {sample(1, 3, 6), sample(2, 4, 3), sample(4, 6, 1)}});
    ASSERT_EQ(points.size(), 3U);
    EXPECT_EQ(points[0].passes, 1);
    EXPECT_EQ(points[0].seconds, 2);
    EXPECT_EQ(points[0].cpu_seconds, 4);
    EXPECT_EQ(points[0].bands[0].middle, 7);
    EXPECT_EQ(points[0].bands[0].low, 6.5);
    EXPECT_EQ(points[1].bands[0].middle, 3.5);
    EXPECT_EQ(points[2].passes, 4.5);
    EXPECT_EQ(points[2].seconds, 5);
    EXPECT_EQ(points[2].bands[0].high, 1.75);
    EXPECT_TRUE(std::isnan(points[2].bands[1].middle));
}

TEST(Points, of_equal_ends_are_not_doubled) {
    EXPECT_EQ(series_points({{sample(1, 1, 1), sample(2, 2, 1)}, {sample(2, 3, 1)}}).size(), 1U);
}

}  // namespace
}  // namespace sunfleck::engine

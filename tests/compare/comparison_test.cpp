// From names on the command line to measured pictures, the table and JSON.
#include "compare/comparison.h"

#include "image/picture_file.h"
#include "image/temporary_folder.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace sunfleck::engine {
namespace {

class Comparisons : public testing_support::TemporaryFolder {
protected:
    /// A picture of one grey. @return its path.
    std::string grey(const std::string& name, float value, int width = 8) const {
        Picture picture{width, 4, {}, {}};
        for (const char* channel : {"R", "G", "B"}) {
            Channel& c = picture.add(channel);
            c.values.assign(c.values.size(), value);
        }
        std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
        write_picture(path(name), picture);
        return path(name);
    }

    void stats(const std::string& name, int passes, double seconds) const {
        std::ofstream(path(name)) << nlohmann::json{{"passes", passes},
                                                    {"seconds", {{"total", seconds}}}};
    }

    std::string refusal(const std::string& reference, const std::vector<std::string>& texts) const {
        try {
            std::vector<CompareInput> inputs;
            inputs.reserve(texts.size());
            for (const std::string& text : texts) inputs.push_back(compare_input(text));
            compare(compare_input(reference), inputs);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(Comparisons, inputs_have_labels) {
    EXPECT_EQ(compare_input("a=b/c.exr").label, "a");
    EXPECT_EQ(compare_input("a=b/c.exr").path, "b/c.exr");
    EXPECT_EQ(compare_input("b/c.d.exr").label, "c.d");
    const std::string odd = grey("x=y.exr", 1);
    EXPECT_EQ(compare_input(odd).path, odd);
    std::filesystem::create_directories(path("series"));
    EXPECT_EQ(compare_input(path("series")).label, "series");
    EXPECT_EQ(compare_input(path("series/")).label, "series");
    EXPECT_THROW(compare_input("=x.exr"), Error);
    EXPECT_THROW(compare_input("x="), Error);
}

TEST_F(Comparisons, measure_every_picture) {
    const Comparison c =
        compare(compare_input(grey("r.exr", 1)),
                {compare_input(grey("a.exr", 1)), compare_input("half=" + grey("b.exr", 0.5F))});
    ASSERT_EQ(c.pictures.size(), 2U);
    EXPECT_EQ(c.pictures[0].measured.metrics.mse, 0);
    EXPECT_EQ(c.pictures[1].measured.metrics.mse, 0.25);
    const auto json = nlohmann::json::parse(comparison_json(c));
    EXPECT_EQ(json["width"], 8);
    EXPECT_EQ(json["reference"]["label"], "r");
    EXPECT_EQ(json["pictures"][1]["label"], "half");
    EXPECT_EQ(json["pictures"][1]["metrics"]["mse"], 0.25);
    EXPECT_EQ(json["pictures"][1]["metrics"].size(), kMetrics.size());
    EXPECT_FALSE(json["pictures"][1].contains("series"));
    const std::string table = comparison_table(c);
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
    EXPECT_NE(table.find("\nhalf "), std::string::npos);
    EXPECT_NE(table.find("0.25"), std::string::npos);
}

TEST_F(Comparisons, tell_what_they_leave_out) {
    const Comparison c =
        compare(compare_input(grey("r.exr", 1)), {compare_input("bad=" + grey("a.exr", INFINITY))});
    EXPECT_EQ(c.pictures[0].broken, 32U);
    EXPECT_NE(comparison_table(c).find("bad: 32 of 32 pixels are NaN or infinite, and left out"),
              std::string::npos);
    const auto json = nlohmann::json::parse(comparison_json(c));
    EXPECT_EQ(json["pictures"][0]["left_out"], 32);
    EXPECT_TRUE(json["pictures"][0]["metrics"]["mse"].is_null());
}

TEST_F(Comparisons, of_a_series_show_the_first_seed_s_last) {
    for (const int seed : {1, 2, 3}) {
        const std::string folder = "s/" + std::to_string(seed) + "/";
        grey(folder + "one.exr", 1 + 0.2F * static_cast<float>(seed));
        stats(folder + "one.json", 1, 1);
        grey(folder + "two.exr", 1 + 0.1F * static_cast<float>(seed));
        stats(folder + "two.json", 2, 2);
    }
    const Comparison c = compare(compare_input(grey("r.exr", 1)), {compare_input(path("s"))});
    EXPECT_EQ(c.pictures[0].shown, path("s/1/two.exr"));
    EXPECT_NEAR(c.pictures[0].measured.metrics.mse, 0.01, 1e-6);
    EXPECT_EQ(c.pictures[0].seeds, 3U);
    const auto json = nlohmann::json::parse(comparison_json(c));
    const auto& points = json["pictures"][0]["series"]["points"];
    ASSERT_EQ(points.size(), 2U);
    EXPECT_NEAR(points[0]["mse"][1], 0.16, 1e-6);
    EXPECT_NEAR(points[1]["mse"][1], 0.04, 1e-6);
    EXPECT_NEAR(points[1]["mse"][2], (0.04 + 0.09) / 2, 1e-6);
    EXPECT_FALSE(points[0].contains("hdr_flip"));
}

TEST_F(Comparisons, what_cannot_be_compared_is_refused) {
    const std::string r = grey("r.exr", 1);
    EXPECT_NE(refusal(r, {grey("wide.exr", 1, 9)}).find("9 x 4 pixels, and the reference 8 x 4"),
              std::string::npos);
    EXPECT_NE(refusal(r, {"a=" + r, "a=" + r}).find("second picture called \"a\""),
              std::string::npos);
    EXPECT_NE(refusal(path(""), {r}).find("is a folder"), std::string::npos);
    EXPECT_NE(refusal(r, {path("missing.exr")}).find("there is no file"), std::string::npos);
}

}  // namespace
}  // namespace sunfleck::engine

// How often the 95% intervals of blocks hold what they should: 92 to 98%. Blocks of 8 x 8 pixels,
// the default sampler: the mean of 32 batches and Student's t (31 degrees of freedom) times its
// standard error; and two errors as they are reported (95.4%), each time that an early batch ends.
// Against the expectation at the same radii, for the bias of discs is no part of error bars.
//
// The expectation is taken to be the mean over all renders of a case. Each render has its share in
// that mean, and the mean its own error: with S renders of one variance the distance between both
// is smaller than that to the expectation, by the root of 1 - 1/S, and is enlarged by as much.
//
// Blocks of a picture share much of their error. So what is counted is known as well as the shares
// of single renders say: to one standard error of 1.2% or less, with which a true 95% lies in the
// band with more than 98% certainty, and a true 89% out of it with as much. Seeds are fixed.
#include "film/error_bars.h"
#include "support/films.h"
#include "support/procedural.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

struct Case {
    std::string name;
    std::string scene;
    std::uint32_t paths;  // a pass
    int renders;
    bool starts_small = false;  // as a large picture does
};

/// Of a test's name.
std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

class Coverage : public testing::TestWithParam<Case> {
protected:
    static constexpr std::uint32_t kBatches = 32;
    static constexpr double kQuantile = 2.0395;  // Student's t, 97.5%, 31 degrees of freedom
    static constexpr int kSize = 32;

    using Blocks = std::vector<MeanError>;

    /// Calls render(scene, settings) with each seed.
    template <class Render>
    static void for_seeds(const Render& render) {
        const Scene scene = procedural(GetParam().scene, kSize);
        RenderSettings settings;
        settings.photon.paths_per_pass = GetParam().paths;
        if (GetParam().starts_small) settings.large_picture = 0;
        for (int seed = 0; seed < GetParam().renders; ++seed) {
            settings.seed = static_cast<std::uint64_t>(seed);
            render(scene, settings);
        }
    }

    /// Blocks by render.
    static std::vector<Blocks> renders() {
        std::vector<Blocks> all;
        for_seeds([&](const Scene& scene, const RenderSettings& settings) {
            all.push_back(block_errors(film_of_batches(scene, settings, kBatches)));
        });
        return all;
    }

    /// Shares of intervals, with the spread between renders.
    struct Shares {
        Estimate hold;
        Estimate below;  // the whole interval is below the expectation
    };

    /// @param quantile  times the standard error: half of an interval.
    static Shares shares_of(const std::vector<Blocks>& all, double quantile) {
        const auto renders = static_cast<double>(all.size());
        const auto count = static_cast<double>(all[0].size());
        Blocks means(all[0].size());
        for (const Blocks& blocks : all)
            for (std::size_t b = 0; b < blocks.size(); ++b)
                means[b].mean += blocks[b].mean / renders;
        const double widened = std::sqrt(renders / (renders - 1));
        std::vector<double> hold;
        std::vector<double> below;
        for (const Blocks& blocks : all) {
            hold.push_back(0);
            below.push_back(0);
            for (std::size_t b = 0; b < blocks.size(); ++b) {
                const double distance = (blocks[b].mean - means[b].mean) * widened;
                const double reach = quantile * blocks[b].standard_error;
                if (std::abs(distance) <= reach) hold.back() += 1 / count;
                if (distance < -reach) below.back() += 1 / count;
            }
        }
        return {Estimate::of(hold), Estimate::of(below)};
    }
};

std::string text_of(const Estimate& share) {
    return std::to_string(share.mean) + " +- " + std::to_string(share.error);
}

TEST_P(Coverage, of_blocks_is_that_of_their_intervals) {
    const Shares shares = shares_of(renders(), kQuantile);
    RecordProperty("hold", text_of(shares.hold));
    RecordProperty("below", text_of(shares.below));
    EXPECT_LT(shares.hold.error, 0.012);
    EXPECT_GT(shares.hold.mean, 0.92)
        << text_of(shares.hold) << "; below: " << text_of(shares.below);
    EXPECT_LT(shares.hold.mean, 0.98) << text_of(shares.hold);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Coverage,
                         testing::Values(Case{"cornell", "cornell", 1000, 64},
                                         Case{"cognac_2", "cognac-2", 20'000, 72},
                                         Case{"smoke", "smoke", 2000, 64}),
                         [](const auto& info) { return info.param.name; });

class EarlyCoverage : public Coverage {
protected:
    /// Blocks by render with errors as they are reported, by the passes at which a batch ends.
    static std::map<std::uint64_t, std::vector<Blocks>> early_renders() {
        std::map<std::uint64_t, std::vector<Blocks>> all;
        const auto see = [&](const Film& film) {
            const std::uint64_t passes = film.pass_count();
            if (passes < 2 || next_batch_end(passes - 1) != passes) return;
            Blocks blocks = block_errors(film);
            for (MeanError& block : blocks) block.standard_error *= widening(film);
            all[passes].push_back(std::move(blocks));
        };
        for_seeds([&](const Scene& scene, const RenderSettings& settings) {
            film_of_batches(scene, settings, GetParam().starts_small ? 1 : 4, see);
        });
        return all;
    }
};

/// Each share is known to a percent or so: the band is left by more than three of these.
TEST_P(EarlyCoverage, of_blocks_is_that_of_their_intervals) {
    for (const auto& [passes, blocks] : early_renders()) {
        const Shares shares = shares_of(blocks, 2);
        RecordProperty("hold_" + std::to_string(passes), text_of(shares.hold));
        RecordProperty("below_" + std::to_string(passes), text_of(shares.below));
        EXPECT_GT(shares.hold.mean + 3 * shares.hold.error, 0.92) << passes;
        EXPECT_LT(shares.hold.mean - 3 * shares.hold.error, 0.98) << passes;
    }
}

Case early(const std::string& scene) {
    std::string name = scene;
    std::replace(name.begin(), name.end(), '-', '_');
    return {name, scene, 10'000, 40};
}

Case early_small(const std::string& scene) {
    Case of_scene = early(scene);
    of_scene.name += "_small";
    of_scene.starts_small = true;
    return of_scene;
}

INSTANTIATE_TEST_SUITE_P(Scenes, EarlyCoverage,
                         testing::Values(early("cornell"), early("room"), early("iced-tea"),
                                         early("window-room"), early("cognac-2"), early("cognac-4"),
                                         early("statue-near"), early("diamond"), early("magnifier"),
                                         early("two-windows"), early("light-shafts"),
                                         early("smoke"), early_small("cornell"),
                                         early_small("room"), early_small("cognac-2"),
                                         early_small("window-room")),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace sunfleck::engine

// One render by many ranks: film, end and snapshots are those of one machine.
#include "ranks/shared_interval.h"
#include "render/pass_maker.h"
#include "render/progressive.h"
#include "sunfleck/error.h"
#include "support/renders.h"
#include "support/thread_ranks.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

class ManyRanks : public ::testing::Test {
protected:
    ManyRanks() {
        settings_.photon.paths_per_pass = 60;
        settings_.transport.direct = DirectLight::photons;  // or there is no noise
        settings_.aovs.fill(true);
    }

    RenderJob job(const StopSettings& stop) const { return {scene_, settings_, stop}; }

    static StopSettings passes(std::uint32_t first, std::uint32_t end) {
        StopSettings stop;
        stop.first_pass = first;
        stop.end_pass = end;
        return stop;
    }

    RenderResult alone(const StopSettings& stop) const { return render(job(stop), {}); }

    RenderResult among(int size, const StopSettings& stop, const RenderHooks& hooks = {},
                       std::optional<RenderState> earlier = {}) const {
        std::optional<RenderResult> result;
        on_ranks(size, [&](const Ranks& ranks) {
            if (ranks.is_first())
                result = render(job(stop), hooks, std::move(earlier), ranks);
            else
                render(job(stop), {}, {}, ranks);
        });
        return std::move(*result);
    }

    void expect_same(const RenderState& state, const RenderState& expected) const {
        EXPECT_TRUE(state.film.sums() == expected.film.sums());
        EXPECT_EQ(state.radius_factor, expected.radius_factor);
    }

    Scene scene_ =
        scene_of(view("0 -4 2  0 0 0.5  0 0 1", 40, 9) +
                 "LightSource \"distant\" \"point3 from\" [1 1 3] \"point3 to\" [0 0 0]\n" +
                 diffuse("1 1 1") + quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0"));
    RenderSettings settings_;
};

TEST_F(ManyRanks, make_the_film_of_one) {
    for (const auto& stop : {passes(0, 1), passes(0, 16), passes(0, 37), passes(5, 61)}) {
        const RenderResult expected = alone(stop);
        for (const int size : {2, 3, 4, 7, 20}) expect_same(among(size, stop), expected);
    }
}

TEST_F(ManyRanks, go_on_from_what_one_has_rendered) {
    const RenderResult expected = alone(passes(0, 50));
    for (const std::uint32_t begun : {3U, 16U, 21U})
        expect_same(among(3, passes(0, 50), {}, alone(passes(0, begun))), expected);
    expect_same(render(job(passes(0, 50)), {}, among(5, passes(0, 23))), expected);
}

/// At the batch at which one machine ends, though more had been begun.
TEST_F(ManyRanks, end_at_the_same_target_error) {
    StopSettings stop = passes(0, 2000);
    stop.target_error = 0.3;
    const RenderResult expected = alone(stop);
    const std::uint64_t count = expected.film.pass_count();
    ASSERT_GT(count, 64U) << "or any error would do";
    ASSERT_LT(count, 2000U);
    ASSERT_NE(count % 50, 0U) << "or no pass is begun in vain";
    for (const int size : {2, 3, 20, 50}) expect_same(among(size, stop), expected);
}

TEST_F(ManyRanks, end_in_time_without_a_hole) {
    StopSettings stop;
    stop.seconds = 0.3;
    for (const int size : {2, 5}) {
        const RenderResult state = among(size, stop);
        EXPECT_GE(state.total_seconds, 0.3);
        expect_same(state, alone(passes(0, static_cast<std::uint32_t>(state.film.pass_count()))));
    }
    stop.seconds = 1e-6;
    EXPECT_EQ(among(5, stop).film.pass_count(), 5U) << "a pass each";
}

TEST_F(ManyRanks, end_when_any_is_interrupted) {
    for (const int which : {0, 2, 4}) {
        std::optional<RenderResult> result;
        on_ranks(5, [&](const Ranks& ranks) {
            const std::atomic<bool> interrupted{ranks.rank == which};
            RenderHooks hooks;
            hooks.interrupted = &interrupted;
            RenderResult mine = render(job(passes(0, 1000)), hooks, {}, ranks);
            if (ranks.is_first()) result = std::move(mine);
        });
        EXPECT_TRUE(result->interrupted);
        EXPECT_EQ(result->film.pass_count(), 5U);
    }
}

TEST_F(ManyRanks, take_the_same_snapshots) {
    for (const int size : {2, 3}) {
        std::vector<std::uint64_t> seen;
        RenderHooks hooks;
        hooks.snapshot = [&](const RenderResult& so_far) {
            seen.push_back(so_far.film.pass_count());
        };
        among(size, passes(0, 37), hooks);
        EXPECT_EQ(seen, (std::vector<std::uint64_t>{1, 2, 4, 8, 16, 32, 37}));
    }
}

TEST_F(ManyRanks, save_what_one_machine_would_have) {
    RenderHooks hooks;
    hooks.save_every = 0;
    std::vector<std::uint64_t> seen;
    hooks.save = [&](const RenderState& state) {
        seen.push_back(state.film.pass_count());
        expect_same(state, alone(passes(0, static_cast<std::uint32_t>(seen.back()))));
    };
    among(4, passes(0, 18), hooks);
    EXPECT_EQ(seen, (std::vector<std::uint64_t>{4, 8, 12, 16, 18}));
}

TEST_F(ManyRanks, add_their_times_up) {
    on_ranks(6, [&](const Ranks& ranks) {
        const RenderJob of_this = job({});
        RenderState state{Film(key_of(of_this)), {}, 0, 0, 1, {}};
        PassMaker passes(of_this, state);
        SharedInterval interval(
            ranks, state.film.key(), false,
            [&](std::uint32_t number, Film& film) { return *passes.make(number, film); });
        const RankNote all = interval.render(
            {0, 3},
            [&] {
                return RankNote{1.0 + ranks.rank, false};
            },
            [](const PassRange&, const Film& film, double) { EXPECT_EQ(film.pass_count(), 3U); });
        if (!ranks.is_first()) return;
        EXPECT_EQ(all.cpu_seconds, 21);
        EXPECT_FALSE(all.interrupted);
    });
}

TEST_F(ManyRanks, refuse_the_sampler_paper) {
    settings_.photon.sampler = PhotonSampler::paper;
    EXPECT_EQ(alone(passes(0, 2)).film.pass_count(), 2U);
    EXPECT_THROW(among(2, passes(0, 2)), Error);
}

TEST_F(ManyRanks, refuse_to_render_two_scenes) {
    const auto check = [&](std::uint64_t scene, std::uint64_t seed, double alpha) {
        on_ranks(3, [&](const Ranks& ranks) {
            RenderJob mine = job({});
            if (ranks.rank == 2) {
                mine.scene_hash = scene;
                mine.settings.seed = seed;
                mine.settings.alpha = alpha;
            }
            check_same_render(ranks, key_of(mine));
        });
    };
    const double alpha = settings_.alpha;
    EXPECT_NO_THROW(check(0, 0, alpha));
    EXPECT_THROW(check(1, 0, alpha), Error);
    EXPECT_THROW(check(0, 1, alpha), Error);
    EXPECT_THROW(check(0, 0, 0.5), Error);
}

}  // namespace
}  // namespace sunfleck::engine

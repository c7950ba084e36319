// The same bytes however a render is cut: threads and splits, on a room and by sun through a window
// (determinism_nightly_test.cpp: each number of threads with each split, through glass and in
// media, too); what two epochs learn, light groups, media.
#include "app/determinism_support.h"

namespace sunfleck::engine {
namespace {

using testing_support::operator+;

class Determinism : public testing_support::DeterminismTest,
                    public ::testing::WithParamInterface<const char*> {};

// A pass knows nothing of the passes beside it: a fault of threads shows in whole renders, a fault
// of splits with one number of threads.
TEST_P(Determinism, threads_and_splits) {
    use(GetParam(), {"--resolution", "48x40", "--photons-per-pass", "12000", "--aovs",
                     "direct,caustic,indirect,albedo,normal,depth"});
    part("reference", "0:16", 1);
    const Bytes reference = bytes("reference");
    for (const int threads : {2, 3, 8}) expect_whole(threads, reference);
    expect_one_render_of_parts(3, reference);
    expect_one_render_of_passes({1, 2, 3, 8}, reference);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Determinism, ::testing::Values("cornell", "window-room"));

/// What is learned anew in a second epoch, which begins at pass 16.
struct LearnedCase {
    const char* name;
    const char* scene;
    testing_support::Words words;
    int cut;
    std::vector<int> stops;
    const char* resolution = "12x12";
};

/// Of a test's name.
std::ostream& operator<<(std::ostream& out, const LearnedCase& learned) {
    return out << learned.name;
}

class TwoEpochs : public testing_support::DeterminismTest,
                  public ::testing::WithParamInterface<LearnedCase> {};

TEST_P(TwoEpochs, have_the_same_bytes_for_any_threads_and_cuts) {
    const LearnedCase& learned = GetParam();
    use(learned.scene, testing_support::Words{"--resolution", learned.resolution} + learned.words);
    expect_same_bytes(18, learned.cut, learned.stops);
    EXPECT_FALSE(bytes("low") == bytes("whole"));
}

INSTANTIATE_TEST_SUITE_P(
    Of, TwoEpochs,
    ::testing::Values(
        LearnedCase{"sampled", "cornell", {}, 15, {17, 18}},
        LearnedCase{"chains", "keyhole-4", {}, 17, {17, 18}, "48x48"},
        LearnedCase{"adaptive_pixels", "iced-tea", {"--photons-per-pass", "20000"}, 15, {17, 18}},
        LearnedCase{"media", "smoke", {"--photons-per-pass", "4000"}, 15, {17, 18}, "24x32"},
        LearnedCase{"light_strata", "useless-light", {"--photons-per-pass", "3000"}, 7, {17, 18}},
        LearnedCase{"light_groups",
                    "useless-light",
                    {"--photons-per-pass", "3000", "--light-group", "each"},
                    7,
                    {17, 18}}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace sunfleck::engine

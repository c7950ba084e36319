// The same bytes however a render is cut: each number of threads with each split.
#include "app/determinism_support.h"

namespace sunfleck::engine {
namespace {

class DeterminismTable : public testing_support::DeterminismTest,
                         public ::testing::WithParamInterface<const char*> {};

TEST_P(DeterminismTable, threads_by_splits) {
    use(GetParam(), {"--resolution", "48x40", "--photons-per-pass", "12000", "--aovs",
                     "direct,caustic,indirect,albedo,normal,depth"});
    part("reference", "0:16", 1);
    const Bytes reference = bytes("reference");
    const std::vector<int> numbers = {1, 2, 3, 8};
    for (const int threads : numbers) {
        expect_whole(threads, reference);
        expect_one_render_of_parts(threads, reference);
    }
    expect_one_render_of_passes(numbers, reference);
}

INSTANTIATE_TEST_SUITE_P(Scenes, DeterminismTable,
                         ::testing::Values("cornell", "cognac-1", "window-room", "fog-lamp",
                                           "smoke"));

}  // namespace
}  // namespace sunfleck::engine

// Flags by the names that they had: each is refused with the name that it has now.
#include "app/program.h"

namespace sunfleck::engine {
namespace {

using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::Words;

struct OldName {
    const char* before;
    const char* now;
};

class RenamedFlags : public ProgramTest, public ::testing::WithParamInterface<OldName> {};

TEST_P(RenamedFlags, are_answered_with_their_new_name) {
    const std::string before = GetParam().before;
    for (const Words& words : {Words{before, "off"}, Words{before + "=off"}}) {
        const Ran ran = render(words);
        EXPECT_EQ(ran.code, 2);
        EXPECT_NE(ran.err.find(before), std::string::npos) << ran.err;
        EXPECT_NE(ran.err.find(std::string("write ") + GetParam().now), std::string::npos)
            << ran.err;
    }
}

INSTANTIATE_TEST_SUITE_P(All, RenamedFlags,
                         ::testing::Values(OldName{"--emission-maps", "--emission-guide"},
                                           OldName{"--ladder", "--splitting"},
                                           OldName{"--layers", "--aovs"},
                                           OldName{"--light-candidates", "--ris"},
                                           OldName{"--light-groups", "--light-strata"},
                                           OldName{"--light-layer", "--light-group"},
                                           OldName{"--light-search", "--guide-search"},
                                           OldName{"--noisy-pixels", "--adaptive-pixels"}));

}  // namespace
}  // namespace sunfleck::engine

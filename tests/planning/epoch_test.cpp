// Epochs: which pass belongs to which, as docs/method/sampling.md says.
#include "planning/epoch.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Epoch, begins_at_passes_0_16_128_1024) {
    for (const auto& [epoch, first] : {std::pair(0U, 0U), std::pair(1U, 16U), std::pair(2U, 128U),
                                       std::pair(3U, 1024U), std::pair(4U, 8192U)}) {
        EXPECT_EQ(first_pass_of(epoch), first);
        EXPECT_EQ(epoch_of(first), epoch);
        if (first > 0) {
            EXPECT_EQ(epoch_of(first - 1), epoch - 1);
        }
    }
}

}  // namespace
}  // namespace sunfleck::engine

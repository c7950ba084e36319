// Killed five hundred times at random moments.
#include "app/kills_support.h"

namespace sunfleck::engine {
namespace {

using Kills = testing_support::KillTest;

TEST_F(Kills, five_hundred_lose_nothing_but_time) {
    expect_survives(500, 8000, {"0.000001", "0.02"});
}

}  // namespace
}  // namespace sunfleck::engine

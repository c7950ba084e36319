// Killed twenty times at random moments, half of them with a checkpoint after every pass.
#include "app/kills_support.h"

namespace sunfleck::engine {
namespace {

using Kills = testing_support::KillTest;

TEST_F(Kills, twenty_lose_nothing_but_time) {
    expect_survives(20, 400, {"0.000001", "0.005"});
}

}  // namespace
}  // namespace sunfleck::engine

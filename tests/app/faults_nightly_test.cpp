// Calls to the system that fail: every one of each kind in each command.
#include "app/faults_support.h"

namespace sunfleck::engine {
namespace {

using Faults = testing_support::FaultTest;

TEST_F(Faults, of_any_call_end_a_command_with_one_line_and_no_half_file) {
    expect_survives(1000000);
}

}  // namespace
}  // namespace sunfleck::engine

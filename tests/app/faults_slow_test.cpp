// Calls to the system that fail: two of each kind in each command.
#include "app/faults_support.h"

namespace sunfleck::engine {
namespace {

using Faults = testing_support::FaultTest;

TEST_F(Faults, of_single_calls_end_a_command_with_one_line_and_no_half_file) {
    expect_survives(2);
}

}  // namespace
}  // namespace sunfleck::engine

// Free memory follows the limits that the process is under.
#include "core/free_memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>

namespace sunfleck {
namespace {

TEST(FreeMemory, is_at_most_what_the_machine_has) {
    std::ifstream file("/proc/meminfo");
    std::string word;
    std::uint64_t kilobytes = 0;
    if (!(file >> word >> kilobytes) || word != "MemTotal:") GTEST_SKIP() << "no /proc/meminfo";
    EXPECT_GT(free_memory(), 0U);
    EXPECT_LE(free_memory(), kilobytes * 1024);
}

TEST(FreeMemory, is_at_most_what_the_address_space_leaves) {
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
    std::ifstream file("/proc/self/statm");
    std::uint64_t pages = 0;
    if (!(file >> pages)) GTEST_SKIP() << "no /proc/self/statm";
    constexpr std::uint64_t kRoom = 50U << 20U;
    rlimit limited = before;
    limited.rlim_cur = pages * 4096 + kRoom;
    ASSERT_EQ(setrlimit(RLIMIT_AS, &limited), 0);
    const std::uint64_t free = free_memory();
    setrlimit(RLIMIT_AS, &before);
    EXPECT_LE(free, kRoom);
}

}  // namespace
}  // namespace sunfleck

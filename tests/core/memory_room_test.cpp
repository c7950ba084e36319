// What a machine and its control groups leave, as their files say.
#include "core/memory_room.h"

#include "image/temporary_folder.h"

#include <sys/resource.h>

#include <fstream>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMebibyte = 1 << 20;

class MemoryRooms : public testing_support::TemporaryFolder {
protected:
    void put(const std::string& name, const std::string& text) const {
        fs::create_directories(fs::path(path(name)).parent_path());
        std::ofstream(path(name)) << text;
    }
    /// Beside what this process has already: of a size that changes little while a test runs.
    std::uint64_t free_mebibytes() const {
        return (memory_room(path("")).bytes - memory_in_use() + kMebibyte / 2) / kMebibyte;
    }
};

TEST_F(MemoryRooms, are_what_the_machine_has_free) {
    put("proc/meminfo", "MemTotal: 99999999 kB\nMemAvailable: 2048000 kB\n");
    EXPECT_EQ(free_mebibytes(), 2000U);
    EXPECT_EQ(memory_room(path("")).limit, "the machine's free memory");
}

TEST_F(MemoryRooms, are_bound_by_control_groups_of_version_2_and_those_around_them) {
    put("proc/meminfo", "MemAvailable: 8388608 kB\n");
    put("proc/self/cgroup", "0::/outer/inner\n");
    put("sys/fs/cgroup/outer/inner/memory.max", "max\n");
    put("sys/fs/cgroup/outer/memory.max", "1073741824\n");
    put("sys/fs/cgroup/outer/memory.current", "943718400\n");
    put("sys/fs/cgroup/outer/memory.stat", "anon 1\ninactive_file 419430400\n");
    EXPECT_EQ(free_mebibytes(), 524U) << "files that are kept in memory are given back";
    EXPECT_EQ(memory_room(path("")).limit, "the limit of the control group");
}

TEST_F(MemoryRooms, are_bound_by_control_groups_of_version_1) {
    put("proc/self/cgroup", "5:devices:/\n4:memory:/job\n0::/\n");
    put("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "536870912\n");
    put("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "536870912\n");
    put("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
    EXPECT_EQ(free_mebibytes(), 0U);
}

/// In a container the group's path is that outside of it, and its files are at the top.
TEST_F(MemoryRooms, are_bound_by_the_group_of_a_container) {
    put("proc/self/cgroup", "0::/docker/0123\n");
    put("sys/fs/cgroup/memory.max", "104857600\n");
    EXPECT_EQ(free_mebibytes(), 100U);
}

TEST_F(MemoryRooms, are_told_in_units) {
    EXPECT_EQ(memory_text(230 * kMebibyte), "230 MiB");
    EXPECT_EQ(memory_text(1536 * kMebibyte), "1.5 GiB");
}

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
}  // namespace sunfleck::engine

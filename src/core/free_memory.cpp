// Free memory by way of /proc and /sys/fs/cgroup (Linux).
#include "core/free_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace sunfleck {
namespace {

constexpr std::uint64_t kUnknown = std::numeric_limits<std::uint64_t>::max();

std::uint64_t available_on_machine() {
    std::ifstream file("/proc/meminfo");
    std::string word;
    std::uint64_t kilobytes = 0;
    while (file >> word)
        if (word == "MemAvailable:" && file >> kilobytes) return kilobytes * 1024;
    return kUnknown;
}

std::optional<std::uint64_t> number_in(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::uint64_t value = 0;
    if (file >> value) return value;
    return std::nullopt;  // no such file, or "max": no limit
}

std::uint64_t left_of(std::uint64_t limit, std::uint64_t used) {
    return limit > used ? limit - used : 0;
}

/// The least that this control group and those above it leave (version 2).
std::uint64_t left_by_groups() {
    namespace fs = std::filesystem;
    const fs::path root = "/sys/fs/cgroup";
    std::ifstream file("/proc/self/cgroup");
    std::uint64_t least = kUnknown;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("0::/")) continue;
        for (fs::path group = root / line.substr(4);; group = group.parent_path()) {
            const auto limit = number_in(group / "memory.max");
            const auto used = number_in(group / "memory.current");
            if (limit && used) least = std::min(least, left_of(*limit, *used));
            if (group == root || group == group.root_path()) break;
        }
    }
    return least;
}

std::uint64_t left_of_address_space() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnknown;
    const std::uint64_t pages = number_in("/proc/self/statm").value_or(0);
    return left_of(limit.rlim_cur, pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)));
}

}  // namespace

std::uint64_t free_memory() {
    return std::min({available_on_machine(), left_by_groups(), left_of_address_space()});
}

}  // namespace sunfleck

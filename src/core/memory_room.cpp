// Files of /proc and /sys, and getrlimit().
#include "core/memory_room.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

/// The number after a word of a file; nothing where the file has no such word.
std::optional<std::uint64_t> number_after(const fs::path& path, const std::string& word) {
    std::ifstream file(path);
    for (std::string found; file >> found;) {
        std::uint64_t number = 0;
        if (found == word && file >> number) return number;
    }
    return {};
}

/// A file that holds one number, or a word for "no limit".
std::optional<std::uint64_t> number_in(const fs::path& path) {
    std::ifstream file(path);
    std::uint64_t number = 0;
    if (file >> number) return number;
    return {};
}

/// The files of one version of control groups.
struct GroupFiles {
    const char* controller;  // of the line in /proc/self/cgroup
    const char* mount;
    const char* limit;
    const char* usage;
    const char* cache;  // in memory.stat: what is given back when asked for
};

constexpr std::array kGroupFiles = {
    GroupFiles{"", "sys/fs/cgroup", "memory.max", "memory.current", "inactive_file"},
    GroupFiles{"memory", "sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory.usage_in_bytes",
               "total_inactive_file"},
};

/// Bytes that a group leaves beside what it uses; nothing if it sets no limit.
std::optional<std::uint64_t> left_in(const fs::path& group, const GroupFiles& files) {
    const auto limit = number_in(group / files.limit);
    if (!limit) return {};
    const std::uint64_t usage = number_in(group / files.usage).value_or(0);
    const std::uint64_t cache = number_after(group / "memory.stat", files.cache).value_or(0);
    const std::uint64_t held = usage - std::min(usage, cache);
    return *limit - std::min(*limit, held);
}

/// The group of this process, as /proc/self/cgroup has it: "4:memory:/a/b", "0::/a/b".
std::optional<fs::path> group_of(const fs::path& root, const std::string& controller) {
    std::ifstream file(root / "proc/self/cgroup");
    for (std::string line; std::getline(file, line);) {
        std::istringstream parts(line);
        std::string number;
        std::string controllers;
        std::string path;
        std::getline(parts, number, ':');
        std::getline(parts, controllers, ':');
        std::getline(parts, path);
        if (controllers == controller && !path.empty()) return path.substr(1);
    }
    return {};
}

/// What all groups around this process leave.
std::uint64_t left_by_strata(const fs::path& root) {
    std::uint64_t left = kNoLimit;
    for (const GroupFiles& files : kGroupFiles) {
        auto group = group_of(root, files.controller);
        if (!group) continue;
        for (;; group = group->parent_path()) {
            left = std::min(left, left_in(root / files.mount / *group, files).value_or(kNoLimit));
            if (group->empty()) break;
        }
    }
    return left;
}

std::uint64_t sum(std::uint64_t a, std::uint64_t b) {
    return a > kNoLimit - b ? kNoLimit : a + b;
}

/// Numbers of /proc/self/statm: address space, memory.
std::array<std::uint64_t, 2> own_sizes() {
    std::ifstream file("/proc/self/statm");
    std::array<std::uint64_t, 2> pages{};
    file >> pages[0] >> pages[1];
    const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    return {pages[0] * page, pages[1] * page};
}

}  // namespace

std::uint64_t memory_in_use() {
    return own_sizes()[1];
}

std::uint64_t most_memory_in_use() {
    return number_after("/proc/self/status", "VmHWM:").value_or(0) * 1024;
}

MemoryRoom memory_room(const std::string& root) {
    const fs::path top = root.empty() ? "/" : root;
    const auto [space, memory] = own_sizes();
    MemoryRoom room{kNoLimit, "no limit"};
    const auto bound = [&room](std::uint64_t bytes, const char* limit) {
        if (bytes < room.bytes) room = {bytes, limit};
    };
    if (const auto kibibytes = number_after(top / "proc/meminfo", "MemAvailable:"))
        bound(sum(*kibibytes * 1024, memory), "the machine's free memory");
    bound(sum(left_by_strata(top), memory), "the limit of the control group");
    rlimit address{};
    if (::getrlimit(RLIMIT_AS, &address) == 0 && address.rlim_cur != RLIM_INFINITY) {
        const std::uint64_t beside = space - std::min(space, memory);
        bound(address.rlim_cur - std::min<std::uint64_t>(address.rlim_cur, beside),
              "the limit of address space (ulimit -v)");
    }
    return room;
}

std::uint64_t free_memory() {
    const std::uint64_t room = memory_room().bytes;
    return room - std::min(room, memory_in_use());
}

std::string memory_text(std::uint64_t bytes) {
    const double mebibytes = static_cast<double>(bytes) / (1 << 20);
    std::array<char, 32> text{};
    if (mebibytes >= 1024)
        std::snprintf(text.data(), text.size(), "%.1f GiB", mebibytes / 1024);
    else
        std::snprintf(text.data(), text.size(), "%.0f MiB", mebibytes);
    return text.data();
}

}  // namespace sunfleck::engine

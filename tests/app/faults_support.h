// Commands of which one call to the system fails (tests/faults/faults.cpp): each call in its turn.
#pragma once

#include "app/program.h"
#include "render/checkpoint.h"

#include <cerrno>
#include <iterator>
#include <map>
#include <set>

namespace sunfleck::engine::testing_support {

/// A kind of call, and how it fails.
struct FaultKind {
    const char* name;
    int code;
};

inline constexpr std::array<FaultKind, 9> kFaultKinds = {{{"open", EMFILE},
                                                          {"read", EIO},
                                                          {"write", ENOSPC},
                                                          {"fsync", EIO},
                                                          {"rename", EIO},
                                                          {"close", EIO},
                                                          {"mmap", ENOMEM},
                                                          {"malloc", ENOMEM},
                                                          {"thread", EAGAIN}}};

class FaultTest : public ProgramTest {
protected:
    void SetUp() override {
        ProgramTest::SetUp();
        const Words two{"render", "room.pbrt",  "--quiet", "--photons-per-pass",
                        "500",    "--nthreads", "2"};
        ASSERT_EQ(run(two + Words{"--pass-range", "0:1", "-o", "a.film", "-o", "a.exr"}).code, 0);
        ASSERT_EQ(run(two + Words{"--pass-range", "1:2", "-o", "b.film", "-o", "b.exr"}).code, 0);
        ASSERT_EQ(
            run(two + Words{"--passes", "1", "--checkpoint", "half.ckpt", "-o", "b.exr"}).code, 0);
        commands_ = {
            {"render", two + Words{"--passes", "2", "-o", "x.exr", "-o", "x.png", "-o", "x.film",
                                   "--stats", "x.json"}},
            {"checkpoint", two + Words{"--passes", "2", "--checkpoint", "x.ckpt", "--every",
                                       "0.000001", "-o", "x.exr"}},
            {"resume", two + Words{"--passes", "2", "--resume", "half.ckpt", "--checkpoint",
                                   "y.ckpt", "-o", "x.exr"}},
            {"merge", {"merge", "a.film", "b.film", "-o", "x.exr", "-o", "x.png", "-o", "x.film"}},
            {"compare", {"compare", "a.exr", "b.exr", "--report", "x.html", "--json", "x.json"}}};
    }

    /// Lets calls of each command and kind fail, one in a run. @param at_most  calls of a command
    /// and kind that are tried, evenly spread over all.
    void expect_survives(long at_most) {
        for (const auto& [name, words] : commands_) {
            const std::string before = names();
            ASSERT_EQ(run_with(words, "none:0").code, 0);
            learn_whole(before);
            for (const FaultKind& kind : kFaultKinds) {
                const long calls = count_calls(words, kind);
                const long tried = std::min(calls, at_most);
                std::map<int, long> codes;
                for (long i = 0; i < tried; ++i)
                    ++codes[expect_survives(name, words, kind, 1 + i * calls / tried)];
                std::printf("%-10s %-6s %5ld calls, %5ld tried:", name.c_str(), kind.name, calls,
                            tried);
                for (const auto& [code, count] : codes) std::printf("  exit %d: %ld", code, count);
                std::printf("\n");
            }
            clear();
            ASSERT_EQ(names(), before);
        }
    }

private:
    static constexpr const char* kEarlier = "what was there before";

    Ran run_with(const Words& words, const std::string& fault) const {
        const Words start{"120",
                          "/usr/bin/env",
                          std::string("LD_PRELOAD=") + SUNFLECK_FAULTS,
                          "SUNFLECK_FAULT=" + fault,
                          "SUNFLECK_FAULT_COUNT=" + path("count"),
                          SUNFLECK_PROGRAM};
        return Process(path(""), start + words, "/usr/bin/timeout").wait();
    }

    long count_calls(const Words& words, const FaultKind& kind) {
        clear();
        EXPECT_EQ(run_with(words, std::string(kind.name) + ":0").code, 0);
        const long calls = std::stol(read_text(path("count")));
        std::filesystem::remove(path("count"));
        return calls;
    }

    /// @return the exit code.
    int expect_survives(const std::string& name, const Words& words, const FaultKind& kind,
                        long call) {
        clear();
        for (const auto& [file, bytes] : whole_)
            if (!file.ends_with(".ckpt")) write_text(path(file), kEarlier);
        const std::string place = name + ", " + kind.name + " " + std::to_string(call);
        const std::string fault =
            std::string(kind.name) + ":" + std::to_string(call) + ":" + std::to_string(kind.code);
        const Ran ran = run_with(words, fault);
        std::filesystem::remove(path("count"));
        EXPECT_TRUE(ran.code >= 0 && ran.code <= 2) << place << ": " << ran.code << ran.err;
        const auto lines = std::count(ran.err.begin(), ran.err.end(), '\n');
        EXPECT_EQ(lines, ran.code == 0 ? 0 : 1) << place << ": " << ran.err;
        for (const auto& entry : std::filesystem::directory_iterator(path(""))) {
            const std::string file = entry.path().filename();
            const auto known = whole_.find(file);
            if (known == whole_.end()) {
                EXPECT_TRUE(inputs_.contains(file)) << place << " leaves " << file;
                continue;
            }
            const std::string bytes = read_text(path(file));
            if (ran.code == 0 && file.ends_with(".ckpt")) {
                EXPECT_EQ(bytes.size(), whole_.at(file).size()) << place << ": " << file;
            }
            EXPECT_TRUE(is_whole(file, bytes) || (ran.code != 0 && bytes == kEarlier))
                << place << ": " << file;
        }
        return ran.code;
    }

    bool is_checkpoint(const std::string& file) const {
        try {
            return read_checkpoint(path(file)).state.film.pass_count() > 0;
        } catch (const std::runtime_error&) {
            return false;
        }
    }

    /// Times are in statistics and checkpoints, which are whole if they can be read.
    bool is_whole(const std::string& file, const std::string& bytes) const {
        if (file.ends_with(".ckpt")) return is_checkpoint(file);
        if (file.ends_with(".json")) return nlohmann::json::accept(bytes);
        return bytes == whole_.at(file);
    }

    /// What the command that has just run has written. @param inputs  names that were there before.
    void learn_whole(const std::string& inputs) {
        std::istringstream before(inputs);
        inputs_ = {std::istream_iterator<std::string>(before), {}};
        inputs_.insert("room.pbrt");
        std::filesystem::remove(path("count"));
        whole_.clear();
        std::istringstream now(names());
        for (std::string name; now >> name;)
            if (!inputs_.contains(name)) whole_[name] = read_text(path(name));
    }

    void clear() const {
        for (const auto& [file, bytes] : whole_) std::filesystem::remove(path(file));
    }

    std::vector<std::pair<std::string, Words>> commands_;
    std::set<std::string> inputs_;
    std::map<std::string, std::string> whole_;  // outputs by their names
};

}  // namespace sunfleck::engine::testing_support

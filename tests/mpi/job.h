// The built program under mpirun, on this machine, whatever number of cores it has.
#pragma once

#include "app/program.h"

namespace sunfleck::engine::testing_support {

class JobTest : public ProgramTest {
protected:
    /// What mpirun is called with. @param ranks  how many.
    static Words job_words(int ranks, const Words& words) {
        return Words{"--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-n",
                     std::to_string(ranks), SUNFLECK_PROGRAM} +
               words;
    }

    Process start(int ranks, const Words& words) const {
        return {path(""), job_words(ranks, words), SUNFLECK_MPIRUN};
    }

    Ran run_job(int ranks, const Words& words) const { return start(ranks, words).wait(); }

    /// room.pbrt by few photons.
    static Words small(const Words& words) {
        return Words{"render", "room.pbrt", "--quiet", "--photons-per-pass", "500"} + words;
    }

    /// Lines of ours among those that mpirun says.
    static int count(const std::string& text, const std::string& line) {
        int found = 0;
        for (std::size_t at = text.find(line); at != std::string::npos;
             at = text.find(line, at + line.size()))
            ++found;
        return found;
    }

    bool same(const std::string& a, const std::string& b) const {
        const std::string bytes = read_text(path(a));
        return !bytes.empty() && bytes == read_text(path(b));
    }

    /// Counts of two statistics files agree; times and machines need not.
    void expect_same_counts(const std::string& a, const std::string& b) const {
        auto one = json(a);
        auto other = json(b);
        for (const char* name : {"seconds", "cpu_seconds", "command", "threads", "ranks"}) {
            one.erase(name);
            other.erase(name);
        }
        EXPECT_EQ(one, other);
    }
};

}  // namespace sunfleck::engine::testing_support

// This process as one of a job of ranks: job_alone.cpp, or with -DSUNFLECK_MPI=ON job_mpi.cpp.
#pragma once

#include "ranks/ranks.h"

namespace sunfleck::engine {

/// While it lives, the process belongs to the job; its end waits for all others. One a process.
class Job {
public:
    /// @param shared  what is done can be shared; if not, this rank is alone whatever the others
    /// do.
    explicit Job(bool shared);
    ~Job();
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;
    Job(Job&&) = delete;
    Job& operator=(Job&&) = delete;

    const Ranks& ranks() const { return ranks_; }

    /// After a fault that other ranks do not know of: ends them all with this exit code, where
    /// there are others.
    void abort(int code) const;

private:
    Ranks ranks_;
};

}  // namespace sunfleck::engine

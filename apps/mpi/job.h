// Job: this process as one of several ranks, by job_alone.cpp or, with -DSUNFLECK_MPI=ON,
// job_mpi.cpp.
#pragma once

#include "ranks/ranks.h"

namespace sunfleck::engine {

/// The process belongs to the job while this lives; its end waits for all others. One per process.
class Job {
public:
    /// @param shared  whether the work can be shared; if not, this rank is alone.
    explicit Job(bool shared);
    ~Job();
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;
    Job(Job&&) = delete;
    Job& operator=(Job&&) = delete;

    const Ranks& ranks() const { return ranks_; }

    /// Ends all ranks with this exit code, after a fault that the others do not know of.
    void abort(int code) const;

private:
    Ranks ranks_;
};

}  // namespace sunfleck::engine

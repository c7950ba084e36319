// Without MPI there is one rank.
#include "apps/mpi/job.h"

namespace sunfleck::engine {

Job::Job(bool) {}

Job::~Job() = default;

void Job::abort(int) const {}

}  // namespace sunfleck::engine

// Memory that a pass gives back stays with the program, for the next pass.
//
// A pass fills some hundred megabytes and gives them back. If they go back to the system, they come
// again page by page, each of them cleared and entered anew: a third of a render's time
// (docs/develop/decisions.md).
#pragma once

#include <cstdlib>  // says which C library this is

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace sunfleck::engine {

/// From now on no memory goes back to the system before the program ends. To be called at its
/// start; does nothing where the C library is not glibc.
inline void keep_freed_memory() {
#if defined(__GLIBC__)
    // NOLINTBEGIN(concurrency-mt-unsafe): no other thread runs yet
    mallopt(M_MMAP_MAX, 0);         // large pieces come from where small ones do, and stay there
    mallopt(M_TRIM_THRESHOLD, -1);  // never
    // NOLINTEND(concurrency-mt-unsafe)
#endif
}

}  // namespace sunfleck::engine

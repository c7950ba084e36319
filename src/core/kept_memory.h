// Keeps freed memory in the process, for the next pass.
//
// A pass allocates some hundred megabytes and frees them. Memory that returns to the system comes
// back page by page, each cleared and mapped anew: a third of the time of a render
// (docs/develop/decisions.md).
#pragma once

#include <cstdlib>  // says which C library this is

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace sunfleck::engine {

/// Returns no memory to the system from now on until the program ends. It is called when the
/// program starts. Without glibc it does nothing.
inline void keep_freed_memory() {
#if defined(__GLIBC__)
    // NOLINTBEGIN(concurrency-mt-unsafe): no other thread runs yet
    mallopt(M_MMAP_MAX, 0);  // large blocks come from the same heap as small ones, and stay there
    mallopt(M_TRIM_THRESHOLD, -1);  // never
    // NOLINTEND(concurrency-mt-unsafe)
#endif
}

}  // namespace sunfleck::engine

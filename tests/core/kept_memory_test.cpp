// Memory that was given back comes again as it is: no page of it is entered anew.
#include "core/kept_memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <vector>

namespace sunfleck::engine {
namespace {

long pages_entered() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
}

/// Fills 64 MiB and gives them back. @return pages that were entered for it.
long fill() {
    const long before = pages_entered();
    const std::vector<char> bytes(std::size_t{64} << 20U, 1);
    const char* volatile shown = bytes.data();  // else clang leaves the memory out
    EXPECT_EQ(shown[bytes.size() - 1], 1);
    return pages_entered() - before;
}

TEST(KeptMemory, comes_again_without_the_system) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "the sanitizer has an allocator of its own";
#endif
    keep_freed_memory();
    const long first = fill();
    const long again = fill();
    EXPECT_GT(first, 16) << "the measure sees none: pages of 2 MiB are the largest";
    EXPECT_LT(again, first / 8);
}

}  // namespace
}  // namespace sunfleck::engine

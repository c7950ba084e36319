// Large arrays that are read here and there: on large pages, where the system offers them.
//
// A processor remembers where some thousand pages lie; of 4 KiB each, these are few megabytes.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace sunfleck::engine {

/// An allocator that asks for large pages for all that fills one. Nothing else differs.
template <class T>
struct HugePages {
    using value_type = T;  // NOLINT(readability-identifier-naming): the name containers ask for
    static constexpr std::size_t kPage = std::size_t{1} << 21U;

    HugePages() = default;
    template <class U>
    HugePages(const HugePages<U>&) {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (bytes < kPage)
            return static_cast<T*>(::operator new(bytes, std::align_val_t(alignof(T))));
        void* memory = ::operator new(whole_pages(bytes), std::align_val_t(kPage));
#if defined(__linux__)
        madvise(memory, whole_pages(bytes), MADV_HUGEPAGE);  // if refused, pages are small
#endif
        return static_cast<T*>(memory);
    }

    void deallocate(T* memory, std::size_t count) {
        const bool large = count * sizeof(T) >= kPage;
        ::operator delete(memory, std::align_val_t(large ? kPage : alignof(T)));
    }

    friend bool operator==(const HugePages&, const HugePages&) {
        return true;
    }

private:
    static std::size_t whole_pages(std::size_t bytes) {
        return (bytes + kPage - 1) & ~(kPage - 1);
    }
};

template <class T>
using HugeVector = std::vector<T, HugePages<T>>;

}  // namespace sunfleck::engine

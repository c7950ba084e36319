// A library to preload: the n-th call of a kind fails in the program that it is loaded into.
//
// SUNFLECK_FAULT=KIND:N[:ERRNO]   KIND is open, read, write, fsync, rename, close, mmap, malloc or
// thread. The N-th call of that kind, and none other, fails; N of 0: none does. Calls count from
// the time when all libraries are loaded. At exit their number is written to the file that
// SUNFLECK_FAULT_COUNT names.
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

/// Small pieces are asked for everywhere, and those of libraries at their start.
constexpr std::size_t kLargeMalloc = 1 << 14;

struct Plan {
    std::array<char, 16> kind{};
    long number = 0;
    int code = EIO;
    std::atomic<long> calls{0};
    bool ready = false;
};
Plan plan;  // NOLINT

/// Counts a call of this kind. True if it is the one that fails, and errno is set.
bool fails(const char* kind) {
    if (!plan.ready || std::strcmp(kind, plan.kind.data()) != 0) return false;
    if (++plan.calls != plan.number) return false;
    errno = plan.code;
    return true;
}

template <class Function>
Function real(const char* name, Function /*like*/) {
    void* const found = dlsym(RTLD_NEXT, name);
    Function function = nullptr;
    std::memcpy(&function, &found, sizeof function);
    return function;
}

__attribute__((constructor)) void begin() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): before main() there is one thread
    const char* const text = std::getenv("SUNFLECK_FAULT");
    if (text == nullptr) return;
    std::sscanf(text, "%15[a-z]:%ld:%d", plan.kind.data(), &plan.number, &plan.code);
    plan.ready = true;
}

__attribute__((destructor)) void end() {
    plan.ready = false;
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing sets the environment of the program
    const char* const path = std::getenv("SUNFLECK_FAULT_COUNT");
    if (path == nullptr) return;
    if (std::FILE* const file = std::fopen(path, "w")) {
        std::fprintf(file, "%ld\n", plan.calls.load());
        std::fclose(file);
    }
}

}  // namespace

// Parameters have the names that glibc's headers give them, less the underscores.
extern "C" {

// NOLINTBEGIN(bugprone-macro-parentheses): types cannot stand in parentheses
#define FAIL_AS(kind, name, parameters, arguments, type, failed)  \
    __attribute__((visibility("default"))) type name parameters { \
        static type(*const next) parameters = real(#name, &name); \
        return fails(kind) ? failed : next arguments;             \
    }
// NOLINTEND(bugprone-macro-parentheses)

__attribute__((visibility("default"))) int open(const char* file, int flag, ...) {
    static int (*const next)(const char*, int, ...) = real("open", &open);
    va_list rest;
    va_start(rest, flag);
    const mode_t mode = (flag & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return fails("open") ? -1 : next(file, flag, mode);
}
__attribute__((visibility("default"))) int open64(const char* file, int flag, ...) {
    static int (*const next)(const char*, int, ...) = real("open64", &open64);
    va_list rest;
    va_start(rest, flag);
    const mode_t mode = (flag & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return fails("open") ? -1 : next(file, flag, mode);
}
FAIL_AS("open", fopen, (const char* filename, const char* modes), (filename, modes), FILE*, nullptr)
FAIL_AS("open", fopen64, (const char* filename, const char* modes), (filename, modes), FILE*,
        nullptr)
FAIL_AS("read", read, (int fd, void* buf, size_t nbytes), (fd, buf, nbytes), ssize_t, -1)
FAIL_AS("fsync", fsync, (int fd), (fd), int, -1)
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming): "new" is a keyword
FAIL_AS("rename", rename, (const char* old, const char* _new), (old, _new), int, -1)
FAIL_AS("mmap", mmap, (void* addr, size_t len, int prot, int flags, int fd, off_t offset),
        (addr, len, prot, flags, fd, offset), void*, MAP_FAILED)
FAIL_AS("mmap", mmap64, (void* addr, size_t len, int prot, int flags, int fd, off_t offset),
        (addr, len, prot, flags, fd, offset), void*, MAP_FAILED)

__attribute__((visibility("default"))) ssize_t write(int fd, const void* buf, size_t n) {
    static ssize_t (*const next)(int, const void*, size_t) = real("write", &write);
    const bool is_message = fd == STDOUT_FILENO || fd == STDERR_FILENO;
    return !is_message && fails("write") ? -1 : next(fd, buf, n);
}

__attribute__((visibility("default"))) int close(int fd) {
    static int (*const next)(int) = real("close", &close);
    const bool failed = fails("close");
    const int result = next(fd);  // the system closes it all the same
    if (!failed) return result;
    errno = plan.code;
    return -1;
}

__attribute__((visibility("default"))) int pthread_create(pthread_t* thread,
                                                          const pthread_attr_t* attr,
                                                          void* (*routine)(void*), void* arg) {
    static auto* const next = real("pthread_create", &pthread_create);
    return fails("thread") ? EAGAIN : next(thread, attr, routine, arg);
}

// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): names of glibc
extern void* __libc_malloc(size_t size);
extern void* __libc_memalign(size_t alignment, size_t size);
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

__attribute__((visibility("default"))) void* malloc(size_t size) {
    return size >= kLargeMalloc && fails("malloc") ? nullptr : __libc_malloc(size);
}
__attribute__((visibility("default"))) void* aligned_alloc(size_t alignment, size_t size) {
    return size >= kLargeMalloc && fails("malloc") ? nullptr : __libc_memalign(alignment, size);
}
__attribute__((visibility("default"))) int posix_memalign(void** memptr, size_t alignment,
                                                          size_t size) {
    if (size >= kLargeMalloc && fails("malloc")) return ENOMEM;
    *memptr = __libc_memalign(alignment, size);
    return *memptr == nullptr ? ENOMEM : 0;
}
}

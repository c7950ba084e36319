// Replaces `new` and `delete` of the whole program: the library's own say nothing of the size.
#include "apps/cli/out_of_memory.h"

#include <cstdio>
#include <cstdlib>
#include <new>

namespace sunfleck::engine {

OutOfMemory::OutOfMemory(std::size_t bytes) noexcept {
    constexpr double kMebibyte = 1 << 20;
    std::snprintf(text_.data(), text_.size(),
                  "not enough memory: %.1f MiB more were asked for; free some, or render fewer "
                  "pixels (--resolution, --crop) or photons (--photons-per-pass)",
                  static_cast<double>(bytes) / kMebibyte);
}

}  // namespace sunfleck::engine

// NOLINTBEGIN(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory): these are `new` itself
void* operator new(std::size_t bytes, const std::nothrow_t& /*unused*/) noexcept {
    return std::malloc(bytes == 0 ? 1 : bytes);
}

void* operator new(std::size_t bytes, std::align_val_t alignment,
                   const std::nothrow_t& /*unused*/) noexcept {
    const auto step = static_cast<std::size_t>(alignment);
    const std::size_t whole = (bytes + step - 1) / step * step;
    return std::aligned_alloc(step, whole == 0 ? step : whole);
}

void* operator new(std::size_t bytes) {
    if (void* memory = operator new(bytes, std::nothrow)) return memory;
    throw sunfleck::engine::OutOfMemory(bytes);
}

void* operator new(std::size_t bytes, std::align_val_t alignment) {
    if (void* memory = operator new(bytes, alignment, std::nothrow)) return memory;
    throw sunfleck::engine::OutOfMemory(bytes);
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t /*bytes*/) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept {
    std::free(memory);
}
// NOLINTEND(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory)

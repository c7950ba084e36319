// Asks the processor by the compiler's built-in.
#include "core/processor.h"

namespace sunfleck::engine {

bool cpu_has_avx2() {
    const bool vectors = static_cast<bool>(__builtin_cpu_supports("avx2"));
    const bool fused = static_cast<bool>(__builtin_cpu_supports("fma"));
    const bool bits = static_cast<bool>(__builtin_cpu_supports("bmi"));
    const bool more_bits = static_cast<bool>(__builtin_cpu_supports("bmi2"));
    return vectors && fused && bits && more_bits;
}

}  // namespace sunfleck::engine

// Detection of the processor's instruction sets.
#pragma once

namespace sunfleck::engine {

/// Returns whether the processor has what Embree's AVX2 kernels need. Without AVX2 Embree uses
/// other kernels, and bytes may differ from those of other machines.
bool cpu_has_avx2();

}  // namespace sunfleck::engine

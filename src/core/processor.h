// The instruction sets that the processor has.
#pragma once

namespace sunfleck::engine {

/// True if the processor has what Embree's AVX2 kernels need. Without it bytes may differ from
/// other machines', for Embree then picks other kernels.
bool cpu_has_avx2();

}  // namespace sunfleck::engine

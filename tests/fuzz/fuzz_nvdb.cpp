// Fuzz target: any bytes as a NanoVDB file end in a density or in an Error of
// one line. A density has finite amounts, which do not depend on the direction.
#include "import/nvdb/density.h"
#include "sunfleck/error.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this
// name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using sunfleck::engine::Vec3;
    try {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as
        // characters
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const auto density =
            sunfleck::engine::nvdb_density(bytes, "density", sunfleck::engine::Matrix(), "a.nvdb");
        for (const Vec3& along : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.48F, 0.6F, 0.64F)}) {
            const float amount = density.amount({Vec3(1, 2, 3) - along * 4, along});
            if (!(amount >= 0)) std::abort();
            if (!(density.distance_at({Vec3(1, 2, 3), along, 10}, amount / 2) <= 10)) std::abort();
        }
    } catch (const sunfleck::Error& error) {
        if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
    return 0;
}

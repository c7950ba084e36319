// Fuzz target: any bytes as a measured material end in its summary or in an Error of one
// line, within bounds.
#include "import/pbrt/measured.h"

#include <cstdint>
#include <cstdlib>
#include <string>

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
        const std::string bytes(reinterpret_cast<const char*>(data), size);
        const auto summary = sunfleck::engine::summary_of_measured(bytes, {"fuzz.bsdf"});
        const float albedo = summary.albedo(550);
        if (!(albedo >= 0 && albedo <= 1 && summary.alpha >= 0)) std::abort();
    } catch (const sunfleck::Error& error) {
        if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
    return 0;
}

// Fuzz target: any bytes as a scene file end in a scene or in an Error, without touching the disk.
#include "fuzz/checked_scene.h"
#include "import/pbrt/reader.h"
#include "support/no_access.h"

#include <cstdint>
#include <cstdlib>
#include <string>

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
        const std::string text(reinterpret_cast<const char*>(data), size);
        check_scene(sunfleck::engine::read_pbrt_text(
            text, "fuzz.pbrt", sunfleck::engine::testing_support::no_access()));
    } catch (const sunfleck::Error& error) {
        if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
    return 0;
}

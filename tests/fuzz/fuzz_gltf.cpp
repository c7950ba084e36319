// Fuzz target: any bytes as a glTF file end in a scene or in an Error, without touching the disk.
#include "fuzz/checked_scene.h"
#include "import/gltf/reader.h"

#include <cstdint>
#include <cstdlib>
#include <string>

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto no_files = [](const std::string&,
                             const sunfleck::SourceLocation& from) -> std::string {
        throw sunfleck::Error(from, "is not read here", "leave it out");
    };
    try {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
        const std::string bytes(reinterpret_cast<const char*>(data), size);
        sunfleck::engine::GltfDocument document("fuzz.gltf", bytes, no_files);
        check_scene(sunfleck::engine::read_gltf_document(document));
    } catch (const sunfleck::Error& error) {
        if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
    return 0;
}

// Fuzz target: any bytes as a scene file end in a scene or in an Error, without touching the disk.
#include "import/pbrt/reader.h"
#include "support/no_access.h"

#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

/// What later stages take for granted.
void check(const sunfleck::engine::SceneDescription& scene) {
    const auto check_shape = [&](const sunfleck::engine::ShapeDescription& shape) {
        if (shape.material >= scene.materials.size()) std::abort();
        const auto* mesh = std::get_if<sunfleck::engine::TriangleMesh>(&shape.placed.shape);
        if (!mesh) return;
        for (const auto& triangle : mesh->triangles)
            for (const std::uint32_t corner : triangle)
                if (corner >= mesh->positions.size()) std::abort();
    };
    for (const auto& shape : scene.shapes) check_shape(shape);
    for (const auto& object : scene.objects)
        for (const auto& shape : object) check_shape(shape);
    for (const auto& instance : scene.instances)
        if (instance.object >= scene.objects.size()) std::abort();
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
        const std::string text(reinterpret_cast<const char*>(data), size);
        check(sunfleck::engine::read_pbrt_text(text, "fuzz.pbrt",
                                               sunfleck::engine::testing_support::no_access()));
    } catch (const sunfleck::Error& error) {
        if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
    return 0;
}

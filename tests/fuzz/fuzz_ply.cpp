// Fuzz target: any bytes as a PLY file end in a mesh or in an Error of one line,
// within bounds.
#include "import/ply/reader.h"
#include "sunfleck/error.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const sunfleck::engine::PlyMesh mesh = sunfleck::engine::parse_ply(bytes, "fuzz.ply");
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t corner : triangle)
                if (corner >= mesh.positions.size()) std::abort();
        for (const sunfleck::engine::Vec3d& exact : mesh.positions) {
            const sunfleck::engine::Vec3 p(exact);
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) std::abort();
        }
        if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size()) std::abort();
        if (!mesh.uvs.empty() && mesh.uvs.size() != mesh.positions.size()) std::abort();
        for (const sunfleck::engine::Vec2& uv : mesh.uvs)
            if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) std::abort();
    } catch (const sunfleck::Error& error) {
        if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
    return 0;
}

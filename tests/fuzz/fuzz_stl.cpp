// Fuzz target: any bytes as an STL file end in a mesh within bounds or in an Error of one line; its
// sides are found.
#include "geometry/closed_surface.h"
#include "import/stl/reader.h"
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
        const sunfleck::engine::StlMesh mesh = sunfleck::engine::parse_stl(bytes, "fuzz.stl");
        if (mesh.triangles.empty()) std::abort();
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t corner : triangle)
                if (corner >= mesh.positions.size()) std::abort();
        for (const sunfleck::engine::Vec3& p : mesh.positions)
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) std::abort();
        const auto sides = sunfleck::engine::sides_of(mesh.positions, mesh.triangles);
        if (sides.is_closed.size() != mesh.triangles.size()) std::abort();
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            if (sides.is_reversed[t] && !sides.is_closed[t]) std::abort();
    } catch (const sunfleck::Error& error) {
        if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
    return 0;
}

// Fuzz target: any bytes as an OBJ file, or as a library of materials, end in a mesh within bounds,
// in materials, or in an Error of one line.
#include "import/obj/mtl.h"
#include "import/obj/reader.h"
#include "sunfleck/error.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

using sunfleck::engine::kNoIndex;

void require(bool is_so) {
    if (!is_so) std::abort();
}

void check(const sunfleck::engine::ObjMesh& mesh) {
    require(!mesh.triangles.empty() && !mesh.runs.empty());
    for (const auto& t : mesh.triangles) {
        require(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
        for (const std::uint32_t corner : t) {
            require(corner < mesh.positions.size());
            const sunfleck::engine::Vec3 p(mesh.positions[corner]);
            require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        }
    }
    require(mesh.uv_corners.empty() || mesh.uv_corners.size() == mesh.triangles.size());
    for (const auto& t : mesh.uv_corners)
        for (const std::uint32_t uv : t) require(uv == kNoIndex || uv < mesh.uvs.size());
    require(mesh.normal_corners.empty() || mesh.normal_corners.size() == mesh.triangles.size());
    for (const auto& t : mesh.normal_corners)
        for (const std::uint32_t n : t)
            require(t[0] == kNoIndex ? n == kNoIndex : n < mesh.normals.size());
    std::size_t last = 0;
    for (const auto& run : mesh.runs) {
        require(run.first >= last && run.first < mesh.triangles.size());
        require(run.material == kNoIndex || run.material < mesh.materials.size());
        last = run.first;
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        check(sunfleck::engine::parse_obj(bytes, "fuzz.obj"));
    } catch (const sunfleck::Error& error) {
        require(std::string(error.what()).find('\n') == std::string::npos);
    }
    try {
        sunfleck::engine::parse_mtl(bytes, "fuzz.mtl");
    } catch (const sunfleck::Error& error) {
        require(std::string(error.what()).find('\n') == std::string::npos);
    }
    return 0;
}

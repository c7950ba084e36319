// Unpacking by meshoptimizer: vertices, triangles and indices, and filters of vertices.
#include "import/gltf/meshopt.h"

#ifdef SUNFLECK_MESHOPT
#include <meshoptimizer.h>
#endif

namespace sunfleck::engine {

#ifndef SUNFLECK_MESHOPT

bool has_meshopt() {
    return false;
}

std::string unpack_meshopt(const JsonPlace&, std::string_view) {
    return {};
}

#else

namespace {

[[noreturn]] void refuse_meshopt(const JsonPlace& place, const std::string& what) {
    place.refuse(what, "export the file again, or without EXT_meshopt_compression");
}

using Filter = void (*)(void*, std::size_t, std::size_t);

/// @return  null for none.
Filter filter_of(const JsonPlace& extension, std::size_t stride) {
    const std::string name = extension.text("filter", "NONE");
    if (name == "NONE") return nullptr;
    if (name == "OCTAHEDRAL" && (stride == 4 || stride == 8)) return meshopt_decodeFilterOct;
    if (name == "QUATERNION" && stride == 8) return meshopt_decodeFilterQuat;
    if (name == "EXPONENTIAL") return meshopt_decodeFilterExp;
    refuse_meshopt(extension.at("filter"), "is no filter of such elements");
}

}  // namespace

bool has_meshopt() {
    return true;
}

std::string unpack_meshopt(const JsonPlace& extension, std::string_view packed) {
    const std::uint64_t count = extension.at("count").whole();
    const std::uint64_t stride = extension.at("byteStride").whole();
    const std::string mode = extension.at("mode").text();
    const bool is_vertices = mode == "ATTRIBUTES";
    if (is_vertices ? stride == 0 || stride > 256 || stride % 4 != 0 : stride != 2 && stride != 4)
        refuse_meshopt(extension.at("byteStride"), "is no size of an element");
    // A byte stands for 64 at most.
    constexpr std::uint64_t kMostPerByte = 64;
    if (count > (packed.size() * kMostPerByte + 4096) / stride)
        refuse_meshopt(extension.at("count"), "is more than its bytes can hold");
    std::string bytes(static_cast<std::size_t>(count * stride), '\0');
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): characters as bytes
    const auto* data = reinterpret_cast<const unsigned char*>(packed.data());
    const auto elements = static_cast<std::size_t>(count);
    const auto size = static_cast<std::size_t>(stride);
    int fault = 0;
    if (is_vertices) {
        const Filter filter = filter_of(extension, size);
        fault = meshopt_decodeVertexBuffer(bytes.data(), elements, size, data, packed.size());
        if (fault == 0 && filter != nullptr) filter(bytes.data(), elements, size);
    } else if (mode == "TRIANGLES" && elements % 3 == 0) {
        fault = meshopt_decodeIndexBuffer(bytes.data(), elements, size, data, packed.size());
    } else if (mode == "INDICES") {
        fault = meshopt_decodeIndexSequence(bytes.data(), elements, size, data, packed.size());
    } else {
        refuse_meshopt(extension.at("mode"), "is no mode of so many elements");
    }
    if (fault != 0) refuse_meshopt(extension, "is damaged: meshoptimizer cannot unpack it");
    return bytes;
}

#endif

}  // namespace sunfleck::engine

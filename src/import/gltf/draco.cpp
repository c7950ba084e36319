// Unpacking by libdraco.
#include "import/gltf/draco.h"

#ifdef SUNFLECK_DRACO
#include <draco/compression/decode.h>

#include <cstring>
#include <exception>
#include <memory>
#endif

namespace sunfleck::engine {

#ifndef SUNFLECK_DRACO

bool has_draco() {
    return false;
}

void unpack_draco(const GltfDocument&, Accessors&) {}

#else

namespace {

[[noreturn]] void refuse_draco(const JsonPlace& place, const std::string& what) {
    place.refuse(what, "export the file again, or without Draco");
}

std::unique_ptr<draco::Mesh> unpacked(const GltfDocument& document, const JsonPlace& extension) {
    const std::string_view bytes =
        document.bytes_of(document.element("bufferViews", extension.at("bufferView")));
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    try {
        draco::Decoder decoder;
        auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
        if (mesh.ok()) return std::move(mesh).value();
    } catch (const std::exception&) {  // no memory for what a damaged file claims
    }
    refuse_draco(extension, "is damaged: Draco cannot unpack it");
}

/// Adds the numbers of one element. @tparam Number  as the accessor stores them.
template <class Number>
bool append(const draco::PointAttribute& attribute, draco::AttributeValueIndex value, int count,
            std::string& bytes) {
    std::array<Number, 16> numbers{};
    if (!attribute.ConvertValue<Number>(value, static_cast<std::int8_t>(count), numbers.data()))
        return false;
    const std::size_t size = static_cast<std::size_t>(count) * sizeof(Number);
    bytes.resize(bytes.size() + size);
    std::memcpy(&bytes[bytes.size() - size], numbers.data(), size);
    return true;
}

using Append = bool (*)(const draco::PointAttribute&, draco::AttributeValueIndex, int,
                        std::string&);

/// @param type  glTF's number of the type of an accessor's numbers. @return  null for no type.
Append append_as(std::uint64_t type) {
    switch (type) {
        case 5120:
            return append<std::int8_t>;
        case 5121:
            return append<std::uint8_t>;
        case 5122:
            return append<std::int16_t>;
        case 5123:
            return append<std::uint16_t>;
        case 5125:
            return append<std::uint32_t>;
        case 5126:
            return append<float>;
        default:
            return nullptr;
    }
}

std::string elements_of(const draco::Mesh& mesh, const draco::PointAttribute& attribute,
                        const JsonPlace& accessor) {
    const Append append_one = append_as(accessor.at("componentType").whole());
    const int count = attribute.num_components();
    if (append_one == nullptr || count < 1 || count > 16)
        refuse_draco(accessor, "does not fit the data that Draco has packed");
    std::string bytes;
    for (draco::PointIndex point(0); point < mesh.num_points(); ++point)
        if (!append_one(attribute, attribute.mapped_index(point), count, bytes))
            refuse_draco(accessor, "does not fit the data that Draco has packed");
    return bytes;
}

std::string corners_of(const draco::Mesh& mesh, const JsonPlace& accessor) {
    const std::uint64_t type = accessor.at("componentType").whole();
    std::string bytes;
    const auto add = [&](auto number) {
        const std::size_t begin = bytes.size();
        bytes.resize(begin + sizeof number);
        std::memcpy(&bytes[begin], &number, sizeof number);
    };
    for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
        for (const draco::PointIndex& point : mesh.face(face)) {
            if (type == 5121)
                add(static_cast<std::uint8_t>(point.value()));
            else if (type == 5123)
                add(static_cast<std::uint16_t>(point.value()));
            else
                add(point.value());
        }
    return bytes;
}

void unpack_primitive(const GltfDocument& document, const JsonPlace& primitive,
                      const JsonPlace& extension, Accessors& accessors) {
    const std::unique_ptr<draco::Mesh> mesh = unpacked(document, extension);
    const JsonPlace attributes = primitive.at("attributes");
    for (const auto& [name, id] : extension.at("attributes").members()) {
        const JsonPlace index = attributes.at(name);
        const draco::PointAttribute* attribute =
            mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(id.whole()));
        if (attribute == nullptr) refuse_draco(id, "names an attribute that is not packed");
        accessors.replace(index,
                          elements_of(*mesh, *attribute, document.element("accessors", index)),
                          static_cast<std::size_t>(attribute->num_components()));
    }
    if (const auto index = primitive.find("indices"))
        accessors.replace(*index, corners_of(*mesh, document.element("accessors", *index)), 1);
}

}  // namespace

bool has_draco() {
    return true;
}

void unpack_draco(const GltfDocument& document, Accessors& accessors) {
    for (const JsonPlace& mesh : document.root().elements("meshes"))
        for (const JsonPlace& primitive : mesh.elements("primitives"))
            if (const auto extension = primitive.extension("KHR_draco_mesh_compression"))
                unpack_primitive(document, primitive, *extension, accessors);
}

#endif

}  // namespace sunfleck::engine

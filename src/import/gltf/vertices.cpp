// Colours and texture coordinates of vertices.
#include "import/gltf/vertices.h"

#include <algorithm>
#include <string>
#include <utility>

namespace sunfleck::engine {
namespace {

void check_vertices(const JsonPlace& attribute, std::size_t size, const TriangleMesh& mesh) {
    if (size != mesh.positions.size())
        attribute.refuse("has " + std::to_string(size) + " vertices, POSITION " +
                             std::to_string(mesh.positions.size()),
                         "export the file again");
}

/// Returns what makes colours of at most 1 of an accessor's numbers: integers are meant to be
/// normalised, and some exporters do not say so.
float scale_of_colours(const JsonPlace& accessor) {
    constexpr std::uint64_t kByte = 5121;
    constexpr std::uint64_t kShort = 5123;
    if (accessor.flag("normalized", false)) return 1;
    const std::uint64_t type = accessor.whole("componentType", 0);
    if (type == kByte) return 1 / 255.0F;
    return type == kShort ? 1 / 65535.0F : 1.0F;
}

/// Reads RGB or RGBA in [0,1].
void read_colours(const GltfDocument& document, const Accessors& accessors,
                  const JsonPlace& attribute, const TriangleMesh& mesh, GltfVertices& vertices) {
    const auto held = [](float x) { return std::clamp(x, 0.0F, 1.0F); };
    const JsonPlace accessor = document.element("accessors", attribute);
    const float scale = scale_of_colours(accessor);
    std::vector<Vec3> colours;
    std::vector<Vec2> alphas;
    if (accessor.text("type", "") == "VEC4") {
        for (const auto& c : accessors.quadruples(attribute)) {
            colours.emplace_back(held(scale * c[0]), held(scale * c[1]), held(scale * c[2]));
            alphas.emplace_back(held(scale * c[3]), 0.0F);
        }
        const bool is_opaque = std::all_of(alphas.begin(), alphas.end(),
                                           [](const Vec2& alpha) { return alpha.x == 1; });
        if (!is_opaque)
            vertices.alphas = std::make_shared<const std::vector<Vec2>>(std::move(alphas));
    } else {
        for (const Vec3& c : accessors.triples(attribute))
            colours.emplace_back(held(scale * c.x), held(scale * c.y), held(scale * c.z));
    }
    check_vertices(attribute, colours.size(), mesh);
    vertices.colours = std::make_shared<const std::vector<Vec3>>(std::move(colours));
}

}  // namespace

GltfVertices vertices_of(const GltfDocument& document, const Accessors& accessors,
                         const JsonPlace& primitive, const std::vector<std::uint64_t>& uv_sets,
                         const TriangleMesh& mesh) {
    GltfVertices vertices;
    vertices.own_set = uv_sets.front();
    vertices.has_own_set = !mesh.uvs.empty();
    const JsonPlace attributes = primitive.at("attributes");
    if (const auto colours = attributes.find("COLOR_0"))
        read_colours(document, accessors, *colours, mesh, vertices);
    for (std::size_t i = 1; i < uv_sets.size(); ++i) {
        const auto given = attributes.find("TEXCOORD_" + std::to_string(uv_sets[i]));
        if (!given) continue;
        std::vector<Vec2> uvs = accessors.pairs(*given);
        check_vertices(*given, uvs.size(), mesh);
        for (Vec2& uv : uvs) uv.y = 1 - uv.y;
        vertices.other_sets[uv_sets[i]] = std::make_shared<const std::vector<Vec2>>(std::move(uvs));
    }
    if (!vertices.are_plain())
        vertices.triangles = std::make_shared<const VertexValues<Vec2>::Triangles>(mesh.triangles);
    return vertices;
}

}  // namespace sunfleck::engine

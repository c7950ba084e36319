// Textures of glTF: images, decoded once, as numbers and colours of a surface.
//
// Rows of a glTF image go down with v; a TriangleMesh's v goes up, so its coordinates are (u, 1 -
// v) and images stay as they are.
#pragma once

#include "core/warnings.h"
#include "image/image.h"
#include "import/gltf/vertices.h"
#include "texture/texture.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace sunfleck::engine {

/// What an image's texels mean.
enum class TexelUse : std::uint8_t {
    colour,  // sRGB, with alpha
    linear,  // as stored
    red,     // one channel, as stored
    green,
    blue,
    alpha
};

class GltfTextures {
public:
    /// Reads and decodes all images that textures name. Both must outlive this.
    GltfTextures(GltfDocument& document, Warnings& warnings);

    /// A place of a material that takes a texture.
    struct Slot {
        ImageKind image;  // with mapping, wrap and filter
        JsonPlace place;
    };

    /// Returns what a textureInfo names, by the coordinates that it asks for. Where its image or
    /// its coordinates cannot be had, it returns nothing and warns.
    /// @throws Error  for an image in KTX2 alone.
    std::optional<Slot> find(const JsonPlace& holder, std::string_view key, TexelUse use,
                             const GltfVertices& vertices);

private:
    std::shared_ptr<const Image> image_of(std::size_t number, TexelUse use);
    void load(const std::vector<std::size_t>& numbers);

    GltfDocument& document_;
    Warnings& warnings_;
    std::vector<std::shared_ptr<const Image>> images_;  // as stored; null: not used, or not read
    std::vector<bool> is_deep_;                         // 16 bits per channel, not decoded
    std::map<std::pair<std::size_t, TexelUse>, std::shared_ptr<const Image>> made_;
};

/// Returns the number of the texture coordinates that a textureInfo asks for.
std::uint64_t uv_set_of(const JsonPlace& info);

/// Returns an image times a colour; the same image for white.
std::shared_ptr<const Image> coloured(std::shared_ptr<const Image> image, const Vec3d& by);

}  // namespace sunfleck::engine

// Colours are sRGB, numbers and normals as stored.
#include "import/part/pictures.h"

#include "image/read_image.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

ImageKind kind_of(const MtlMap& map, std::shared_ptr<const Image> image) {
    ImageKind kind;
    kind.image = std::move(image);
    kind.mapping = UvMapping{Vec2(map.scale), Vec2(map.offset)};
    if (map.clamps) kind.wraps = Wrap::clamp;
    return kind;
}

/// Returns an image of other texels, made one by one.
/// @param make  returns a texel of `channels` numbers from one of the image.
template <class Make>
std::shared_ptr<const Image> remade(const Image& image, int channels, const Make& make) {
    const Vec2i size = image.resolution();
    std::vector<half> texels;
    texels.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                   static_cast<std::size_t>(channels));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const std::array<float, 4> texel = make(x, y);
            for (int c = 0; c < channels; ++c)
                texels.emplace_back(texel.at(static_cast<std::size_t>(c)));
        }
    return std::make_shared<const Image>(size, channels, std::move(texels));
}

std::shared_ptr<const Image> times(const std::shared_ptr<const Image>& image, const Vec3d& by) {
    if (by == Vec3d(1)) return image;
    const Vec3 factor(by);
    return remade(*image, 3, [&](int x, int y) {
        const Vec3 rgb = image->rgb(x, y) * factor;
        return std::array<float, 4>{rgb.x, rgb.y, rgb.z, 0};
    });
}

/// Returns the channel of an image that -imfchan names; the image itself for the usual one.
std::shared_ptr<const Image> channel_of(const std::shared_ptr<const Image>& image, char name) {
    constexpr std::string_view kNames = "rgbm";
    const std::size_t channel = kNames.find(name);
    if (name == 0 || channel == std::string_view::npos || image->channels() < 3) return image;
    if (channel == 3 && image->channels() < 4) return image;
    return remade(*image, 1, [&](int x, int y) {
        return std::array<float, 4>{image->at(x, y).at(channel), 0, 0, 0};
    });
}

/// Returns whether an image is coloured and mostly blue, as normals near the surface's are.
bool has_normals(const Image& image) {
    if (image.channels() < 3) return false;
    constexpr int kSteps = 64;  // texels looked at along each side
    const Vec2i size = image.resolution();
    Vec3d sum(0);
    int count = 0;
    for (int y = 0; y < size.y; y += std::max(size.y / kSteps, 1))
        for (int x = 0; x < size.x; x += std::max(size.x / kSteps, 1), ++count)
            sum += Vec3d(image.rgb(x, y));
    const Vec3d mean = sum / std::max(count, 1);
    return mean.z > 0.75 && mean.x > 0.35 && mean.x < 0.65 && mean.y > 0.35 && mean.y < 0.65;
}

}  // namespace

std::shared_ptr<const Image> PartPictures::read(const MtlMap& map, const std::string& library,
                                                Encoding::Kind encoding) {
    const auto file = files_.find(map.file, library, map.where);
    if (!file) return nullptr;
    std::shared_ptr<const Image>& stored = images_[file->path];
    if (!stored) {
        try {
            stored = std::make_shared<const Image>(
                parse_image(file->bytes, file->path, Encoding{Encoding::Kind::linear}));
        } catch (const Error& fault) {
            throw fault.asked_for_at(map.where);
        }
    }
    return std::make_shared<const Image>(stored->resolution(), stored->channels(), stored->texels(),
                                         Encoding{encoding});
}

std::optional<SpectrumTexture> PartPictures::colour(const MtlMap* map, const Vec3d& by,
                                                    const std::string& library) {
    if (map == nullptr) return {};
    const auto image = read(*map, library, Encoding::Kind::srgb);
    if (!image) return {};
    return SpectrumTexture(
        SpectrumKind{SpectrumImageKind{kind_of(*map, times(image, by)), ColourUse::albedo}});
}

std::optional<FloatTexture> PartPictures::number(const MtlMap* map, const std::string& library) {
    if (map == nullptr) return {};
    const auto image = read(*map, library, Encoding::Kind::linear);
    if (!image) return {};
    return FloatTexture(FloatKind{FloatImageKind{kind_of(*map, channel_of(image, map->channel))}});
}

BumpMap PartPictures::normals(const MtlMap* map, const std::string& library) {
    if (map == nullptr) return {};
    const auto image = read(*map, library, Encoding::Kind::linear);
    if (!image) return {};
    const ImageKind kind = kind_of(*map, image);
    return NormalMap{kind.image, kind.mapping, kind.wraps, static_cast<float>(map->bump), true};
}

BumpMap PartPictures::normals_in_place_of_heights(const MtlMap* map, const std::string& library) {
    if (map == nullptr) return {};
    const auto image = read(*map, library, Encoding::Kind::linear);
    if (!image) return {};
    if (has_normals(*image)) return normals(map, library);
    warnings_.add(map->where,
                  "a map of heights is left out: the file does not say how high they are");
    return {};
}

std::shared_ptr<const Image> PartPictures::light(const MtlMap* map, const Vec3d& by,
                                                 const std::string& library) {
    if (map == nullptr) return nullptr;
    const auto image = read(*map, library, Encoding::Kind::srgb);
    return image ? times(image, by) : nullptr;
}

}  // namespace sunfleck::engine

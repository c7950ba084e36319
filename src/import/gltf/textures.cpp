// Images from files, data URIs and buffer views; samplers and texture transforms.
#include "import/gltf/textures.h"

#include "core/parallel.h"
#include "image/read_image.h"
#include "image/srgb.h"
#include "import/gltf/uri.h"
#include "math/trigonometry.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Bytes of an image, and what to call them in messages.
struct Encoded {
    std::string bytes;
    std::string name;
};

Encoded encoded_image(GltfDocument& document, const JsonPlace& image) {
    if (const auto view = image.find("bufferView"))
        return {std::string(document.bytes_of(document.element("bufferViews", *view))),
                image.where().file};
    const JsonPlace uri = image.at("uri");
    const std::string text = uri.text();
    return {document.read(uri), is_data_uri(text) ? uri.where().file : without_escapes(text)};
}

/// Returns the number of a texture's image; nothing where it has none that is read.
std::optional<JsonPlace> source_of(const JsonPlace& texture) {
    if (const auto webp = texture.extension("EXT_texture_webp"))
        if (auto source = webp->find("source")) return source;
    return texture.find("source");
}

/// Returns 8-bit texels under another encoding; floats and halves are linear as they are.
Image encoded_as(const Image& image, Encoding::Kind kind) {
    return {image.resolution(), image.channels(), image.texels(), Encoding{kind}};
}

/// Returns whether a file is a PNG with 16 bits per channel.
bool is_deep_png(std::string_view bytes) {
    constexpr std::size_t kDepth = 24;  // place of the number of bits
    return bytes.starts_with("\x89PNG") && bytes.size() > kDepth && bytes[kDepth] == 16;
}

/// Returns the linear light of texels that hold sRGB as numbers; alpha stays.
Image decoded(const Image& image) {
    const Vec2i size = image.resolution();
    std::vector<float> texels;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            for (int c = 0; c < image.channels(); ++c) {
                const float value = image.at(x, y).at(static_cast<std::size_t>(c));
                texels.push_back(c == 3 ? value : srgb_decode(value));
            }
    return {size, image.channels(), std::move(texels)};
}

Image channel_of(const Image& image, std::size_t channel) {
    const Vec2i size = image.resolution();
    std::vector<half> texels;
    texels.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    constexpr std::size_t kAlpha = 3;
    const bool grey = image.channels() < 3 && channel < kAlpha;
    const bool is_opaque = image.channels() < 4 && channel == kAlpha;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            texels.emplace_back(is_opaque ? 1.0F : image.at(x, y).at(grey ? 0 : channel));
    return {size, 1, std::move(texels)};
}

constexpr std::uint64_t kClamp = 33071;
constexpr std::uint64_t kMirror = 33648;
constexpr std::uint64_t kNearest = 9728;

Wrap wrap_of(std::uint64_t code) {
    if (code == kClamp) return Wrap::clamp;
    return code == kMirror ? Wrap::mirror : Wrap::repeat;
}

/// Returns the map of (u, 1 - v) that KHR_texture_transform asks for of (u, v).
TurnedUvMapping mapping_of(const JsonPlace& transform) {
    const auto pair = [&](std::string_view key, double fallback) {
        const auto found = transform.find(key);
        return found ? found->numbers(2) : std::vector<double>{fallback, fallback};
    };
    const std::vector<double> offset = pair("offset", 0);
    const std::vector<double> scale = pair("scale", 1);
    const auto [sine, cosine] = sin_cos_2pi(transform.number("rotation", 0) / (2 * kPiDouble));
    // In the file's v, downwards: u' = cos su u + sin sv v + ou, v' = -sin su u + cos sv v + ov.
    const auto number = [](double x) { return static_cast<float>(x); };
    TurnedUvMapping map;
    map.u = {number(cosine * scale[0]), number(-sine * scale[1])};
    map.v = {number(sine * scale[0]), number(cosine * scale[1])};
    map.shift = {number(offset[0] + sine * scale[1]), number(1 - offset[1] - cosine * scale[1])};
    return map;
}

}  // namespace

GltfTextures::GltfTextures(GltfDocument& document, Warnings& warnings)
    : document_(document), warnings_(warnings) {
    const std::size_t count = document.count("images");
    images_.resize(count);
    is_deep_.resize(count);
    std::vector<std::size_t> used;
    for (const JsonPlace& texture : document.root().elements("textures"))
        if (const auto source = source_of(texture)) used.push_back(source->index(count, "image"));
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    load(used);
}

void GltfTextures::load(const std::vector<std::size_t>& numbers) {
    const std::vector<JsonPlace> all = document_.root().elements("images");
    std::vector<Encoded> files;
    for (const std::size_t number : numbers) files.push_back(encoded_image(document_, all[number]));
    document_.check_missing();
    for (std::size_t i = 0; i < numbers.size(); ++i)
        is_deep_[numbers[i]] = is_deep_png(files[i].bytes);
    std::vector<std::optional<Error>> faults(numbers.size());
    parallel_for(numbers.size(), [&](std::size_t i) {
        try {
            images_[numbers[i]] = std::make_shared<const Image>(parse_image_with_alpha(
                files[i].bytes, files[i].name, Encoding{Encoding::Kind::linear}));
        } catch (const Error& fault) {
            faults[i] = fault;
        }
    });
    for (std::size_t i = 0; i < faults.size(); ++i)
        if (faults[i]) throw faults[i]->asked_for_at(all[numbers[i]].where());
}

std::shared_ptr<const Image> GltfTextures::image_of(std::size_t number, TexelUse use) {
    std::shared_ptr<const Image>& made = made_[{number, use}];
    if (made) return made;
    const Image& stored = *images_[number];
    if (use == TexelUse::colour) {
        made = std::make_shared<const Image>(
            is_deep_[number] ? decoded(stored) : encoded_as(stored, Encoding::Kind::srgb));
    } else {
        const Image linear = encoded_as(stored, Encoding::Kind::linear);
        const auto channel =
            static_cast<std::size_t>(use) - static_cast<std::size_t>(TexelUse::red);
        made = std::make_shared<const Image>(use == TexelUse::linear ? linear
                                                                     : channel_of(linear, channel));
    }
    return made;
}

std::uint64_t uv_set_of(const JsonPlace& info) {
    const std::uint64_t plain = info.whole("texCoord", 0);
    const auto transform = info.extension("KHR_texture_transform");
    return transform ? transform->whole("texCoord", plain) : plain;
}

std::optional<GltfTextures::Slot> GltfTextures::find(const JsonPlace& holder, std::string_view key,
                                                     TexelUse use, const GltfVertices& vertices) {
    const auto info = holder.find(key);
    if (!info) return {};
    const JsonPlace texture = document_.element("textures", info->at("index"));
    const auto source = source_of(texture);
    const bool has_ktx = texture.extension("KHR_texture_basisu").has_value();
    if (!source && has_ktx)
        texture.refuse("has its image in KTX2 alone (KHR_texture_basisu), which is not read",
                       "export it with PNG or JPEG");
    if (!source) {
        warnings_.add(texture.where(), "has no image: the texture is left out");
        return {};
    }
    if (has_ktx)
        warnings_.add(texture.where(),
                      "its image in KTX2 (KHR_texture_basisu) is not read: the other is used");
    ImageKind image;
    image.image = image_of(source->index(images_.size(), "image"), use);
    if (const auto index = texture.find("sampler")) {
        const JsonPlace sampler = document_.element("samplers", *index);
        image.wraps = {wrap_of(sampler.whole("wrapS", 0)), wrap_of(sampler.whole("wrapT", 0))};
        image.nearest = sampler.whole("magFilter", 0) == kNearest;
    }
    const auto transform = info->extension("KHR_texture_transform");
    if (transform) image.mapping = mapping_of(*transform);
    const std::uint64_t uv_set = uv_set_of(*info);
    const bool is_own = uv_set == vertices.own_set;
    if (is_own && vertices.has_own_set) return Slot{std::move(image), *info};
    const auto others = vertices.other_sets.find(uv_set);
    if (others == vertices.other_sets.end()) {
        warnings_.add(info->where(),
                      "asks for texture coordinates that its mesh lacks: the texture is left out");
        return {};
    }
    image.mapping = VertexMapping{{vertices.triangles, others->second},
                                  transform ? mapping_of(*transform) : TurnedUvMapping()};
    return Slot{std::move(image), *info};
}

std::shared_ptr<const Image> coloured(std::shared_ptr<const Image> image, const Vec3d& by) {
    if (by == Vec3d(1)) return image;
    const Vec2i size = image->resolution();
    const int channels = image->channels() == 4 ? 4 : 3;
    std::vector<half> texels;
    texels.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                   static_cast<std::size_t>(channels));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const Vec3 rgb = image->rgb(x, y);
            for (int c = 0; c < 3; ++c) texels.emplace_back(rgb[c] * static_cast<float>(by[c]));
            if (channels == 4) texels.emplace_back(image->at(x, y)[3]);
        }
    return std::make_shared<const Image>(size, channels, std::move(texels));
}

}  // namespace sunfleck::engine

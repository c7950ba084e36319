// The encoding of pictures, and their names.
#include "export/picture_files.h"

#include "image/exr.h"
#include "image/png.h"

#include <fmt/format.h>

namespace sunfleck::engine {
namespace {

using SharedImage = std::shared_ptr<const Image>;

bool has_bytes(const Image& image) {
    return std::holds_alternative<std::vector<std::uint8_t>>(image.texels());
}

/// Returns whether 8-bit texels are encoded so.
bool is_encoded(const Image& image, const Encoding& encoding) {
    const auto& bytes = std::get<std::vector<std::uint8_t>>(image.texels());
    std::array<float, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = encoding.decode(static_cast<float>(i) / 255);
    const auto channels = static_cast<std::size_t>(image.channels());
    std::size_t i = 0;
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x) {
            const std::array<float, 4> texel = image.at(x, y);
            for (std::size_t c = 0; c < channels; ++c)
                if (texel.at(c) != light[bytes[i++]]) return false;
        }
    return true;
}

std::string bytes_of_png(const Image& image) {
    const auto& bytes = std::get<std::vector<std::uint8_t>>(image.texels());
    return png_bytes(image.resolution(), image.channels(), bytes);
}

std::string bytes_of_exr(const Image& image) {
    static constexpr std::array<const char*, 4> kColours = {"R", "G", "B", "A"};
    Picture picture;
    picture.width = image.resolution().x;
    picture.height = image.resolution().y;
    const int channels = image.channels();
    for (int c = 0; c < channels; ++c)
        picture.add(channels == 1 ? "Y" : kColours.at(static_cast<std::size_t>(c)));
    std::size_t i = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x, ++i) {
            const std::array<float, 4> texel = image.at(x, y);
            for (std::size_t c = 0; c < picture.channels.size(); ++c)
                picture.channels[c].values[i] = texel.at(c);
        }
    const bool half = std::holds_alternative<std::vector<::half>>(image.texels());
    return exr_bytes(picture, {half});
}

/// Returns the picture beside its mirror image, above its mirror image, or both.
Image with_mirror_images(const Image& image, bool across, bool down) {
    const Vec2i size = image.resolution();
    const Vec2i whole(across ? 2 * size.x : size.x, down ? 2 * size.y : size.y);
    const auto channels = static_cast<std::size_t>(image.channels());
    const auto folded = [](int i, int side) { return i < side ? i : 2 * side - 1 - i; };
    const auto copied = [&]<class T>(const std::vector<T>& texels) {
        std::vector<T> result;
        result.reserve(static_cast<std::size_t>(whole.x) * static_cast<std::size_t>(whole.y) *
                       channels);
        for (int y = 0; y < whole.y; ++y)
            for (int x = 0; x < whole.x; ++x) {
                const auto row = static_cast<std::size_t>(folded(y, size.y));
                const auto column = static_cast<std::size_t>(folded(x, size.x));
                const std::size_t first =
                    (row * static_cast<std::size_t>(size.x) + column) * channels;
                for (std::size_t c = 0; c < channels; ++c) result.push_back(texels[first + c]);
            }
        return Image::Texels(std::move(result));
    };
    Encoding encoding;
    if (has_bytes(image) && !is_encoded(image, encoding)) encoding = {Encoding::Kind::linear, 1};
    return {whole, image.channels(), std::visit(copied, image.texels()), encoding};
}

/// Returns the picture with its values decoded.
SharedImage decoded(const Image& image) {
    std::vector<float> texels;
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x) {
            const std::array<float, 4> texel = image.at(x, y);
            texels.insert(texels.end(), texel.begin(), texel.begin() + image.channels());
        }
    return std::make_shared<const Image>(image.resolution(), image.channels(), std::move(texels));
}

}  // namespace

std::string PictureFiles::next_name(std::string_view what, std::string_view ending) {
    const int number = ++counts_[std::string(what)];
    return fmt::format("{}/{}-{}{}", folder_, what, number, ending);
}

PictureFiles::Entry PictureFiles::add(const SharedImage& image) {
    const bool is_srgb = has_bytes(*image) && is_encoded(*image, Encoding());
    const bool is_png =
        is_srgb || (has_bytes(*image) && is_encoded(*image, {Encoding::Kind::linear, 1}));
    const SharedImage written = is_png || !has_bytes(*image) ? image : decoded(*image);
    Entry entry{next_name("texture", is_png ? ".png" : ".exr"), is_png && !is_srgb ? "linear" : ""};
    files_.push_back({entry.name, [written, is_png] {
                          return is_png ? bytes_of_png(*written) : bytes_of_exr(*written);
                      }});
    return entry;
}

const PictureFiles::Entry& PictureFiles::texture(const SharedImage& image) {
    const auto known = known_.find(image);
    if (known != known_.end()) return known->second;
    return known_.emplace(image, add(image)).first->second;
}

const std::string& PictureFiles::linear(const SharedImage& image) {
    const Entry& entry = texture(image);
    if (entry.name.ends_with(".exr") || entry.encoding == "linear") return entry.name;
    const auto known = linear_.find(image);
    if (known != linear_.end()) return known->second;
    return linear_.emplace(image, add(decoded(*image)).name).first->second;
}

const PictureFiles::Entry& PictureFiles::mirrored(const SharedImage& image, bool across,
                                                  bool down) {
    const std::pair key{image, (across ? 1 : 0) + (down ? 2 : 0)};
    const auto known = mirrored_.find(key);
    if (known != mirrored_.end()) return known->second;
    const auto whole = std::make_shared<const Image>(with_mirror_images(*image, across, down));
    return mirrored_.emplace(key, add(whole)).first->second;
}

std::string PictureFiles::add_light(std::string_view what, SharedImage image) {
    std::string name = next_name(what, ".exr");
    files_.push_back({name, [image = std::move(image)] { return bytes_of_exr(*image); }});
    return name;
}

SharedImage rgb_floats(const Image& image, const Vec3& by) {
    std::vector<float> texels;
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x) {
            const Vec3 rgb = image.rgb(x, y) * by;
            texels.insert(texels.end(), {rgb.x, rgb.y, rgb.z});
        }
    return std::make_shared<const Image>(image.resolution(), 3, std::move(texels));
}

}  // namespace sunfleck::engine

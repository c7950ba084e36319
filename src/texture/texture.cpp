// Evaluation of each kind of texture at a point.
#include "texture/texture.h"

#include "math/sigmoid_table.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Returns whether an integer-valued float of any size is odd.
bool is_odd(float whole) {
    return whole - 2 * std::floor(whole * 0.5F) != 0;
}

struct ParityOfCell {
    const TexturePoint& point;

    bool operator()(const Mapping& mapping) const {
        const Vec2 st = place(mapping, point);
        return is_odd(std::floor(st.x)) != is_odd(std::floor(st.y));
    }
    bool operator()(const PointMapping& mapping) const {
        const Vec3 p = mapping.at(point);
        const bool flat = is_odd(std::floor(p.x)) != is_odd(std::floor(p.y));
        return flat != is_odd(std::floor(p.z));
    }
};

/// Noise at fixed points of a cell moves its dot (pbrt-v4).
bool is_in_dot(const Vec2& st) {
    constexpr float kRadius = 0.35F;
    constexpr float kMostShift = 0.5F - kRadius;
    const Vec2 cell(std::floor(st.x + 0.5F), std::floor(st.y + 0.5F));
    const auto noise_at = [&](float x, float y) { return noise({cell.x + x, cell.y + y, 0.5F}); };
    if (!(noise_at(0.5F, 0.5F) > 0)) return false;
    const Vec2 center = cell + Vec2(noise_at(1.5F, 2.8F), noise_at(4.5F, 9.8F)) * kMostShift;
    return (st - center).length2() < kRadius * kRadius;
}

/// Evaluation that both sorts of textures share. @tparam At  returns a texture's value at the
/// point.
template <class At>
class ValueOf {
public:
    ValueOf(const TexturePoint& point, const At& at) : point_(point), at_(at) {}

    template <class T>
    auto operator()(const ScaledKind<T>& m) const {
        return at_(m.texture) * m.factor.at(point_);
    }
    template <class T>
    auto operator()(const MixKind<T>& m) const {
        return mixed(m.first, m.second, m.amount.at(point_));
    }
    template <class T>
    auto operator()(const DirectionMixKind<T>& m) const {
        return mixed(m.second, m.first, std::abs(point_.normal.dot(m.direction)));
    }
    template <class T>
    auto operator()(const CheckerboardKind<T>& m) const {
        return at_(std::visit(ParityOfCell{point_}, m.mapping) ? m.second : m.first);
    }
    template <class T>
    auto operator()(const DotsKind<T>& m) const {
        return at_(is_in_dot(place(m.mapping, point_)) ? m.inside : m.outside);
    }
    template <class T>
    auto operator()(const BilerpKind<T>& m) const {
        const Vec2 st = place(m.mapping, point_);
        const auto low = at_(m.v00) * (1 - st.x) + at_(m.v10) * st.x;
        const auto high = at_(m.v01) * (1 - st.x) + at_(m.v11) * st.x;
        return low * (1 - st.y) + high * st.y;
    }

protected:
    /// Evaluates only the textures with non-zero weight.
    template <class T>
    auto mixed(const T& first, const T& second, float amount) const {
        if (amount == 0) return at_(first);
        if (amount == 1) return at_(second);
        return at_(first) * (1 - amount) + at_(second) * amount;
    }

    const TexturePoint& point_;
    const At& at_;
};

template <class At>
struct FloatValue : ValueOf<At> {
    using ValueOf<At>::ValueOf;
    using ValueOf<At>::operator();

    float operator()(const FloatImageKind& m) const { return image_number(m, this->point_); }
    float operator()(const VertexNumberKind& m) const { return m.numbers.at(this->point_).x; }
    float operator()(const FbmKind& m) const { return fbm(m.mapping.at(this->point_), m.octaves); }
    float operator()(const WrinkledKind& m) const {
        return turbulence(m.mapping.at(this->point_), m.octaves);
    }
    float operator()(const WindyKind& m) const {
        const Vec3 p = m.mapping.at(this->point_);
        return std::abs(fbm(p * 0.1F, {3, 0.5F})) * fbm(p, {6, 0.5F});
    }
};

/// Returns a point of the Bezier curves through the colours of pbrt-v4's marble.
Vec3 marble_colour(float t) {
    static const std::array<Vec3, 9> colours = {
        Vec3(0.58F, 0.58F, 0.6F), Vec3(0.58F, 0.58F, 0.6F), Vec3(0.58F, 0.58F, 0.6F),
        Vec3(0.5F, 0.5F, 0.5F),   Vec3(0.6F, 0.59F, 0.58F), Vec3(0.58F, 0.58F, 0.6F),
        Vec3(0.58F, 0.58F, 0.6F), Vec3(0.2F, 0.2F, 0.33F),  Vec3(0.58F, 0.58F, 0.6F)};
    constexpr std::size_t kPieces = colours.size() - 3;
    const float place = t * static_cast<float>(kPieces);
    const std::size_t first = std::min(static_cast<std::size_t>(place), kPieces - 1);
    const float s = place - static_cast<float>(first);
    const float r = 1 - s;
    return (colours.at(first) * (r * r * r) + colours.at(first + 1) * (3 * s * r * r) +
            colours.at(first + 2) * (3 * s * s * r) + colours.at(first + 3) * (s * s * s)) *
           1.5F;
}

template <class At>
struct SpectrumValue : ValueOf<At> {
    SpectrumValue(const TexturePoint& point, const At& at, const Wavelengths& all)
        : ValueOf<At>(point, at), wavelengths(all) {}
    using ValueOf<At>::operator();

    SampledSpectrum operator()(const SpectrumImageKind& m) const {
        const SigmoidTable& table = SigmoidTable::srgb();
        const Vec3 rgb = image_rgb(m, this->point_);
        if (m.use == ColourUse::albedo) return table.albedo(rgb, wavelengths);
        const SampledSpectrum value = table.unbounded(rgb, wavelengths);
        if (m.use == ColourUse::unbounded) return value;
        return value * Spectrum::d65().at(wavelengths);
    }
    SampledSpectrum operator()(const VertexColourKind& m) const {
        Vec3 rgb = m.colours.at(this->point_);
        if (m.image) rgb *= image_rgb(*m.image, this->point_);
        return SigmoidTable::srgb().albedo(rgb, wavelengths);
    }
    SampledSpectrum operator()(const MarbleKind& m) const {
        const Vec3 p = m.mapping.at(this->point_) * m.scale;
        const float phase = p.y + m.variation * fbm(p, m.octaves);
        const float t = std::isfinite(phase) ? 0.5F + 0.5F * std::sin(phase) : 0;
        return SigmoidTable::srgb().albedo(marble_colour(t), wavelengths);
    }

    const Wavelengths& wavelengths;
};

}  // namespace

FloatTexture::FloatTexture(FloatKind kind)
    : constant_(0), kind_(std::make_shared<const FloatKind>(std::move(kind))) {}

float FloatTexture::varied(const TexturePoint& point) const {
    const auto at = [&](const FloatTexture& texture) { return texture.at(point); };
    return std::visit(FloatValue<decltype(at)>(point, at), kind_->kind);
}

SpectrumTexture::SpectrumTexture(SpectrumKind kind)
    : kind_(std::make_shared<const SpectrumKind>(std::move(kind))) {
    const bool has_colours = std::holds_alternative<SpectrumImageKind>(kind_->kind) ||
                             std::holds_alternative<VertexColourKind>(kind_->kind) ||
                             std::holds_alternative<MarbleKind>(kind_->kind);
    if (has_colours)
        SigmoidTable::srgb();  // built now, because it may not be built within parallel work
}

SampledSpectrum SpectrumTexture::varied(const TexturePoint& point,
                                        const Wavelengths& wavelengths) const {
    const auto at = [&](const SpectrumTexture& texture) { return texture.at(point, wavelengths); };
    return std::visit(SpectrumValue<decltype(at)>(point, at, wavelengths), kind_->kind);
}

}  // namespace sunfleck::engine

// A base of albedo a under a coat sends a l / (1 - a r) out, where the coat lets a share l of
// diffuse light leave, and returns a share r.
#include "export/coated_colours.h"

#include "bsdf/coat_reflection.h"
#include "export/spectra.h"
#include "math/colour.h"
#include "math/warp.h"

#include <algorithm>
#include <functional>

namespace sunfleck::engine {
namespace {

using OfWhole = std::function<float(float whole)>;

/// Returns the share of diffuse light that the coat itself reflects.
float reflected_by(const Coat& coat) {
    constexpr int kLooks = 16;  // per dimension
    double sum = 0;
    const auto place = [](int i) { return (i + 0.5) / kLooks; };
    for (int k = 0; k < kLooks; ++k) {
        const Vec3 wo(cosine_hemisphere({place(k), place(7 * k % kLooks)}));
        for (int j = 0; j < kLooks; ++j)
            for (int i = 0; i < kLooks; ++i) {
                const Vec3 u(Vec3d(0.5, place(i), place(j)));
                const auto drawn = CoatReflection{&coat}.sample(wo, {u, Transport::radiance, {}});
                if (drawn) sum += static_cast<double>(drawn->weight[0]);
            }
    }
    return static_cast<float>(sum / (kLooks * kLooks * kLooks));
}

float base_under(const Coat& coat, float whole) {
    const float needed = whole * coat.eta() * coat.eta() / coat.mean_entering();
    return needed / (1 + needed * coat.returning());
}

/// Returns the greatest value of a spectrum or picture; nothing for other textures.
std::optional<float> greatest_of(const SpectrumTexture& texture) {
    float most = 0;
    if (texture.is_constant()) {
        for (int nm = kFirstNm; nm <= kLastNm; ++nm)
            most = std::max(most, texture.curve()(static_cast<float>(nm)));
        return most;
    }
    const auto* kind = std::get_if<SpectrumImageKind>(&texture.kind()->kind);
    if (!kind || kind->scale != 1 || kind->invert) return {};
    const Image& image = *kind->image;
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x) {
            const Vec3 rgb = image.rgb(x, y);
            most = std::max({most, rgb.x, rgb.y, rgb.z});
        }
    return most;
}

/// @param texture  a constant, or a picture.
SpectrumTexture changed(const SpectrumTexture& texture, const OfWhole& change) {
    const auto of = [&](float whole) { return change(std::clamp(whole, 0.0F, 1.0F)); };
    if (texture.is_constant()) {
        const Spectrum& given = texture.curve();
        if (given.is_constant()) return Spectrum::constant(of(given(kFirstNm)));
        return sparse_table([&](float nm) { return of(given(nm)); });
    }
    SpectrumImageKind made = std::get<SpectrumImageKind>(texture.kind()->kind);
    const Image& image = *made.image;
    std::vector<float> texels;
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x) {
            const Vec3 rgb = image.rgb(x, y);
            texels.insert(texels.end(), {of(rgb.x), of(rgb.y), of(rgb.z)});
        }
    made.image = std::make_shared<const Image>(image.resolution(), 3, std::move(texels));
    return SpectrumTexture(SpectrumKind{std::move(made)});
}

}  // namespace

std::optional<CoatedColour> coated_colour(const Coat& coat, const SpectrumTexture& whole) {
    constexpr float kRounding = 1e-3F;
    const auto most = greatest_of(whole);
    if (!most) return {};
    const auto base = [&](float share) { return std::min(1.0F, base_under(coat, share)); };
    if (base_under(coat, std::min(*most, 1.0F)) <= 1 + kRounding)
        return CoatedColour{changed(whole, base)};
    const float above = reflected_by(coat);
    const auto both = [&](float share) {
        return std::min(1.0F, above + coat.mean_entering() * share);
    };
    return CoatedColour{changed(whole, both), false};
}

}  // namespace sunfleck::engine

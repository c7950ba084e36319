// The colours of texels that multiply a light's spectrum.
//
// pbrt-v4's lights with a picture have D65 there: the spectrum becomes part of the texels.
#pragma once

#include "image/image.h"
#include "math/spectrum.h"

#include <memory>
#include <vector>

namespace sunfleck::engine {

class LightColours {
public:
    /// @param curve  of a light with an image.
    explicit LightColours(const Spectrum& curve);

    /// Returns what multiplies the written texels: the luminance of the curve.
    float scale() const { return scale_; }
    /// Returns whether texels stay as they are: the curve is D65.
    bool are_kept() const { return curve_.empty(); }
    /// Returns the colour that a texel has under the curve, over scale(). Components that would be
    /// negative are zero.
    Vec3 of(const Vec3& texel) const;

private:
    Vec3 seen(const Vec3& texel) const;

    float scale_ = 1;
    Vec3 white_{1};             // colour of the curve itself
    std::vector<float> curve_;  // over its luminance, every kStep nanometres
};

/// Returns a picture of floats with RGB, each texel under the light's spectrum.
std::shared_ptr<const Image> under(const LightColours& colours, const Image& image);

}  // namespace sunfleck::engine

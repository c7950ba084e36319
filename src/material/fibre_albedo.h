// What a hair does with the light that falls on it from everywhere: the shares of its lobes.
//
// Source: Marschner et al., Light Scattering from Human Hair Fibers (2003) for the paths in a
// clear cylinder; Chiang et al., A Practical and Controllable Hair and Fur Model (2016) for the
// colour of what absorbs in it, as pbrt-v4 has it. Scales, roughness and tilt move no energy.
#pragma once

namespace sunfleck::engine {

/// Of the light that meets a fibre; the rest is absorbed.
struct FibreAlbedo {
    float back = 0;     // reflected by the surface, or after one reflection or more within
    float through = 0;  // refracted in and out
};

/// Mean over the width of the fibre and over light that comes evenly from all directions.
/// @param absorption  per radius of the fibre, not negative. @param eta  of the fibre, above 0.
FibreAlbedo fibre_albedo(float absorption, float eta);

/// Absorption per radius of hair that looks, many fibres together, of that colour.
/// @param colour  in (0,1]. @param beta  azimuthal roughness, in [0.01, 1].
float absorption_of_hair(float colour, float beta);

}  // namespace sunfleck::engine

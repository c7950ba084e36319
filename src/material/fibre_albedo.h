// Albedo of hair fibres under uniform illumination, split into reflection and transmission.
//
// Source: Marschner et al., Light Scattering from Human Hair Fibers (2003) for the paths in a clear
// cylinder; Chiang et al., A Practical and Controllable Hair and Fur Model (2016) for absorption,
// as in pbrt-v4. Scales, roughness and tilt do not change the energy.
#pragma once

namespace sunfleck::engine {

/// Fractions of the light on a fibre; the rest is absorbed.
struct FibreAlbedo {
    float back = 0;     // reflected by the surface, or after internal reflections
    float through = 0;  // refracted in and out
};

/// Returns the mean over the width of the fibre and over uniform illumination.
/// @param absorption  per radius of the fibre, not negative.
/// @param eta  of the fibre, positive.
FibreAlbedo fibre_albedo(float absorption, float eta);

/// Returns the absorption per radius with which many fibres together have that colour.
/// @param colour  in (0,1].
/// @param beta  azimuthal roughness, in [0.01, 1].
float absorption_of_hair(float colour, float beta);

}  // namespace sunfleck::engine

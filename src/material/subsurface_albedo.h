// SubsurfaceAlbedo: albedo of a scattering half-space under a smooth surface, by photon beam
// diffusion.
//
// In:  single-scattering albedo.
// Out: fraction of the light entering at a right angle that leaves at any point, with all internal
// reflections at the surface.
// Source: Habel, Christensen and Jarosz, Photon Beam Diffusion (2013), with single scattering, as
// in pbrt-v4's BSSRDF; boundary condition of d'Eon and Irving, A Quantized-Diffusion Model (2011).
#pragma once

#include <array>

namespace sunfleck::engine {

class SubsurfaceAlbedo {
public:
    /// @param eta  index of the inside, positive. @param g  mean cosine of scattering, in (-1,1).
    SubsurfaceAlbedo(float eta, float g);

    /// @param single  single-scattering albedo in [0,1]. @return the albedo in [0,1].
    float operator()(float single) const;

private:
    static constexpr int kCells = 48;
    /// The table has equal steps in depth = -log(1 - single), which is finest near one.
    static constexpr float kDeepest = 14;
    std::array<float, kCells + 1> table_{};
};

}  // namespace sunfleck::engine

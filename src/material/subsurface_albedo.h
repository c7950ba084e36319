// How much light comes out again of a cloudy half-space under a smooth surface.
//
// In:  scattering over extinction. Out: of the light that enters at a right angle, the share that
// leaves, wherever it does; all reflections at the surface from within are in it.
// Source: Habel, Christensen and Jarosz, Photon Beam Diffusion (2013), with single scattering, as
// pbrt-v4's BSSRDF has it; boundary of d'Eon and Irving, A Quantized-Diffusion Model (2011).
#pragma once

#include <array>

namespace sunfleck::engine {

class SubsurfaceAlbedo {
public:
    /// @param eta  of the inside, above 0. @param g  mean cosine of scattering, in (-1,1).
    SubsurfaceAlbedo(float eta, float g);

    /// @param single  scattering over extinction, in [0,1]. @return in [0,1].
    float operator()(float single) const;

private:
    static constexpr int kCells = 48;
    /// By depth = -log(1 - single) in equal steps: albedos near one matter most.
    static constexpr float kDeepest = 14;
    std::array<float, kCells + 1> table_{};
};

}  // namespace sunfleck::engine

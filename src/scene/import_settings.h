// ImportSettings: what a user says about a scene file whose format leaves it open.
#pragma once

#include <optional>
#include <string>

namespace sunfleck::engine {

/// Whether transmitting surfaces of glTF bound a solid or are thin panes.
enum class GlassRule {
    automatic,  // solid where the surface is closed
    solid,
    thin
};

enum class UpAxis { y, z };

/// Unit of emission in glTF.
enum class EmissionUnit { nit, watt };

/// What pbrt-v4's subsurface scattering becomes: a coat over a diffuse surface, or a medium below a
/// dielectric.
enum class SubsurfaceRule { approximated, walked };

struct ImportSettings {
    /// Name of the camera, or its number from 1; empty for the first.
    std::string camera{};
    /// Name of the variant of materials (KHR_materials_variants); empty for none.
    std::string variant{};
    GlassRule glass = GlassRule::automatic;
    /// Absent: nit, but watt for files that Blender's exporter wrote.
    std::optional<EmissionUnit> emission_unit{};
    double frame_time = 0;  // of animations, seconds
    /// Of OBJ, STL and PLY, which do not say: absent for the usual one of the format.
    std::optional<UpAxis> up{};
    std::optional<double> metres_per_unit{};
    /// Name of the material of parts that have none, as in the table of named materials.
    std::string material{};
    bool ground = true;  // under OBJ, STL and PLY
    SubsurfaceRule subsurface = SubsurfaceRule::approximated;
};

}  // namespace sunfleck::engine

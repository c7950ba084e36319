// Reader of MTL files: the materials of OBJ.
//
// Source: Wavefront, Material Library File, version 4.2; Exocortex, PBR extension (2014): Pr, Pm,
// Pc, Pcr, Ps, norm.
#pragma once

#include "math/vector.h"
#include "sunfleck/error.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// A picture of a statement, with its options.
struct MtlMap {
    std::string file;  // as written
    SourceLocation where{};
    Vec2d offset{0, 0};  // -o: added to (u, v)
    Vec2d scale{1, 1};   // -s: factor of (u, v)
    bool clamps = false;
    double bump = 1;   // -bm
    char channel = 0;  // -imfchan: r g b m l z; 0 for the usual one
};

/// Words for colours, numbers and pictures, in small letters.
using MtlColours = std::map<std::string, Vec3d, std::less<>>;   // ka kd ks ke tf
using MtlNumbers = std::map<std::string, double, std::less<>>;  // ns ni d tr illum pr pm pc ...
using MtlMaps = std::map<std::string, MtlMap, std::less<>>;     // map_kd map_bump norm ...

struct MtlMaterial {
    std::string name;
    SourceLocation where{};
    MtlColours colours{};  // linear, not negative
    MtlNumbers numbers{};  // finite
    MtlMaps maps{};

    std::optional<double> number(std::string_view word) const;
    std::optional<Vec3d> colour(std::string_view word) const;
    /// Returns the map of a word, or null.
    const MtlMap* map(std::string_view word) const;
};

struct MtlRemark {
    SourceLocation where{};
    std::string text;
};

struct MtlLibrary {
    std::vector<MtlMaterial> materials;  // in order; the first of a name counts
    std::vector<MtlRemark> remarks;      // what was left out
    bool is_of_blender = false;          // its first comment says so
};

/// @param name  file name for errors.
/// @throws Error  with line and column, for numbers that cannot be read and files that are no MTL.
MtlLibrary parse_mtl(std::string_view bytes, const std::string& name);

}  // namespace sunfleck::engine

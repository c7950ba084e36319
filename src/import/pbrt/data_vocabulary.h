// The rows of vocabulary() for words without a converter: tables of docs/reference/scenes.md.
#pragma once

#include "import/pbrt/vocabulary_row.h"

#include <array>

namespace sunfleck::engine {

inline constexpr auto kDirectiveWords = std::to_array<WordRow>({
    {"Directive", "Identity Translate Scale Rotate LookAt Transform ConcatTransform", kExact,
     "matrices in double; a matrix without an inverse is an error"},
    {"Directive", "CoordinateSystem CoordSysTransform", kExact,
     "with `\"camera\"` and `\"world\"`; an unknown name leaves the matrix as it is, with a "
     "warning"},
    {"Directive", "ActiveTransform TransformTimes", kApproximated,
     "motion is not simulated: things stand where they are in the middle of the exposure "
     "(`shutteropen`, `shutterclose`, `TransformTimes`), with a warning where something moves"},
    {"Directive", "ReverseOrientation", kExact,
     "turns the normal side. A matrix that mirrors turns it, too, for spheres, disks, cylinders "
     "and "
     "curves that do not emit, and not for meshes and patches, as in pbrt-v4: a sphere that is "
     "mirrored and reversed has it outside again"},
    {"Directive", "AttributeBegin AttributeEnd TransformBegin TransformEnd", kExact,
     "save and bring back the whole graphics state, both of them, as in pbrt-v4"},
    {"Directive", "Attribute", kExact,
     "defaults of `\"shape\"`, `\"light\"`, `\"material\"`, `\"medium\"`, `\"texture\"` until the "
     "block "
     "ends"},
    {"Directive", "ObjectBegin ObjectEnd ObjectInstance", kExact,
     "true instances; an instance may stand before its object; none within an object; area lights "
     "in "
     "objects are ignored with a warning, as in pbrt-v4"},
    {"Directive", "MediumInterface", kExact,
     "the media inside (where the normal points away from) and outside of the shapes that follow; "
     "outside is also that of the `Camera` and of lights that follow. A surface with one medium on "
     "both sides changes nothing (pbrt-v4). Surfaces that let no light through part no media: "
     "paths keep theirs. Where a closed shape's normals point into it (ReverseOrientation, or "
     "triangles wound so) and its media do not agree with those around it, the two are "
     "exchanged, with a warning. A camera or light for which no medium is named stands in the "
     "one through which it is seen, with a warning; what names a medium decides. Other "
     "surfaces that do not agree are warned of, such as open ones, around whose edge rays go "
     "from one medium into the other"},
    {"Directive", "MakeNamedMedium", kExact, "see Media"},
    {"Directive", "Material MakeNamedMaterial NamedMaterial", kExact,
     "see Materials; a named one may be made after the shapes that use it"},
    {"Directive", "Texture Shape LightSource AreaLightSource", kExact, "see below"},
    {"Directive", "Camera Film PixelFilter Integrator Sampler", kExact,
     "see below; the last one counts"},
    {"Directive", "WorldBegin", kExact, "ends what is before the world"},
    {"Directive", "Include Import", kExact, "see above"},
    {"Directive", "ColorSpace", kExact,
     "`\"srgb\"`, `\"dci-p3\"`, `\"rec2020\"`, `\"aces2065-1\"`, for the rgb parameters to come, "
     "until the "
     "block ends: brought to sRGB (of lights as they look, of surfaces so that white stays white), "
     "what "
     "is beyond it cut off with a warning; a light without a colour in `\"aces2065-1\"` is ACES "
     "D60"},
    {"Directive", "Option", kIgnored,
     "`disablepixeljitter`, `disablewavelengthjitter`, `forcediffuse` and `seed` are ignored with "
     "a "
     "warning; pbrt-v4's others have no say in our pictures; unknown ones get a warning, too"},
    {"Directive", "Accelerator", kExact, "ours is Embree's tree, whatever is asked for"},
});

inline constexpr auto kFilmWords = std::to_array<WordRow>({
    {"Film", "rgb", kExact,
     "`xresolution` 1280, `yresolution` 720, `cropwindow`, `pixelbounds`, `filename`, `iso`, "
     "`whitebalance`, `sensor`"},
    {"Film", "gbuffer", kApproximated, "as `\"rgb\"`; `--aovs` asks for features"},
    {"Film", "spectral", kApproximated, "as `\"rgb\"`"},
});

inline constexpr auto kMethodWords = std::to_array<WordRow>({
    {"Integrator", "sppm", kApproximated,
     "gives `maxdepth` (64 where neither it nor `--max-depth` is given; pbrt-v4's is 5); `radius` "
     "and `photonsperiteration` are ignored with a warning: both are chosen by the program, or "
     "by `--radius` and `--photons-per-pass`"},
    {"Integrator", "any other", kApproximated,
     "gives `maxdepth`, as `\"sppm\"` does; a warning says that photon mapping renders the scene "
     "all the same, unless the command line says otherwise"},
    {"Sampler", "any", kIgnored,
     "where a render ends is said by the command line ([render.md](render.md)), not by "
     "`pixelsamples`"},
});

inline constexpr auto kAreaLightWords = std::to_array<WordRow>({
    {"AreaLightSource", "diffuse", kExact, "`L` or `filename`, `twosided`, `scale`, `power`"},
});

inline constexpr auto kMediumWords = std::to_array<WordRow>({
    {"MakeNamedMedium", "homogeneous", kExact,
     "`sigma_a` (1) and `sigma_s` (1) per unit of the world's length, `scale` (1), or a "
     "`preset`; `g` (0) of Henyey and Greenstein. `Le` and `Lescale` (1): the radiance of it "
     "where it is thick; a spectrum is divided by its luminance, rgb is not (pbrt-v4)"},
    {"MakeNamedMedium", "uniformgrid", kExact,
     "as `homogeneous`, times `density`: `nx`, `ny`, `nz` (1) values, x first, in the box from"
     " `p0` (0 0 0) to `p1` (1 1 1) of the current matrix. `Lescale` is one number, or a value"
     " a voxel; in place of `Le` may stand a `temperature` a voxel: less `temperatureoffset` "
     "(0; or `temperaturecutoff`), times `temperaturescale` (1), in kelvin. Up to 100 K "
     "nothing glows. `Le` is not less at the border of the box, as it is in pbrt-v4 where "
     "`Lescale` is not given"},
    {"MakeNamedMedium", "rgbgrid", kApproximated,
     "`sigma_a`, `sigma_s` (1 each where the other is given), `Le` with `Lescale`: a colour a "
     "voxel, as `uniformgrid`. The density and what it emits vary by voxel, the colours are "
     "their means"},
    {"MakeNamedMedium", "cloud", kExact,
     "as `homogeneous`, times noise by `density` (1), `wispiness` (1) and `frequency` (5) in the "
     "box from `p0` (0 0 0) to `p1` (1 1 1): sampled once, at 161 points an axis or fewer"},
    {"MakeNamedMedium", "nanovdb", kExact,
     "as `homogeneous`, times the grid `gridname` (`density`) of the file `filename`: floats, "
     "NanoVDB's format 32, packed by zip or not at all. It glows by the grid `temperaturename`"
     " (`temperature`), if the file has it, and `Lescale`, as `uniformgrid`"},
});

}  // namespace sunfleck::engine

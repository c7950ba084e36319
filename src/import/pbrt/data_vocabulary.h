// The rows of vocabulary(): what docs/reference/scenes.md says of each word.
#pragma once

#include "import/pbrt/vocabulary_row.h"

#include <array>

namespace sunfleck::engine {

inline constexpr auto kExact = Treatment::exact;
inline constexpr auto kApproximated = Treatment::approximated;
inline constexpr auto kIgnored = Treatment::ignored;
inline constexpr auto kRefused = Treatment::refused;

inline constexpr auto kVocabulary = std::to_array<WordRow>({
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

    {"Camera", "perspective", kExact,
     "`fov` (of the shorter axis, 90), `frameaspectratio`, `screenwindow`, `lensradius`, "
     "`focaldistance`, `shutteropen`, `shutterclose`"},
    {"Camera", "orthographic", kExact,
     "the same but for `fov`. With a lens each film point is seen through a lens around itself "
     "(pbrt-v4 puts every lens at the camera's origin)"},
    {"Camera", "spherical", kExact,
     "`mapping` `\"equalarea\"` (the default) or `\"equirectangular\"`; the camera's y axis is up"},
    {"Camera", "realistic", kRefused, "lens files are not read; the message names what to use"},

    {"Film", "rgb", kExact,
     "`xresolution` 1280, `yresolution` 720, `cropwindow`, `pixelbounds`, `filename`, `iso`, "
     "`whitebalance`, `sensor`"},
    {"Film", "gbuffer", kApproximated, "as `\"rgb\"`; `--aovs` asks for features"},
    {"Film", "spectral", kApproximated, "as `\"rgb\"`"},

    {"PixelFilter", "box", kExact, "radius 0.5"},
    {"PixelFilter", "triangle", kExact, "radius 2"},
    {"PixelFilter", "gaussian", kExact, "radius 1.5, `sigma` 0.5; the default"},
    {"PixelFilter", "mitchell", kExact, "radius 2, `B` and `C` 1/3"},
    {"PixelFilter", "sinc", kExact, "radius 4, `tau` 3"},

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

    {"Shape", "trianglemesh", kExact, "`P`, `indices`, `N`, `uv`, `S`"},
    {"Shape", "plymesh", kExact,
     "triangles, normals, uv; ASCII and both binary forms; quads become two triangles each, where "
     "pbrt-v4 has a bilinear patch: one that is not flat has a crease, one without uv has others "
     "in half of it, and `power` counts both; planar convex faces of more corners are cut "
     "likewise, with a warning, and others refused; left out, with a warning: faces of fewer than "
     "three corners, vertices of no face whose numbers are not finite, normals that are no "
     "numbers, texture coordinates of faces (`texcoord`); texture coordinates that are no numbers "
     "are (0, 0), with a warning; strips of triangles (`tristrips`) are refused; its "
     "`displacement` is ignored with a warning"},
    {"Shape", "sphere", kExact, "`radius zmin zmax phimax`; met exactly, in double"},
    {"Shape", "disk", kExact, "`height radius innerradius phimax`"},
    {"Shape", "cylinder", kExact, "`radius zmin zmax phimax`"},
    {"Shape", "bilinearmesh", kExact,
     "`P`, `indices`, `N`, `uv`; each patch bilinear, met exactly"},
    {"Shape", "loopsubdiv", kExact,
     "`P`, `indices`, `levels` 3; becomes triangles on the limit surface, with its normals"},
    {"Shape", "curve", kExact,
     "`P`, `basis` `\"bezier\"` or `\"bspline\"`, `degree` 2 or 3, `type`, `width`, `width0`, "
     "`width1`, "
     "`N`; `splitdepth` is ignored; see below"},

    {"Material", "diffuse", kExact, "`reflectance` (0.5)"},
    {"Material", "dielectric", kExact, "`eta` (1.5; a number or a spectrum), roughness"},
    {"Material", "thindielectric", kExact, "`eta`"},
    {"Material", "conductor", kExact, "`eta` and `k` (copper), or `reflectance`; roughness"},
    {"Material", "interface", kExact, "nothing is there; also `\"none\"` and `\"\"`"},
    {"Material", "none", kExact, "as `\"interface\"`"},
    {"Material", "", kExact, "as `\"interface\"`"},
    {"Material", "coateddiffuse", kExact,
     "`reflectance`, `eta` (1.5), roughness, `thickness` (0.01): in closed form, all reflections "
     "between "
     "coat and base with them (pbrt-v4 walks at random). `albedo`, `g`: ignored, with a warning if "
     "the "
     "coat would scatter; a texture of its roughness counts as its mean, a spectrum of its "
     "index as "
     "its mean, with warnings"},
    {"Material", "coatedconductor", kExact,
     "`conductor.eta`, `conductor.k` or `reflectance`, `conductor.roughness`; `interface.eta`, "
     "`interface.roughness`, `interface.thickness`: in closed form, exact where both are smooth, "
     "else "
     "without spreading of further inner reflections; the rest as for `coateddiffuse`"},
    {"Material", "mix", kExact,
     "`materials`, `amount` (0.5, a number or a texture): a ray meets one of them, by a hash of "
     "the "
     "place; with `interface` in it, the other part everywhere, with a warning"},
    {"Material", "diffusetransmission", kExact,
     "`reflectance`, `transmittance` (0.25 each), `scale`; where both add up to more than 1 they "
     "are "
     "scaled down"},
    {"Material", "hair", kApproximated,
     "`sigma_a`, `reflectance` or `color`, `eumelanin`, `pheomelanin` (1.3, 0), `eta` (1.55), "
     "`beta_n`: "
     "each fibre spreads evenly what it reflects, and through it what it lets through, in the "
     "shares "
     "that pbrt-v4's lobes have (of light from everywhere). On `\"cylinder\"` curves light goes "
     "through "
     "two walls"},
    {"Material", "subsurface", kApproximated,
     "`reflectance`, or `sigma_a` and `sigma_s` with `g`, or `name`; `eta` (1.33), roughness: "
     "diffuse "
     "under its surface, with the whole reflectance of pbrt-v4's beam diffusion; light comes out "
     "where "
     "it went in (`mfp` and `scale` are ignored)"},
    {"Material", "measured", kApproximated,
     "`filename`: metal of its mean reflectance and of the roughness of its facets, or diffuse "
     "where "
     "that is above 0.5"},

    {"Texture", "constant", kExact, "`value` (1)"},
    {"Texture", "scale", kExact, "`tex` (1), `scale` (1, float)"},
    {"Texture", "mix", kExact, "`tex1` (0), `tex2` (1), `amount` (0.5, float)"},
    {"Texture", "directionmix", kExact,
     "`tex1` (0), `tex2` (1), `dir` (0 1 0): `tex1` where the surface faces along it"},
    {"Texture", "checkerboard", kExact, "`tex1` (1), `tex2` (0), `dimension` (2 or 3)"},
    {"Texture", "dots", kExact, "`inside` (1), `outside` (0)"},
    {"Texture", "bilerp", kExact, "`v00` (0), `v01` (1), `v10` (0), `v11` (1)"},
    {"Texture", "imagemap", kExact,
     "`filename`, `wrap` (`repeat`, `black`, `clamp`, `octahedralsphere`), `filter`, `scale` (1), "
     "`invert` (false), `encoding` (`sRGB`, `linear`, `gamma 2.2`; of PNG alone)"},
    {"Texture", "fbm", kExact, "`octaves` (8), `roughness` (0.5); a float"},
    {"Texture", "wrinkled", kExact, "`octaves` (8), `roughness` (0.5); a float"},
    {"Texture", "windy", kExact, "a float"},
    {"Texture", "marble", kExact,
     "`octaves` (8), `roughness` (0.5), `scale` (1), `variation` (0.2); a spectrum"},
    {"Texture", "ptex", kApproximated, "0.5 everywhere"},

    {"LightSource", "point", kExact, "`I`, `from`, `scale`, `power`"},
    {"LightSource", "spot", kExact,
     "`I`, `from`, `to`, `coneangle`, `conedeltaangle`, `scale`, `power`"},
    {"LightSource", "distant", kExact, "`L`, `from`, `to`, `scale`, `illuminance`"},
    {"LightSource", "infinite", kExact, "`L` or `filename`, `portal`, `scale`, `illuminance`"},
    {"LightSource", "goniometric", kExact, "`I`, `filename`, `scale`, `power`"},
    {"LightSource", "projection", kExact, "`filename`, `fov`, `scale`, `power`"},
    {"AreaLightSource", "diffuse", kExact, "`L` or `filename`, `twosided`, `scale`, `power`"},

    {"MakeNamedMedium", "homogeneous", kExact,
     "`sigma_a` (1) per unit of the world's length, `scale` (1), or a `preset`: absorbed exactly, "
     "by "
     "wavelength, on every path. What such a medium scatters (`sigma_s`, 1) goes straight on, and "
     "`Le` "
     "is ignored, with a warning each"},
    {"MakeNamedMedium", "uniformgrid", kIgnored, "light passes unchanged"},
    {"MakeNamedMedium", "rgbgrid", kIgnored, "light passes unchanged"},
    {"MakeNamedMedium", "cloud", kIgnored, "light passes unchanged"},
    {"MakeNamedMedium", "nanovdb", kIgnored, "light passes unchanged"},
});

}  // namespace sunfleck::engine

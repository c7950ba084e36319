// What the scenes are made of. A value that is added here is used in make_scene.cpp and its parts.
#include "differential/features.h"
#include "sunfleck/error.h"

#include <algorithm>

namespace sunfleck::engine::differential {
namespace {

const std::vector<std::string> kAreaLights = {"area", "two-sided area", "area picture"};
const std::vector<std::string> kNearLights = {
    "point", "spot", "goniometric", "projection", "area", "two-sided area", "area picture"};
const std::vector<std::string> kOneColourLights = {"point",      "spot", "distant",       "sky",
                                                   "sky portal", "area", "two-sided area"};
const std::vector<std::string> kRoughMaterials = {"dielectric", "conductor", "coateddiffuse",
                                                  "coatedconductor"};
const std::vector<std::string> kColouredMaterials = {"diffuse", "dielectric", "conductor",
                                                     "coateddiffuse", "diffusetransmission"};
const std::vector<std::string> kBentMaterials = {"diffuse",         "dielectric",
                                                 "conductor",       "coateddiffuse",
                                                 "coatedconductor", "diffusetransmission"};

std::vector<Feature> light_features() {
    return {
        {"light",
         {"point", "spot", "distant", "goniometric", "projection", "sky", "sky picture",
          "sky portal", "area", "two-sided area", "area picture"},
         {}},
        {"lamp shape",
         {"disk", "sphere", "cylinder", "mesh", "bilinear"},
         {{"light", kAreaLights}}},
        {"emission",
         {"rgb", "blackbody", "named", "pairs", "power"},
         {{"light", kOneColourLights}}},
        {"second light", {"none", "lamp", "point", "sky"}, {}},
        {"room", {"open", "walls"}, {}},
        {"ceiling", {"none", "closed"}, {{"room", {"walls"}}, {"light", kNearLights}}},
        {"haze",
         {"none", "thin"},
         {{"light", kNearLights}, {"second light", {"none", "lamp", "point"}}}},
    };
}

std::vector<Feature> object_features() {
    return {
        {"shape",
         {"sphere", "cut sphere", "disk", "cylinder", "box", "shaded mesh", "ply", "bilinear",
          "loopsubdiv", "curve", "ribbon"},
         {}},
        {"material",
         {"diffuse", "dielectric", "thindielectric", "conductor", "coateddiffuse",
          "coatedconductor", "diffusetransmission", "rough mix", "mirror mix", "interface",
          "subsurface", "hair"},
         {}},
        {"roughness",
         {"smooth", "slight", "rough", "anisotropic", "texture", "not remapped"},
         {{"material", kRoughMaterials}}},
        {"colour",
         {"rgb", "pairs", "file", "texture", "other model"},
         {{"material", kColouredMaterials}}},
        {"bump", {"none", "displacement", "normal map"}, {{"material", kBentMaterials}}},
        {"alpha", {"none", "half", "mask", "floor half"}, {}},
        {"orientation", {"plain", "reversed"}, {}},
        {"transform", {"none", "rotated", "stretched", "mirrored", "matrix"}, {}},
        {"instances", {"none", "one", "two"}, {}},
        {"inner medium",
         {"none", "amber"},
         {{"shape", {"sphere", "box", "shaded mesh", "ply", "loopsubdiv"}},
          {"material", {"dielectric", "interface"}},
          {"alpha", {"none", "floor half"}}}},
        {"beside", {"nothing", "glass ball", "mirror ball", "diffuse ball"}, {}},
        {"floor",
         {"diffuse", "coateddiffuse", "conductor", "diffusetransmission", "mirror mix"},
         {}},
        {"floor texture",
         {"none", "checkerboard", "checkerboard 3D", "dots", "bilerp", "imagemap", "marble", "fbm",
          "wrinkled", "windy", "scale", "mix", "directionmix"},
         {{"floor", {"diffuse", "coateddiffuse", "diffusetransmission"}}}},
        {"mapping",
         {"uv", "spherical", "cylindrical", "planar"},
         {{"floor texture", {"checkerboard", "dots", "imagemap"}}}},
    };
}

std::vector<Feature> view_features() {
    return {
        {"camera",
         {"perspective", "lens", "orthographic", "screen window", "equal area", "equirectangular"},
         {}},
        {"film", {"plain", "crop", "exposure", "white balance", "sensor", "gbuffer"}, {}},
        {"filter", {"none", "box", "triangle", "gaussian", "mitchell", "sinc"}, {}},
        {"colour space", {"none", "rec2020", "dci-p3", "aces2065-1"}, {}},
        {"depth", {"64", "3", "6"}, {}},
        {"second witness", {"none", "uniform", "random", "direct photons", "bdpt"}, {}},
    };
}

void leave_out(std::vector<Feature>& features, const std::string& wish) {
    const std::size_t sign = wish.find('=');
    const std::string name = wish.substr(0, sign);
    const std::string value = sign == std::string::npos ? "" : wish.substr(sign + 1);
    for (Feature& feature : features)
        if (feature.name == name && feature.values.size() > 1 &&
            std::erase(feature.values, value) == 1)
            return;
    throw Error({"--leave-out"}, "cannot leave out \"" + wish + '"',
                "give FEATURE=VALUE of tools/differential/scene_features.cpp, not the last value");
}

}  // namespace

FeatureTable scene_features(const std::vector<std::string>& left_out) {
    std::vector<Feature> all = light_features();
    for (Feature& feature : object_features()) all.push_back(std::move(feature));
    for (Feature& feature : view_features()) all.push_back(std::move(feature));
    for (const std::string& wish : left_out) leave_out(all, wish);
    return FeatureTable(std::move(all));
}

}  // namespace sunfleck::engine::differential

// Small scenes for tests of the library.
#pragma once

#include <sunfleck/sunfleck.h>

#include <string>
#include <vector>

namespace sunfleck::testing_support {

/// A glass ball over a floor, lit by a small lamp, as a scene file.
inline const char* const kBall = R"(
LookAt 0 -6 4  0 0 0.6  0 0 1
Camera "perspective" "float fov" 35
Film "rgb" "integer xresolution" 24 "integer yresolution" 16
WorldBegin
MakeNamedMaterial "table" "string type" "diffuse" "rgb reflectance" [ .6 .5 .4 ]
MakeNamedMaterial "glass" "string type" "dielectric" "float eta" 1.5
NamedMaterial "table"
Shape "trianglemesh" "point3 P" [ -4 -4 0 4 -4 0 4 4 0 -4 4 0 ] "integer indices" [ 0 1 2 0 2 3 ]
AttributeBegin
Translate 0 0 1.2
NamedMaterial "glass"
Shape "sphere" "float radius" 1
AttributeEnd
AttributeBegin
NamedMaterial "table"
Translate -2 1 5
AreaLightSource "diffuse" "rgb L" [ 900 800 650 ]
Shape "sphere" "float radius" .1
AttributeEnd
)";

inline Scene ball() {
    return Scene::parse(kBall, "ball.pbrt");
}

/// Few photons, so that tests are quick.
inline Settings quick_settings() {
    return Settings().set("photons-per-pass", 4000).set("passes", 5);
}

inline std::vector<float> green(const Picture& picture) {
    const auto values = picture.channel("G");
    return {values.begin(), values.end()};
}

/// The picture of the limits of these settings.
inline std::vector<float> rendered(const Scene& scene, const Settings& settings,
                                   std::size_t threads = 0) {
    Renderer renderer(scene, settings, {threads, {}});
    renderer.run();
    return green(renderer.picture());
}

}  // namespace sunfleck::testing_support

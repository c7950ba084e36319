// Small scenes on which the reference integrators must agree.
#pragma once

#include "support/renders.h"

#include <ostream>

namespace sunfleck::engine::testing_support {

struct ReferenceScene {
    const char* name;
    std::string text;
    Integrator other = Integrator::path;  // what finds all its light
    int batches = 12;                     // of each integrator
    double tolerance = 0.01;
    bool by_chains = false;  // Metropolis light transport is tested, too

    friend void PrintTo(const ReferenceScene& scene, std::ostream* out) { *out << scene.name; }
};

inline std::string lamp_above(const std::string& radiance) {
    return "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [" + radiance + "]\n" +
           diffuse("0.1 0.1 0.1") + "ReverseOrientation\n" +
           quad("-.4 -.6 1.9  .4 -.6 1.9  .4 .2 1.9  -.4 .2 1.9") + "AttributeEnd\n";
}

/// A floor and two walls.
inline std::string corner() {
    return diffuse("0.6 0.5 0.4") + quad("-1 1 0  1 1 0  1 1 2  -1 1 2") +
           quad("-1 -1 0  1 -1 0  1 1 0  -1 1 0") + diffuse("0.6 0.1 0.1") +
           quad("-1 -1 0  -1 1 0  -1 1 2  -1 -1 2");
}

inline std::string metal_block() {
    return "Material \"conductor\" \"float roughness\" 0.3 \"bool remaproughness\" false\n" +
           box({0.2, 0, 0}, {0.9, 0.7, 0.6});
}

inline std::string glass_ball(const std::string& material) {
    return "AttributeBegin\nMaterial " + material +
           "\nTranslate 0 0 .5\nShape \"sphere\" \"float radius\" 0.35\nAttributeEnd\n";
}

inline std::string camera_with(const std::string& camera) {
    return "LookAt 0 -3 1  0 0 1  0 0 1\n" + camera + "\n" + film(16) + "WorldBegin\n";
}

inline std::vector<ReferenceScene> reference_scenes() {
    const std::string front = view("0 -3 1  0 0 .6  0 0 1", 34, 16);
    const std::string filtered =
        "LookAt 0 -3 1  0 0 .6  0 0 1\nCamera \"perspective\" \"float fov\" 30\n"
        "Film \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 16\n"
        "PixelFilter \"mitchell\" \"float xradius\" 2 \"float yradius\" 2\nWorldBegin\n";
    const std::string bent =
        diffuse("0.7 0.7 0.7") +
        "Shape \"trianglemesh\" \"point3 P\" [-1 -1 0  1 -1 0  1 1 0  -1 1 0] "
        "\"normal N\" [-.5 -.4 1  .4 -.5 1  .5 .4 1  -.4 .5 1] \"integer indices\" [0 1 2 0 2 3]\n";
    const std::string haze =
        "MakeNamedMedium \"haze\" \"string type\" \"homogeneous\" \"rgb sigma_s\" [0 0 0] "
        "\"rgb sigma_a\" [.3 .2 .1]\nMakeNamedMedium \"ink\" \"string type\" \"homogeneous\" \"rgb "
        "sigma_s\" [0 0 0] \"rgb sigma_a\" [1 3 5]\nMediumInterface \"haze\"\n";
    return {
        {"diffuse_room", front + corner() + lamp_above("10 9 7"), Integrator::path, 12, 0.01, true},
        {"metal", front + corner() + metal_block() + lamp_above("10 9 7")},
        {"wide_filter", filtered + corner() + metal_block() + lamp_above("10 9 7")},
        {"lens",
         camera_with("Camera \"perspective\" \"float fov\" 20 \"float lensradius\" 0.2 "
                     "\"float focaldistance\" 1.5") +
             corner() + metal_block() + lamp_above("10 9 7"),
         Integrator::path, 12, 0.01, true},
        {"in_parallel",
         camera_with("Camera \"orthographic\" \"float screenwindow\" [-.9 .9 -.9 .9]") + corner() +
             lamp_above("10 9 7")},
        {"all_directions",
         "LookAt 0 -.5 1  0 0 1  0 0 1\nCamera \"spherical\"\n" + film(16) + "WorldBegin\n" +
             corner() + lamp_above("10 9 7"),
         Integrator::path, 24, 0.025},
        {"bent_normals", view("0 -1.5 1.5  0 0 0  0 0 1", 40, 16) + bent +
                             quad("-1 1 0  1 1 0  1 1 2  -1 1 2") + lamp_above("10 9 7")},
        {"glass_ball", front + corner() + glass_ball("\"dielectric\"") + lamp_above("10 9 7"),
         Integrator::path, 24, 0.02},
        {"flint_ball",
         front + corner() + glass_ball("\"dielectric\" \"spectrum eta\" \"glass-F11\"") +
             lamp_above("10 9 7"),
         Integrator::path, 24, 0.02},
        {"rough_flint",
         front + corner() +
             glass_ball("\"dielectric\" \"spectrum eta\" \"glass-F11\" \"float roughness\" .3 "
                        "\"bool remaproughness\" false") +
             lamp_above("10 9 7"),
         Integrator::path, 24, 0.02, true},
        {"varnish", front + corner() +
                        glass_ball("\"coateddiffuse\" \"rgb reflectance\" [.7 .3 .2] \"float "
                                   "roughness\" 0") +
                        lamp_above("10 9 7")},
        {"leaf",
         front + corner() +
             "Material \"diffusetransmission\" \"rgb reflectance\" [.3 .3 .3] "
             "\"rgb transmittance\" [.5 .5 .2]\n" +
             quad("-.5 -.5 1  .5 -.5 1  .5 .5 1.2  -.5 .5 1.2") + lamp_above("10 9 7"),
         Integrator::path, 24, 0.015},
        {"unseen_lamp", front + corner() + metal_block() +
                            "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [30 30 20]\n" +
                            "Translate 0 -.2 1.5\nScale 1 1 -1\nShape \"disk\" \"float radius\" .3 "
                            "\"float alpha\" 0\nAttributeEnd\n"},
        // Looks at nothing but the light below the ball: light tracing finds all of that.
        {"sun_caustic",
         view("2 -1 1  .57 -.2 0  0 0 1", 22, 16) +
             "LightSource \"distant\" \"point3 from\" [-1 0 1.2]\n" + diffuse("0.7 0.7 0.7") +
             quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") +
             "Material \"dielectric\" \"spectrum eta\" \"glass-F11\"\nTranslate -.1 -.2 .8\n"
             "Shape \"sphere\" \"float radius\" 0.4\n",
         Integrator::light, 40, 0.06, true},
        {"point",
         front + "LightSource \"point\" \"point3 from\" [0 -.5 1.6] \"rgb I\" [3 3 2]\n" +
             corner() + metal_block(),
         Integrator::path, 12, 0.01, true},
        {"spot", front +
                     "LightSource \"spot\" \"point3 from\" [0 -.5 1.8] \"point3 to\" [0 .3 0] "
                     "\"rgb I\" [3 3 2] \"float coneangle\" 50\n" +
                     corner() + metal_block()},
        {"sun",
         front + "LightSource \"distant\" \"point3 from\" [1 -1 2]\n" + corner() + metal_block()},
        {"sky",
         front + "LightSource \"infinite\" \"rgb L\" [.5 .6 .8]\n" + corner() + metal_block(),
         Integrator::path, 12, 0.01, true},
        {"many_lights",
         front + "LightSource \"infinite\" \"rgb L\" [.1 .2 .3]\n" +
             "LightSource \"point\" \"point3 from\" [0 -.5 1.6] \"rgb I\" [1 1 1]\n" + corner() +
             metal_block() + lamp_above("3 3 3") +
             "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [5 2 1]\n" +
             "Translate -.5 .2 .3\nShape \"sphere\" \"float radius\" .15\n" + "AttributeEnd\n",
         Integrator::path, 12, 0.01},
        {"egg_lamp",
         front + corner() + "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [9 9 5]\n" +
             "Translate 0 .2 .9\nScale .3 .2 .5\nShape \"sphere\" \"float radius\" 1\n" +
             "AttributeEnd\n"},
        {"ink_and_haze", haze + front + corner() +
                             "AttributeBegin\nMaterial \"interface\"\nMediumInterface \"ink\" "
                             "\"haze\"\n" +
                             box({-.5, -.5, 0.3}, {0.4, 0.2, 0.8}) + "AttributeEnd\n" +
                             lamp_above("10 9 7")},
    };
}

}  // namespace sunfleck::engine::testing_support

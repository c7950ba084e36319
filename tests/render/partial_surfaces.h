// Scenes with surfaces that are there in part: by a fractional alpha, as one component of a mix, or
// where a texture says so. They are the floor of a white room below a shining ceiling, or lie below
// a ball of glass that throws a caustic.
#pragma once

#include "support/renders.h"

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace sunfleck::engine::testing_support {

/// A row of the table of equivalence.
struct PartialScene {
    std::string name;
    std::string text;
    bool has_mirror = false;  // or a smooth coat, in view: light tracing cannot bring what it shows
};

inline std::ostream& operator<<(std::ostream& out, const PartialScene& s) {
    return out << s.name;
}

namespace partial_surfaces {

inline constexpr int kSize = 60;

inline std::string quads(const std::vector<std::string>& corners,
                         const std::string& parameters = {}) {
    std::string all;
    for (const std::string& p : corners)
        all += "Shape \"trianglemesh\" " + parameters +
               " \"integer indices\" [0 1 2 0 2 3] \"point3 P\" [" + p + "]\n";
    return all;
}

/// Down from below the ceiling at most of the floor.
inline std::string down() {
    return view("0 -1.5 1.8  0 -.094 0  0 0 1", 44, kSize);
}

/// Four walls below a ceiling that shines. Half of the floor's light comes by way of the walls.
inline std::string white_room() {
    return "AttributeBegin\nMaterial \"diffuse\" \"rgb reflectance\" [.7 .7 .7]\n" +
           quads({"-1.6 -1.6 0  1.6 -1.6 0  1.6 -1.6 2.4  -1.6 -1.6 2.4",
                  "-1.6 1.6 0  1.6 1.6 0  1.6 1.6 2.4  -1.6 1.6 2.4",
                  "-1.6 -1.6 0  -1.6 1.6 0  -1.6 1.6 2.4  -1.6 -1.6 2.4",
                  "1.6 -1.6 0  1.6 1.6 0  1.6 1.6 2.4  1.6 -1.6 2.4"}) +
           "AreaLightSource \"diffuse\" \"rgb L\" [.3 .3 .3]\n" +
           quads({"-1.6 -1.6 2.4  -1.6 1.6 2.4  1.6 1.6 2.4  1.6 -1.6 2.4"}) + "AttributeEnd\n";
}

/// A ball of glass below a lamp that is as wide, and a view past both.
inline std::string caustic() {
    return view("0 -8.5 8.5  0 0 0  0 0 1", 9.5, kSize) +
           "AttributeBegin\nTranslate 0 0 2.7\nRotate 180 1 0 0\n"
           "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1]\n"
           "Shape \"disk\" \"float radius\" .45\nAttributeEnd\n"
           "AttributeBegin\nTranslate 0 0 2.15\nMaterial \"dielectric\" \"float eta\" 1.5\n"
           "Shape \"sphere\" \"float radius\" .5\nAttributeEnd\n";
}

/// Materials that mixes are made of.
inline std::string materials() {
    return R"(MakeNamedMaterial "white" "string type" "diffuse" "rgb reflectance" [.6 .6 .6]
MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [.6 .2 .1]
MakeNamedMaterial "mirror" "string type" "conductor" "rgb reflectance" [.8 .8 .8]
MakeNamedMaterial "glass" "string type" "dielectric" "float eta" 1.5
MakeNamedMaterial "pane" "string type" "thindielectric" "float eta" 1.5
MakeNamedMaterial "satin" "string type" "conductor" "float roughness" .5 "bool remaproughness" false
MakeNamedMaterial "varnish" "string type" "coateddiffuse" "rgb reflectance" [.6 .6 .6] "float roughness" 0
MakeNamedMaterial "lacquer" "string type" "coatedconductor" "float interface.roughness" 0 "float conductor.roughness" 0 "spectrum conductor.eta" "metal-Cu-eta" "spectrum conductor.k" "metal-Cu-k"
MakeNamedMaterial "leaf" "string type" "diffusetransmission" "rgb reflectance" [.3 .3 .3] "rgb transmittance" [.3 .3 .3]
)";
}

inline std::string mix(const std::string& name, const std::string& first, const std::string& second,
                       const std::string& amount) {
    return "MakeNamedMaterial \"" + name + "\" \"string type\" \"mix\" \"string materials\" [\"" +
           first + "\" \"" + second + "\"] " + amount + "\n";
}

inline std::string number(const std::string& value) {
    return "\"float amount\" " + value;
}

inline std::string checks(const std::string& name, const std::string& low,
                          const std::string& high) {
    return "Texture \"" + name +
           "\" \"float\" \"checkerboard\" \"float uscale\" 40 "
           "\"float vscale\" 40 \"float tex1\" " +
           low + " \"float tex2\" " + high + "\n";
}

/// A square of the floor's size. @param parameters  such as an alpha.
inline std::string sheet(double z, const std::string& parameters = {}) {
    const std::string h = ' ' + std::to_string(z) + ' ';
    return quads({"-1.6 -1.6" + h + "1.6 -1.6" + h + "1.6 1.6" + h + "-1.6 1.6" + h},
                 parameters + " \"point2 uv\" [0 0 1 0 1 1 0 1]");
}

inline std::string alpha(const std::string& value) {
    return "\"float alpha\" " + value;
}

inline std::string named(const std::string& material) {
    return "NamedMaterial \"" + material + "\"\n";
}

/// A closed room of that material, with a lamp that hangs in it.
inline std::string room(const std::string& material, const std::string& parameters = {}) {
    const std::string walls =
        quads({"-2 -2 -2  2 -2 -2  2 2 -2  -2 2 -2", "-2 -2 2  2 -2 2  2 2 2  -2 2 2",
               "-2 -2 -2  2 -2 -2  2 -2 2  -2 -2 2", "2 -2 -2  2 2 -2  2 2 2  2 -2 2",
               "-2 -2 -2  -2 2 -2  -2 2 2  -2 -2 2", "-2 2 -2  2 2 -2  2 2 2  -2 2 2"},
              parameters);
    return view("0 -.5 -.2  0 2 -1  0 0 1", 40, kSize) + materials() +
           "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [6 6 6]\nTranslate 0 0 1.6\n"
           "Rotate 180 1 0 0\nShape \"disk\" \"float radius\" .8\nAttributeEnd\n" +
           material + walls;
}

/// A floor of the material that is the mix of two.
inline std::string mixed_floor(const std::string& first, const std::string& second,
                               const std::string& amount, const std::string& parameters = {}) {
    return mix("m", first, second, amount) + named("m") + sheet(0, parameters);
}

inline PartialScene on_floor(const std::string& name, const std::string& statements,
                             bool has_mirror = false) {
    return {name, down() + materials() + white_room() + statements, has_mirror};
}

inline std::vector<PartialScene> caustics() {
    const auto below_a_ball = [](const std::string& floor) {
        return caustic() + materials() + floor;
    };
    return {{"alpha_in_a_caustic", below_a_ball(named("white") + sheet(0, alpha(".5")))},
            {"mix_in_a_caustic", below_a_ball(mixed_floor("white", "mirror", number(".5"))), true}};
}

inline std::vector<PartialScene> alphas() {
    std::vector<PartialScene> rows;
    for (const char* a : {"0.05", "0.25", "0.5", "0.75", "0.95"})
        rows.push_back(on_floor(std::string("alpha_") + a, named("white") + sheet(0, alpha(a))));
    rows.push_back(
        on_floor("alpha_of_a_disk",
                 named("white") + "Shape \"disk\" \"float radius\" 1.6 " + alpha(".5") + "\n"));
    rows.push_back(on_floor("alpha_under_an_instance",
                            "ObjectBegin \"o\"\n" + named("white") + sheet(0, alpha(".5")) +
                                "ObjectEnd\nAttributeBegin\nRotate 30 0 0 1\n"
                                "ObjectInstance \"o\"\nAttributeEnd\n"));
    rows.push_back(on_floor("alpha_behind_alpha", named("white") + sheet(0, alpha(".5")) +
                                                      named("red") + sheet(-.2, alpha(".5")) +
                                                      named("white") + sheet(-.4)));
    rows.push_back(on_floor(
        "alpha_of_an_emitter",
        named("white") + "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [.2 .1 .1]\n" +
            sheet(0, alpha(".5")) + "AttributeEnd\n" + sheet(-.4)));
    rows.push_back(on_floor("alpha_below_a_pane",
                            named("pane") + sheet(.4) + named("white") + sheet(0, alpha(".5")),
                            true));
    rows.push_back({"alpha_seen_in_a_mirror",
                    view("0 -.7 1.3  0 -1.6 .74  0 0 1", 24, kSize) + materials() + white_room() +
                        named("white") + sheet(0, alpha(".5")) + named("mirror") +
                        quads({"-1.6 -1.59 0  1.6 -1.59 0  1.6 -1.59 2.4  -1.6 -1.59 2.4"}),
                    true});
    rows.push_back({"alpha_of_a_room", room(named("white"), alpha(".5"))});
    return rows;
}

inline std::vector<PartialScene> mixes() {
    std::vector<PartialScene> rows;
    const std::vector<std::string> gather = {"white", "varnish", "leaf", "satin"};
    for (const std::string& first : gather)
        for (const char* second : {"mirror", "glass", "pane", "lacquer"})
            rows.push_back(
                on_floor(first + "_and_" + second, mixed_floor(first, second, number(".5")), true));
    for (std::size_t i = 0; i < gather.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            rows.push_back(on_floor(gather[i] + "_and_" + gather[j],
                                    mixed_floor(gather[i], gather[j], number(".5")),
                                    gather[i] == "varnish" || gather[j] == "varnish"));
    rows.push_back(on_floor("mirror_and_a_tenth_of_white",
                            mixed_floor("mirror", "white", number(".1")), true));
    rows.push_back(on_floor(
        "mix_of_a_mix",
        mix("n", "mirror", "white", number(".5")) + mixed_floor("n", "pane", number(".3")), true));
    rows.push_back(on_floor("mix_with_alpha",
                            mixed_floor("white", "mirror", number(".5"), alpha(".5")), true));
    rows.push_back({"room_of_half_mirrors",
                    room(mix("m", "white", "mirror", number(".5")) + named("m")), true});
    return rows;
}

/// Where a texture says how much is there.
inline std::vector<PartialScene> masks() {
    std::vector<PartialScene> rows;
    const std::string amount = "\"texture amount\" \"c\"";
    for (const auto& [name, low, high] :
         {std::array{"texture", ".2", ".8"}, std::array{"mask", "0", "1"}}) {
        const std::string c = checks("c", low, high);
        rows.push_back(on_floor(std::string("mix_by_") + name,
                                c + mixed_floor("white", "mirror", amount), true));
        rows.push_back(on_floor(std::string("alpha_by_") + name,
                                c + named("white") + sheet(0, "\"texture alpha\" \"c\"")));
    }
    rows.push_back(on_floor("roughness_by_mask",
                            checks("c", "0", ".5") +
                                "Material \"conductor\" \"texture roughness\" \"c\" "
                                "\"bool remaproughness\" false\n" +
                                sheet(0),
                            true));
    return rows;
}

}  // namespace partial_surfaces

inline std::vector<PartialScene> partial_scenes() {
    std::vector<PartialScene> all = partial_surfaces::alphas();
    for (auto&& rows :
         {partial_surfaces::mixes(), partial_surfaces::masks(), partial_surfaces::caustics()})
        all.insert(all.end(), rows.begin(), rows.end());
    return all;
}

}  // namespace sunfleck::engine::testing_support

// The lights of a scene.
#include "differential/scene_parts.h"

namespace sunfleck::engine::differential {
namespace {

/// Emission of a light whose colour is the parameter `name`, I or L.
std::vector<std::string> emission(Ingredients& scene, const std::string& name, double scale,
                                  const std::string& power) {
    const std::string_view kind = scene["emission"];
    const std::string factor = fmt::format(R"("float scale" {})", scene.number(scale, 2 * scale));
    if (kind == "blackbody")
        return {"\"blackbody " + name + "\" " + scene.number(2500, 8000), factor};
    if (kind == "named") return {"\"spectrum " + name + R"(" "stdillum-F2")", factor};
    if (kind == "pairs")
        return {"\"spectrum " + name + "\" [380 0.3 480 1 560 " + scene.number(0.2, 1) +
                    " 650 0.8 780 0.2]",
                factor};
    const std::string colour = "\"rgb " + name + "\" " + scene.triple(0.3, 1);
    if (kind == "power") return {colour, power};
    return {colour, factor};
}

std::string power(Ingredients& scene, const char* name, double low) {
    return fmt::format(R"("float {}" {})", name, scene.number(low, 2 * low));
}

Statement lamp_shape(Ingredients& scene) {
    const std::string_view kind = scene["lamp shape"];
    const std::string size = scene.number(0.3, 0.7);
    if (kind == "disk") return {"Rotate 180 1 0 0\n  Shape \"disk\" \"float radius\" " + size, {}};
    if (kind == "sphere") return {"Shape \"sphere\" \"float radius\" " + size, {}};
    if (kind == "cylinder")
        return {"Rotate 80 0 1 0\n  Shape \"cylinder\" \"float radius\" 0.2", {}};
    const std::string corners = fmt::format("-{0} -{0} 0  -{0} {0} 0  ", size);
    if (kind == "bilinear")
        return {R"(Shape "bilinearmesh" "integer indices" [0 1 2 3] "point3 P" [)" + corners +
                    fmt::format("{0} -{0} 0.1  {0} {0} 0]", size),
                {}};
    return quad(corners + fmt::format("{0} {0} 0  {0} -{0} 0", size));
}

Block area_light(Ingredients& scene) {
    Statement light{R"(AreaLightSource "diffuse")", {}};
    if (scene["light"] == "area picture")
        light.parameters = {R"("string filename" "files/picture.exr")",
                            R"("float scale" )" + scene.number(5, 12)};
    else
        light.parameters = emission(scene, "L", 8, power(scene, "power", 20));
    if (scene["light"] == "two-sided area")
        light.parameters.emplace_back(R"("bool twosided" true)");
    const std::string x = scene.number(-0.8, 0.8);
    const std::string y = scene.number(-0.8, 0.8);
    return {true, {{"Translate " + x + ' ' + y + " 3.2", {}}, light, lamp_shape(scene)}};
}

/// A light without a shape, and what turns it to the floor.
Block bare_light(Ingredients& scene) {
    const std::string kind(scene["light"]);
    const std::string x = scene.number(-1, 1);
    const std::string from = "[" + x + ' ' + scene.number(-1, 1) + " 3.2]";
    const std::string to = "\"point3 to\" " + scene.triple(-0.3, 0.3);
    const auto light = [](const std::string& name, std::vector<std::string> parameters) {
        return Statement{"LightSource \"" + name + '"', std::move(parameters)};
    };
    const std::string picture = R"("string filename" "files/picture.exr")";
    const std::string map = R"("string filename" "files/map.exr")";
    const std::string bright = R"("float scale" )" + scene.number(10, 30);
    const Statement above{"Translate 0.3 -0.2 3.2", {}};
    if (kind == "goniometric") return {true, {above, light(kind, {map, bright})}};
    if (kind == "projection")
        return {
            true,
            {above, {"Rotate 170 1 0 0", {}}, light(kind, {picture, bright, R"("float fov" 70)"})}};
    if (kind == "sky picture") return {true, {{"Rotate 40 0 0.3 1", {}}, light("infinite", {map})}};
    const bool is_far = kind == "distant" || kind.starts_with("sky");
    std::vector<std::string> all =
        emission(scene, is_far ? "L" : "I",
                 kind.starts_with("sky") ? 0.5
                 : is_far                ? 2
                                         : 12,
                 is_far ? power(scene, "illuminance", 2) : power(scene, "power", 120));
    if (!kind.starts_with("sky")) all.push_back("\"point3 from\" " + from);
    if (kind == "spot" || kind == "distant") all.push_back(to);
    if (kind == "spot") {
        all.push_back(R"("float coneangle" )" + scene.number(30, 60));
        all.push_back(R"("float conedeltaangle" )" + scene.number(3, 25));
    }
    if (kind == "sky portal")
        all.emplace_back(
            R"("point3 portal" [-1.5 -1.5 3.5  -1.5 1.5 3.5  1.5 1.5 3.5  1.5 -1.5 3.5])");
    return {true, {light(kind.starts_with("sky") ? "infinite" : kind, all)}};
}

}  // namespace

std::vector<Block> light_blocks(Ingredients& scene) {
    std::vector<Block> blocks = {scene["lamp shape"].empty() ? bare_light(scene)
                                                             : area_light(scene)};
    const std::string_view second = scene["second light"];
    if (second == "lamp")
        blocks.push_back({true,
                          {{"Translate -1.6 -0.6 2", {}},
                           {R"(AreaLightSource "diffuse")", {R"("rgb L" )" + scene.triple(2, 4)}},
                           {R"(Shape "sphere" "float radius" 0.25)", {}}}});
    if (second == "point")
        blocks.push_back({true,
                          {{R"(LightSource "point" "point3 from" [1.5 -1 2.2])",
                            {R"("rgb I" )" + scene.triple(1, 4)}}}});
    if (second == "sky")
        blocks.push_back(
            {true, {{R"(LightSource "infinite")", {R"("rgb L" )" + scene.triple(0.05, 0.3)}}}});
    return blocks;
}

}  // namespace sunfleck::engine::differential

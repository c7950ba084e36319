// Floor, walls and ceiling, and the ball beside the object.
#include "differential/scene_parts.h"

namespace sunfleck::engine::differential {
namespace {

std::string mapping(Ingredients& scene) {
    const std::string_view kind = scene["mapping"];
    if (kind == "uv") return R"("float uscale" 5 "float vscale" 4)";
    if (kind == "planar")
        return R"("string mapping" "planar" "vector3 v1" [1 0.2 0] "vector3 v2" [0 1.3 0])";
    return fmt::format(R"("string mapping" "{}")", kind);
}

/// The texture "floor", a spectrum, and what it is made of.
std::vector<Statement> floor_texture(Ingredients& scene) {
    const std::string_view kind = scene["floor texture"];
    const std::string one = scene.triple(0.5, 0.8);
    const std::string two = scene.triple(0.1, 0.4);
    const auto texture = [](const std::string& name, const std::string& model,
                            std::vector<std::string> parameters) {
        return Statement{fmt::format(R"(Texture "{}" {})", name, model), std::move(parameters)};
    };
    const std::string first = R"("rgb tex1" )" + one;
    const std::string second = R"("rgb tex2" )" + two;
    if (kind == "checkerboard")
        return {texture("floor", R"("spectrum" "checkerboard")", {mapping(scene), first, second})};
    if (kind == "checkerboard 3D")
        return {{"Scale 0.4 0.4 0.4", {}},
                texture("floor", R"("spectrum" "checkerboard")",
                        {R"("integer dimension" 3)", first, second}),
                {"Scale 2.5 2.5 2.5", {}}};
    if (kind == "dots")
        return {texture("floor", R"("spectrum" "dots")",
                        {mapping(scene), R"("rgb inside" )" + one, R"("rgb outside" )" + two})};
    if (kind == "bilerp")
        return {
            texture("floor", R"("spectrum" "bilerp")",
                    {R"("rgb v00" )" + one, R"("rgb v11" )" + two, R"("rgb v01" [0.2 0.5 0.3])"})};
    if (kind == "imagemap")
        return {texture("floor", R"("spectrum" "imagemap" "string filename" "files/picture.exr")",
                        {mapping(scene), R"("float scale" 0.7)"})};
    if (kind == "marble")
        return {texture("floor", R"("spectrum" "marble")", {R"("float scale" 1.5)"})};
    if (kind == "fbm" || kind == "wrinkled" || kind == "windy")
        return {
            texture("noise", fmt::format(R"("float" "{}")", kind), {}),
            texture("small", R"("float" "scale" "texture tex" "noise")", {R"("float scale" 0.4)"}),
            texture("floor", R"("spectrum" "mix" "texture amount" "small")", {first, second})};
    if (kind == "scale")
        return {texture("base", R"("spectrum" "checkerboard")", {first, second}),
                texture("floor", R"("spectrum" "scale" "texture tex" "base")",
                        {R"("float scale" )" + scene.number(0.3, 0.9)})};
    if (kind == "mix")
        return {texture("floor", R"("spectrum" "mix")",
                        {first, second, R"("float amount" )" + scene.number(0, 1)})};
    return {texture("floor", R"("spectrum" "directionmix")",
                    {first, second, R"("vector3 dir" [0.3 0.2 1])"})};
}

Block floor_block(Ingredients& scene) {
    Block block;
    const std::string_view kind = scene["floor"];
    std::string reflectance = R"("rgb reflectance" )" + scene.triple(0.3, 0.7);
    if (const std::string_view texture = scene["floor texture"];
        !texture.empty() && texture != "none") {
        block.statements = floor_texture(scene);
        reflectance = R"("texture reflectance" "floor")";
    }
    if (kind == "mirror mix") {
        block.statements.push_back(
            {R"(MakeNamedMaterial "paint" "string type" "diffuse")", {reflectance}});
        block.statements.push_back({R"(MakeNamedMaterial "mirror" "string type" "conductor")", {}});
        block.statements.push_back({R"(Material "mix" "string materials" ["paint" "mirror"])",
                                    {R"("float amount" )" + scene.number(0.2, 0.8)}});
    } else if (kind == "conductor") {
        block.statements.push_back(
            {R"(Material "conductor")", {R"("float roughness" )" + scene.number(0.1, 0.4)}});
    } else {
        block.statements.push_back({fmt::format("Material \"{}\"", kind), {reflectance}});
    }
    Statement floor = quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0");
    if (scene["alpha"] == "floor half")
        floor.parameters.push_back(R"("float alpha" )" + scene.number(0.3, 0.9));
    block.statements.push_back(floor);
    return block;
}

Block wall(Ingredients& scene, const std::string& corners) {
    return {true,
            {{R"(Material "diffuse")", {R"("rgb reflectance" )" + scene.triple(0.3, 0.7)}},
             quad(corners)}};
}

}  // namespace

Statement quad(const std::string& corners) {
    return {R"(Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point3 P" [)" + corners + ']',
            {R"("point2 uv" [0 0  1 0  1 1  0 1])"}};
}

std::vector<Block> surroundings(Ingredients& scene) {
    std::vector<Block> blocks = {floor_block(scene)};
    if (scene["room"] == "walls")
        for (const char* corners :
             {"-3 3 0  3 3 0  3 3 4  -3 3 4", "-3 -3 0  -3 3 0  -3 3 4  -3 -3 4",
              "3 3 0  3 -3 0  3 -3 4  3 3 4", "3 -3 0  -3 -3 0  -3 -3 4  3 -3 4"})
            blocks.push_back(wall(scene, corners));
    if (scene["ceiling"] == "closed")
        blocks.push_back(wall(scene, "-3 3 4  3 3 4  3 -3 4  -3 -3 4"));
    const std::string_view beside = scene["beside"];
    if (beside == "nothing") return blocks;
    Statement material{R"(Material "dielectric")", {R"("float eta" )" + scene.number(1.3, 1.8)}};
    if (beside == "mirror ball") material = {R"(Material "conductor")", {}};
    if (beside == "diffuse ball")
        material = {R"(Material "diffuse")", {R"("rgb reflectance" )" + scene.triple(0.2, 0.8)}};
    blocks.push_back(
        {true,
         {{"Translate 0.9 -0.3 0.5", {}}, material, {R"(Shape "sphere" "float radius" 0.5)", {}}}});
    return blocks;
}

}  // namespace sunfleck::engine::differential

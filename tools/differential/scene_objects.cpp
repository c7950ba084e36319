// The object: its material, its place, its instances.
#include "differential/scene_parts.h"

namespace sunfleck::engine::differential {
namespace {

using Statements = std::vector<Statement>;

/// Adds what the material's colour takes: parameters, and the texture that they name.
void add_colour(Ingredients& scene, const std::string& kind, Statements& before,
                std::vector<std::string>& parameters) {
    const std::string_view colour = scene["colour"];
    const std::string reflectance = R"("rgb reflectance" )" + scene.triple(0.2, 0.8);
    if (kind == "dielectric") {
        if (colour == "pairs")
            parameters.emplace_back(R"("spectrum eta" [400 1.6 700 1.5])");
        else if (colour == "file")
            parameters.emplace_back(R"("spectrum eta" "glass-F11")");
        else
            parameters.push_back(R"("float eta" )" + scene.number(1.2, 2));
    } else if (colour == "texture") {
        before.push_back({R"(Texture "paint" "spectrum" "checkerboard")",
                          {R"("rgb tex1" )" + scene.triple(0.5, 0.9),
                           R"("rgb tex2" )" + scene.triple(0.1, 0.4)}});
        parameters.emplace_back(R"("texture reflectance" "paint")");
    } else if (colour == "pairs") {
        parameters.emplace_back(R"("spectrum reflectance" [360 0.2 500 0.7 600 0.4 830 0.8])");
    } else if (colour == "file") {
        parameters.emplace_back(R"("spectrum reflectance" "files/green.spd")");
    } else if (kind == "conductor" && colour == "other model") {
        parameters.emplace_back(R"("spectrum eta" "metal-Au-eta" "spectrum k" "metal-Au-k")");
    } else {
        parameters.push_back(reflectance);
    }
    if (kind == "diffusetransmission")
        parameters.push_back(R"("rgb transmittance" )" + scene.triple(0.05, 0.3));
}

void add_roughness(Ingredients& scene, const std::string& prefix, Statements& before,
                   std::vector<std::string>& parameters) {
    const std::string_view kind = scene["roughness"];
    const auto one = [&](const std::string& name, const std::string& value) {
        parameters.push_back(fmt::format(R"("float {}{}" {})", prefix, name, value));
    };
    if (kind == "smooth") one("roughness", "0");
    if (kind == "slight") one("roughness", scene.number(0.01, 0.03));
    if (kind == "rough") one("roughness", scene.number(0.15, 0.6));
    if (kind == "anisotropic") {
        one("uroughness", scene.number(0.05, 0.15));
        one("vroughness", scene.number(0.2, 0.6));
    }
    if (kind == "texture") {
        before.push_back({R"(Texture "rough" "float" "checkerboard")",
                          {R"("float tex1" 0.4)", R"("float tex2" )" + scene.number(0.1, 0.2)}});
        parameters.push_back("\"texture " + prefix + R"(roughness" "rough")");
    }
    if (kind == "not remapped") {
        one("roughness", scene.number(0.2, 0.5));
        parameters.emplace_back(R"("bool remaproughness" false)");
    }
}

void add_bump(const Ingredients& scene, Statements& before, std::vector<std::string>& parameters) {
    if (scene["bump"] == "normal map")
        parameters.emplace_back(R"("string normalmap" "files/normals.exr")");
    if (scene["bump"] != "displacement") return;
    before.push_back({R"(Texture "waves" "float" "fbm")", {}});
    before.push_back(
        {R"(Texture "low waves" "float" "scale" "texture tex" "waves" "float scale" 0.05)", {}});
    parameters.emplace_back(R"("texture displacement" "low waves")");
}

Statements material(Ingredients& scene) {
    const std::string kind(scene["material"]);
    Statements all;
    if (kind.ends_with("mix")) {
        all = {{R"(MakeNamedMaterial "first" "string type" "diffuse")",
                {R"("rgb reflectance" )" + scene.triple(0.2, 0.8)}},
               {R"(MakeNamedMaterial "second" "string type" "conductor")",
                {kind == "rough mix" ? R"("float roughness" 0.3)" : R"("float roughness" 0)"}},
               {R"(Material "mix" "string materials" ["first" "second"])",
                {R"("float amount" )" + scene.number(0.2, 0.8)}}};
        return all;
    }
    std::vector<std::string> parameters;
    if (!scene["colour"].empty()) add_colour(scene, kind, all, parameters);
    if (!scene["roughness"].empty())
        add_roughness(scene, kind == "coatedconductor" ? "interface." : "", all, parameters);
    if (kind == "coatedconductor")
        parameters.push_back(R"("float conductor.roughness" )" + scene.number(0, 0.3));
    add_bump(scene, all, parameters);
    if (kind == "thindielectric") parameters.push_back(R"("float eta" )" + scene.number(1.2, 2));
    if (kind == "hair") parameters.push_back(R"("rgb color" )" + scene.triple(0.3, 0.8));
    if (kind == "subsurface")
        parameters.push_back(R"("rgb reflectance" )" + scene.triple(0.3, 0.8));
    all.push_back({"Material \"" + kind + '"', parameters});
    return all;
}

Statements transform(Ingredients& scene) {
    const std::string_view kind = scene["transform"];
    if (kind == "rotated") return {{"Rotate " + scene.number(20, 160) + " 0.3 0.2 1", {}}};
    if (kind == "stretched") return {{"Scale 1.2 0.7 " + scene.number(0.8, 1.1), {}}};
    if (kind == "mirrored") return {{"Scale -1 1 1", {}}};
    if (kind == "matrix")
        return {{"ConcatTransform [0.9 0.2 0 0  -0.1 1 0.1 0  0.1 0 0.8 0  0 0 0.05 1]", {}}};
    return {};
}

}  // namespace

std::vector<Block> object_blocks(Ingredients& scene) {
    const std::string x = scene.number(-0.6, -0.2);
    const std::string place = "Translate " + x + ' ' + scene.number(0, 0.5) + " 0.8";
    Statements object;
    if (scene["inner medium"] == "amber")
        object.push_back({scene["haze"] == "thin" ? R"(MediumInterface "amber" "haze")"
                                                  : R"(MediumInterface "amber" "")",
                          {}});
    for (Statement& statement : transform(scene)) object.push_back(std::move(statement));
    if (scene["orientation"] == "reversed") object.push_back({"ReverseOrientation", {}});
    for (Statement& statement : material(scene)) object.push_back(std::move(statement));
    Statement shape = shape_statement(scene);
    if (scene["alpha"] == "half")
        shape.parameters.push_back(R"("float alpha" )" + scene.number(0.2, 0.8));
    if (scene["alpha"] == "mask") {
        object.push_back(
            {R"(Texture "mask" "float" "checkerboard")", {R"("float uscale" 4 "float vscale" 4)"}});
        shape.parameters.emplace_back(R"("texture alpha" "mask")");
    }
    object.push_back(shape);
    if (scene["instances"] == "none") {
        object.insert(object.begin(), {place, {}});
        return {{true, object}};
    }
    object.insert(object.begin(), {"ObjectBegin \"thing\"", {}});
    object.push_back({"ObjectEnd", {}});
    std::vector<Block> blocks = {{true, object},
                                 {true, {{place, {}}, {"ObjectInstance \"thing\"", {}}}}};
    if (scene["instances"] == "two")
        blocks.push_back({true,
                          {{"Translate 0.9 1.2 0.8\n  Rotate 70 0 0.2 1\n  Scale 0.7 0.7 0.9", {}},
                           {"ObjectInstance \"thing\"", {}}}});
    return blocks;
}

}  // namespace sunfleck::engine::differential

// Camera, film, filter and depth of a scene.
#include "differential/scene_parts.h"

namespace sunfleck::engine::differential {
namespace {

Statement camera(Ingredients& scene) {
    const std::string_view kind = scene["camera"];
    if (kind == "orthographic")
        return {R"(Camera "orthographic")", {R"("float screenwindow" [-1.9 1.9 -1.9 1.9])"}};
    if (kind == "equal area") return {R"(Camera "spherical")", {}};
    if (kind == "equirectangular")
        return {R"(Camera "spherical")", {R"("string mapping" "equirectangular")"}};
    Statement statement{R"(Camera "perspective")", {R"("float fov" )" + scene.number(40, 60)}};
    if (kind == "lens") {
        statement.parameters.push_back(R"("float lensradius" )" + scene.number(0.03, 0.15));
        statement.parameters.push_back(R"("float focaldistance" )" + scene.number(2, 4));
    }
    if (kind == "screen window")
        statement.parameters.emplace_back(R"("float screenwindow" [-1.1 0.7 -0.8 0.9])");
    return statement;
}

Statement film(Ingredients& scene) {
    const std::string_view kind = scene["film"];
    Statement statement{kind == "gbuffer" ? R"(Film "gbuffer")" : R"(Film "rgb")", {}};
    // The size is part of the head, so that no smaller scene is a larger picture.
    const int width = scene.toss() ? 32 : 48;
    const int height = scene.toss() ? 32 : 40;
    statement.head +=
        fmt::format(R"( "integer xresolution" {} "integer yresolution" {})", width, height);
    if (kind == "crop") statement.parameters.emplace_back(R"("float cropwindow" [0.1 0.9 0.2 1])");
    if (kind == "exposure")
        statement.parameters.push_back(R"("float iso" )" + scene.number(60, 400));
    if (kind == "white balance")
        statement.parameters.push_back(R"("float whitebalance" )" + scene.number(3000, 9000));
    if (kind == "sensor") statement.parameters.emplace_back(R"("string sensor" "canon_eos_5d")");
    return statement;
}

}  // namespace

Block view_block(Ingredients& scene) {
    Block block{false, {}};
    const bool has_haze = scene["haze"] == "thin";
    if (has_haze || scene["inner medium"] == "amber")
        block.statements = {
            {R"(MakeNamedMedium "amber" "string type" "homogeneous")",
             {R"("rgb sigma_s" [0 0 0])", R"("rgb sigma_a" )" + scene.triple(0.1, 2)}},
            {R"(MakeNamedMedium "haze" "string type" "homogeneous")",
             {R"("rgb sigma_s" [0 0 0])", R"("rgb sigma_a" )" + scene.triple(0.02, 0.2)}}};
    if (has_haze) block.statements.push_back({R"(MediumInterface "" "haze")", {}});
    const std::string x = scene.number(-0.8, 0.8);
    const std::string z = scene.number(1.4, 2.2);
    block.statements.push_back({"LookAt " + x + " -2.9 " + z + "  0 0 0.55  0 0 1", {}, true});
    block.statements.push_back(camera(scene));
    block.statements.push_back(film(scene));
    block.statements.back().is_kept = true;
    if (scene["filter"] != "none")
        block.statements.push_back({fmt::format("PixelFilter \"{}\"", scene["filter"]), {}});
    if (scene["depth"] != "64")
        block.statements.push_back(
            {R"(Integrator "sppm")", {fmt::format(R"("integer maxdepth" {})", scene["depth"])}});
    return block;
}

}  // namespace sunfleck::engine::differential

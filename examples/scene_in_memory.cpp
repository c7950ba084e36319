// Makes a scene by calls: a glass ball on a table under a small lamp, and its caustic.
// scene_in_memory PICTURE.exr
#include <sunfleck/sunfleck.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iostream>

namespace {

sunfleck::Scene ball_on_table() {
    using sunfleck::Transform;
    sunfleck::SceneBuilder builder;
    builder.camera("perspective", {{"float fov", 35}},
                   Transform::look_at({0, -6, 4}, {0, 0, 0.6}, {0, 0, 1}));
    builder.film(160, 120);

    builder.texture("squares", "spectrum", "checkerboard",
                    {{"float uscale", 8},
                     {"float vscale", 8},
                     {"rgb tex1", {0.7, 0.65, 0.6}},
                     {"rgb tex2", {0.35, 0.2, 0.15}}});
    builder.material("table", "diffuse", {{"texture reflectance", "squares"}});
    builder.material("glass", "dielectric", {{"spectrum eta", "glass-BK7"}});

    const std::array<float, 12> corners = {-4, -4, 0, 4, -4, 0, 4, 4, 0, -4, 4, 0};
    const std::array<float, 8> uvs = {0, 0, 1, 0, 1, 1, 0, 1};
    const std::array<std::uint32_t, 6> triangles = {0, 1, 2, 0, 2, 3};
    builder.mesh({.positions = corners, .triangles = triangles, .uvs = uvs}, {.material = "table"});
    builder.shape("sphere", {{"float radius", 1}},
                  {.material = "glass", .to_world = Transform::translate({0, 0, 1.2})});
    builder.shape("sphere", {{"float radius", 0.1}},
                  {.to_world = Transform::translate({-2, 1, 5}),
                   .area_light = sunfleck::Parameters{{"rgb L", {900, 800, 650}}}});
    return builder.build();
}

}  // namespace

int main(int count, char** words) {
    try {
        sunfleck::Renderer renderer(ball_on_table(), sunfleck::Settings().set("aovs", "caustic"));
        renderer.step(4);
        const sunfleck::Picture picture = renderer.picture();
        const auto caustic = picture.channel("caustic.G");
        std::cout << "brightest pixel of the caustic: "
                  << *std::max_element(caustic.begin(), caustic.end()) << '\n';
        if (count > 1) picture.save(words[1]);
    } catch (const sunfleck::Error& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}

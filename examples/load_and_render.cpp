// Renders a scene file: load_and_render SCENE.pbrt PICTURE.exr [PASSES]
#include <sunfleck/sunfleck.h>

#include <cstdlib>
#include <iostream>

int main(int count, char** words) {
    if (count < 3) {
        std::cerr << "usage: load_and_render SCENE.pbrt PICTURE.exr [PASSES]\n";
        return 2;
    }
    try {
        const sunfleck::Scene scene = sunfleck::Scene::load(words[1]);
        std::cout << scene.width() << " x " << scene.height() << " pixels, "
                  << scene.triangle_count() << " triangles\n";

        sunfleck::Settings settings;
        settings.set("passes", count > 3 ? std::atoi(words[3]) : 64);
        sunfleck::RendererOptions options;
        options.log = [](sunfleck::Severity, const std::string& line) {
            std::cerr << line << '\n';
        };

        sunfleck::Renderer renderer(scene, settings, options);
        renderer.run();
        renderer.picture().save(words[2]);
        std::cout << renderer.progress().passes << " passes, written to " << words[2] << '\n';
    } catch (const sunfleck::Error& error) {
        std::cerr << error.what() << '\n';
        return error.code() == sunfleck::ErrorCode::input ? 2 : 1;
    }
}

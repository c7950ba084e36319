// Looks at a picture while it grows, ends the render when it is good enough, and looks again from
// another place. It is written for Sunfleck's own scene cornell: progressive cornell.pbrt
#include <sunfleck/sunfleck.h>

#include <chrono>
#include <iostream>
#include <thread>

namespace {

double mean_green(const sunfleck::Picture& picture) {
    double sum = 0;
    for (const float value : picture.channel("G")) sum += value;
    return sum / static_cast<double>(picture.channel("G").size());
}

/// Renders on a thread of its own until so many passes are done, then cancels it.
void render_some(sunfleck::Renderer& renderer, std::uint32_t passes) {
    renderer.start();
    while (renderer.is_running() && renderer.progress().passes < passes) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        std::cout << "mean so far " << mean_green(renderer.picture()) << '\n';
    }
    renderer.cancel();
    const bool is_cancelled = renderer.wait() == sunfleck::Outcome::cancelled;
    std::cout << (is_cancelled ? "cancelled" : "finished") << " after at least " << passes
              << " passes: mean " << mean_green(renderer.picture()) << '\n';
}

}  // namespace

int main(int count, char** words) {
    if (count < 2) {
        std::cerr << "usage: progressive cornell.pbrt\n";
        return 2;
    }
    try {
        sunfleck::Renderer renderer(sunfleck::Scene::load(words[1]),
                                    sunfleck::Settings().set("passes", 100000));
        render_some(renderer, 4);
        renderer.set_camera(
            "perspective", {{"float fov", 45}},  // begins anew; the geometry stays
            sunfleck::Transform::look_at({400, 300, -700}, {278, 273, 0}, {0, 1, 0}));
        renderer.set_resolution(64, 64);
        render_some(renderer, 2);
        renderer.set_crop({{16, 48, 16, 48}});
        renderer.step(3);
        std::cout << renderer.picture().width() << " x " << renderer.picture().height()
                  << " pixels after 3 steps\n";
    } catch (const sunfleck::Error& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}

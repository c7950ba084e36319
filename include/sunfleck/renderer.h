// Renders a scene: at once, pass by pass, or on a thread of its own.
//
// A pass is a whole picture with noise; the picture so far is the mean over all passes. The same
// scene, settings and seed give the same bytes with any number of threads, and however the passes
// are divided among calls.
#pragma once

#include <sunfleck/export.h>
#include <sunfleck/parameters.h>
#include <sunfleck/picture.h>
#include <sunfleck/scene.h>
#include <sunfleck/settings.h>
#include <sunfleck/transform.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace sunfleck {

/// What is known of a render after a pass.
struct SUNFLECK_API Progress {
    std::uint32_t passes = 0;         // rendered so far
    std::optional<std::uint32_t> of;  // passes at which the present call ends, if at a number
    double seconds = 0;               // of rendering
    double cpu_seconds = 0;           // the same, of all threads
    std::optional<double> error;  // relative, noise and bias, of 95% of the blocks; from pass 64 on
    std::optional<double> target_error;  // asked for
    std::optional<double> seconds_left;  // an estimate
    bool is_learning = false;            // true while the renderer learns where photons are needed
};

enum class Outcome {
    finished,  // what was asked for is done
    cancelled  // cancel() came first
};

enum class Severity { info, warning };

/// Called with one line; never on two threads at once for one renderer.
using Log = std::function<void(Severity, const std::string& line)>;

struct SUNFLECK_API RendererOptions {
    std::size_t threads = 0;  // at most; 0: as many as cores
    Log log{};                // warnings of the scene and of the render; none: nobody is told
};

/// cancel(), progress(), picture() and is_running() may be called on any thread at any time. All
/// other calls are for one thread at a time; they are refused while the renderer renders, and from
/// start() to wait().
class SUNFLECK_API Renderer {
public:
    using Report = std::function<void(const Progress&)>;

    /// @throws Error  for settings that cannot be used with this scene.
    explicit Renderer(const Scene& scene, const Settings& settings = {},
                      const RendererOptions& options = {});
    /// Cancels what start() has begun, and waits for its end, unless a report holds the last owner.
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    Renderer(Renderer&&) = delete;
    Renderer& operator=(Renderer&&) = delete;

    /// Renders so many more passes.
    /// @param report  is called after each pass, and before and after the renderer learns.
    Outcome step(std::uint32_t passes = 1, const Report& report = {});
    /// Renders until the first limit of the settings: "passes", "time", "cpu-time", "target-error".
    /// Without any, until an error of 2%, or for ten minutes. The time of all calls counts.
    Outcome run(const Report& report = {});

    /// The same as run(), on a thread of its own, on which `report` is called.
    void start(const Report& report = {});
    bool is_running() const;
    /// Waits for the end of what start() has begun, and throws what it has thrown. Not for a
    /// report.
    Outcome wait();

    /// Returns at once; what is under way then ends within some milliseconds. A pass that is not
    /// whole is left out; the render can go on. (A pass of the sampler "paper" is made to its end.)
    /// Where nothing is under way it does nothing.
    void cancel();

    Progress progress() const;
    /// The picture of all passes so far; black before the first.
    Picture picture() const;

    // Another view: the render begins anew, with the same settings. The geometry is not built
    // again, and the camera stays in its medium.

    /// @param type, parameters, to_world  as for SceneBuilder::camera().
    void set_camera(const std::string& type, const Parameters& parameters,
                    const Transform& to_world);
    /// Another size of the film; the view keeps the extent of its shorter axis.
    void set_resolution(int width, int height);
    /// Renders a part of the film alone: pixels [x0, x1) x [y0, y1). Nothing: all of it.
    void set_crop(const std::optional<std::array<int, 4>>& x0_x1_y0_y1);

    /// Statistics of the render so far as JSON, as `sunfleck render --stats` writes them.
    std::string statistics() const;

private:
    struct Impl;
    std::shared_ptr<Impl> impl_;
};

}  // namespace sunfleck

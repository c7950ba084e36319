// A scene, ready to be rendered: from a file, or from a SceneBuilder.
#pragma once

#include <sunfleck/export.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace sunfleck {

/// How a scene is read and built.
struct SUNFLECK_API SceneOptions {
    /// Threads that read pictures and build the geometry, at most; 0: as many as cores.
    std::size_t threads = 0;
    /// Instructions of the ray tracer: "avx2" gives the same bytes on every machine that has them,
    /// "native" takes what this machine has.
    std::string isa = "avx2";
    /// For load(): flags of the scene and their values, as `sunfleck render` has them in
    /// docs/reference/render.md: {{"sun", "225,40"}, {"turbidity", "2"}}.
    std::vector<std::pair<std::string, std::string>> flags{};
};

/// Light sources of a scene, by a statement of its file: what --light-group counts.
struct SUNFLECK_API LightInfo {
    std::string what;   // LightSource "point"
    std::string where;  // file:line:column
};

/// Immutable, and cheap to copy: copies share all that they hold. Any number of threads may use it,
/// and any number of renderers.
class SUNFLECK_API Scene {
public:
    /// Reads a scene file and the files that it names: pbrt-v4, glTF, or OBJ, STL or PLY alone.
    /// @throws Error  for what cannot be read; it tells the line and column. For a flag that is
    /// none, or has no meaning for the format.
    static Scene load(const std::string& path, const SceneOptions& options = {});

    /// Reads a scene from text. @param name  stands for the file's in messages, and names of other
    /// files start from its folder. @throws Error  as load() does.
    static Scene parse(const std::string& text, const std::string& name,
                       const SceneOptions& options = {});

    /// The size of the film, in pixels.
    int width() const;
    int height() const;
    /// One line each: what the scene asks for and does not get, and what is done instead.
    std::vector<std::string> warnings() const;
    /// All files that were read, each once.
    const std::vector<std::string>& files() const;
    std::vector<LightInfo> lights() const;
    /// Triangles; an instance counts all of its object's.
    std::size_t triangle_count() const;

    // For the library alone.
    struct Data;
    explicit Scene(std::shared_ptr<const Data> data);
    const Data& data() const { return *data_; }

private:
    std::shared_ptr<const Data> data_;
};

}  // namespace sunfleck

// Walks that ask the shapes, the lights and the camera of a scene which media they name.
//
// A walk starts at the camera or at a light in the medium there. It goes straight on through what
// lets light through, leaves other surfaces in any direction, and ends at the first shape that does
// not name the medium through which it came. On its way it looks at the camera and at lights, which
// hear its medium.
#pragma once

#include "scene/camera_view.h"
#include "scene/media.h"
#include "scene/scene_lights.h"
#include "scene/surfaces.h"

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace sunfleck::engine {

/// How often walks found the media of a shape to be so.
struct MediaVotes {
    int right = 0;
    int inside_out = 0;  // right if exchanged, and the normals point into the shape
    int other = 0;

    int all() const { return right + inside_out + other; }
    int wrong() const { return inside_out + other; }
};

struct ShapeVotes {
    MediaVotes named;    // of walks from starts for which the scene names a medium
    MediaVotes assumed;  // of the others
};

/// Where walks start: the camera, or the lights of one source.
struct MediaStart {
    LightRange lights{};  // none: the camera
    MediumSides sides{};
    bool is_named = false;                // the scene names a medium there
    std::map<MediumNumber, int> heard{};  // media of the walks that looked at it
    int wrong = 0;                        // of these, those that did not find the named medium
};

/// Where paths start: at the camera and at the lights.
struct PathOrigins {
    CameraView camera;
    const SceneLights& lights;
};

class MediaWalks {
public:
    /// @param stated  the scene's media as the file has them.
    /// @param ends  shapes that are known to be at odds: walks end there.
    MediaWalks(const Surfaces& surfaces, const PathOrigins& origins, const Media& stated,
               const std::set<std::uint32_t>& ends);

    /// Walks from all starts: first from those that name a medium, then from the camera, then from
    /// the other lights. Before its walks, a start that names none takes the medium it heard most.
    void walk_all();

    /// By shape of the scene.
    const std::map<std::uint32_t, ShapeVotes>& votes() const { return votes_; }
    /// The camera first, then the sources of lights that are not far away.
    const std::vector<MediaStart>& starts() const { return starts_; }

private:
    struct Walk {
        Ray ray;
        MediumNumber medium = 0;
    };

    /// Two random numbers of (0,1).
    Vec2d next_two();
    void walk_from(const std::vector<std::size_t>& starts);
    Walk camera_walk();
    std::optional<Walk> light_walk(const MediaStart& start, std::size_t i);
    void walk(Walk at, bool is_named);
    bool agrees(const Hit& hit, const Walk& at, bool is_named);
    void look_around(const Hit* hit, const Ray& ray, MediumNumber medium);

    const Surfaces& surfaces_;
    const PathOrigins& origins_;
    const std::set<std::uint32_t>& ends_;
    std::vector<MediaStart> starts_;
    std::size_t next_looked_at_ = 0;
    std::uint32_t drawn_ = 0;  // random numbers, by two
    std::map<std::uint32_t, ShapeVotes> votes_;
};

}  // namespace sunfleck::engine

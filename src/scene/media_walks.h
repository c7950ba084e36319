// Random walks that collect which media the shapes, the lights and the camera of a scene name.
//
// A walk starts at the camera or at a light, in the medium there. It goes straight through
// transmitting surfaces, leaves other surfaces in a random direction, and ends at the first shape
// that does not name the medium of the walk. At each step it tests the visibility of the camera and
// of lights, which record its medium.
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

/// Counts of walks by what they found about the media of a shape.
struct MediaVotes {
    int right = 0;
    int inside_out = 0;  // consistent if exchanged, and the normals point into the shape
    int other = 0;

    int all() const { return right + inside_out + other; }
    int wrong() const { return inside_out + other; }
};

struct ShapeVotes {
    MediaVotes named;    // walks from starts with a named medium
    MediaVotes assumed;  // walks from other starts
};

/// A start of walks: the camera, or the lights of one source.
struct MediaStart {
    LightRange lights{};  // empty for the camera
    MediumSides sides{};
    bool is_named = false;                // the scene names a medium there
    std::map<MediumNumber, int> heard{};  // media of the walks that saw it
    int wrong = 0;                        // of these, walks in another medium than the named one
};

/// Where paths start: at the camera and at the lights.
struct PathOrigins {
    CameraView camera;
    const SceneLights& lights;
};

class MediaWalks {
public:
    /// @param stated  the media as in the scene file.
    /// @param ends  shapes known to be inconsistent, at which walks end.
    MediaWalks(const Surfaces& surfaces, const PathOrigins& origins, const Media& stated,
               const std::set<std::uint32_t>& ends);

    /// Walks from all starts: first from those with a named medium, then from the camera, then from
    /// the other lights. A start without a named medium first takes the one that most walks
    /// recorded there.
    void walk_all();

    /// Returns the votes per shape of the scene.
    const std::map<std::uint32_t, ShapeVotes>& votes() const { return votes_; }
    /// Returns the starts: the camera, then the sources at finite distance.
    const std::vector<MediaStart>& starts() const { return starts_; }

private:
    struct Walk {
        Ray ray;
        MediumNumber medium = 0;
    };

    /// Returns two random numbers of (0,1).
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
    std::uint32_t drawn_ = 0;  // count of pairs of random numbers
    std::map<std::uint32_t, ShapeVotes> votes_;
};

}  // namespace sunfleck::engine

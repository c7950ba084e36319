// Exchange of media, warnings, and media of starts without a named one.
#include "scene/media_check.h"

#include <algorithm>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Limit of nesting: inner shapes are checked when those around them are consistent.
constexpr int kMostNested = 16;

/// A walk may slip between two touching surfaces. A larger count, and such a fraction of all walks,
/// is a fault of the scene.
constexpr int kMostSlips = 2;
constexpr double kShareOfSlips = 0.01;

bool is_fault(int wrong, int all) {
    return wrong > kMostSlips && wrong > kShareOfSlips * all;
}

/// Returns the votes that decide: of walks from named starts, if they are more than slips.
const MediaVotes& decisive(const ShapeVotes& votes) {
    return votes.named.all() > kMostSlips ? votes.named : votes.assumed;
}

int wrong_votes(const ShapeVotes& votes) {
    const int wrong = votes.named.wrong() + votes.assumed.wrong();
    return is_fault(wrong, votes.named.all() + votes.assumed.all()) ? wrong : 0;
}

/// Returns the shapes of which most walks say that they are inside out.
std::vector<std::uint32_t> shapes_inside_out(const MediaWalks& walks) {
    std::vector<std::uint32_t> found;
    for (const auto& [shape, votes] : walks.votes())
        if (2 * decisive(votes).inside_out > decisive(votes).all()) found.push_back(shape);
    return found;
}

/// Returns the shapes that are most inconsistent. Walks beyond such a shape find faults in others
/// as well, which may have none.
std::vector<std::uint32_t> worst_at_odds(const MediaWalks& walks) {
    int most = 0;
    for (const auto& [shape, votes] : walks.votes()) most = std::max(most, wrong_votes(votes));
    std::vector<std::uint32_t> found;
    for (const auto& [shape, votes] : walks.votes())
        if (2 * wrong_votes(votes) > most) found.push_back(shape);
    return found;
}

bool is_fault(const MediaStart& start) {
    int all = 0;
    for (const auto& [medium, count] : start.heard) all += count;
    const auto own = start.heard.find(start.sides.outside);
    const int taken = own == start.heard.end() ? 0 : own->second;
    return is_fault(start.is_named ? start.wrong : all - taken, all);
}

/// Returns the location of a start in the scene file.
SourceLocation location_of(const MediaStart& start, const SceneLights& lights,
                           const std::string& path) {
    if (start.lights.count == 0) return {path};
    const std::uint32_t statement = lights.stated_in()[start.lights.first];
    return statement == kNone ? SourceLocation{path} : lights.statements()[statement].where;
}

/// @param where  location of the start in the scene file.
void tell(const MediaStart& start, const SourceLocation& where, Warnings& warnings) {
    const std::string what = start.lights.count == 0 ? "the camera" : "this light";
    if (is_fault(start))
        warnings.add(where, what +
                                " is seen through other media than the one around it, so that "
                                "light and camera paths may cross different media; before it, "
                                "write a MediumInterface whose second name is that medium");
    else if (!start.is_named && start.sides.outside != 0)
        warnings.add(where, "no MediumInterface names the medium around " + what +
                                "; the one through which it is seen is used; before it, write a "
                                "MediumInterface whose second name is that medium");
}

/// Sets the media of the camera and the lights to those that the walks recorded.
void take_starts(const MediaWalks& walks, Media& media) {
    media.at_camera = walks.starts().front().sides.outside;
    for (const MediaStart& start : walks.starts())
        for (std::uint32_t i = 0; i < start.lights.count; ++i)
            media.at_lights[start.lights.first + i] = start.sides;
}

}  // namespace

std::vector<std::uint32_t> mend_media(Surfaces& surfaces, Media& media, const PathOrigins& origins,
                                      const ScenePlaces& places, Warnings& warnings) {
    const Media stated = media;
    std::set<std::uint32_t> at_odds;
    std::vector<std::uint32_t> exchanged;
    for (int i = 0; i < kMostNested; ++i) {
        MediaWalks walks(surfaces, origins, stated, at_odds);
        walks.walk_all();
        const bool is_last = i + 1 == kMostNested;
        const auto inside_out = shapes_inside_out(walks);
        for (const std::uint32_t shape : inside_out) {
            surfaces.exchange_media(shape);
            exchanged.push_back(shape);
            warnings.add(places.shapes[shape],
                         "the normals of this shape point into it, so that its MediumInterface "
                         "names the medium inside as the one outside; both were exchanged; remove "
                         "ReverseOrientation, or reverse the winding of its triangles (refraction "
                         "uses these normals, too), or exchange the two names");
        }
        if (!inside_out.empty() && !is_last) continue;
        const auto worst = worst_at_odds(walks);
        at_odds.insert(worst.begin(), worst.end());
        if (!worst.empty() && !is_last) continue;
        take_starts(walks, media);
        for (const MediaStart& start : walks.starts())
            tell(start, location_of(start, origins.lights, places.path), warnings);
        break;
    }
    for (const std::uint32_t shape : at_odds)
        warnings.add(places.shapes[shape],
                     "its MediumInterface does not name the medium through which it is seen, so "
                     "that light and camera paths may cross different media; name the same medium "
                     "on sides of surfaces that face each other and around the camera, and close "
                     "the shape, because rays pass around the edge of an open one");
    return exchanged;
}

}  // namespace sunfleck::engine

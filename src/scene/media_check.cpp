// What is exchanged, what is warned of, and where a start that names no medium stands.
#include "scene/media_check.h"

#include <algorithm>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Shapes stand in each other: those within are looked at when those around them are right.
constexpr int kMostNested = 16;

/// A walk may slip through where two surfaces touch. More than so many, and such a share of all,
/// are a fault of the scene.
constexpr int kMostSlips = 2;
constexpr double kShareOfSlips = 0.01;

bool is_fault(int wrong, int all) {
    return wrong > kMostSlips && wrong > kShareOfSlips * all;
}

/// Votes that decide: of walks from starts that name a medium, if there are more than slips.
const MediaVotes& decisive(const ShapeVotes& votes) {
    return votes.named.all() > kMostSlips ? votes.named : votes.assumed;
}

int wrong_votes(const ShapeVotes& votes) {
    const int wrong = votes.named.wrong() + votes.assumed.wrong();
    return is_fault(wrong, votes.named.all() + votes.assumed.all()) ? wrong : 0;
}

/// Shapes of which most walks say that they are inside out.
std::vector<std::uint32_t> shapes_inside_out(const MediaWalks& walks) {
    std::vector<std::uint32_t> found;
    for (const auto& [shape, votes] : walks.votes())
        if (2 * decisive(votes).inside_out > decisive(votes).all()) found.push_back(shape);
    return found;
}

/// Shapes at odds with what is around them: the worst. Walks beyond one find faults in others, too,
/// which may have none.
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

/// Where the scene's file speaks of a start.
SourceLocation location_of(const MediaStart& start, const SceneLights& lights,
                           const std::string& path) {
    if (start.lights.count == 0) return {path};
    const std::uint32_t statement = lights.stated_in()[start.lights.first];
    return statement == kNone ? SourceLocation{path} : lights.statements()[statement].where;
}

/// @param where  the scene's file speaks of the start.
void tell(const MediaStart& start, const SourceLocation& where, Warnings& warnings) {
    const std::string what = start.lights.count == 0 ? "the camera" : "this light";
    if (is_fault(start))
        warnings.add(where, what +
                                " is seen through other media than the one in which it stands, so "
                                "that light and camera paths may cross different media; write a "
                                "MediumInterface before it that names, second, what is around it");
    else if (!start.is_named && start.sides.outside != 0)
        warnings.add(where, "no MediumInterface names the medium around " + what +
                                "; it stands in the one through which it is seen; name that, "
                                "second, in a MediumInterface before it");
}

/// Media of the camera and of lights, as the walks have left them.
void take_starts(const MediaWalks& walks, Media& media) {
    media.at_camera = walks.starts().front().sides.outside;
    for (const MediaStart& start : walks.starts())
        for (std::uint32_t i = 0; i < start.lights.count; ++i)
            media.at_lights[start.lights.first + i] = start.sides;
}

}  // namespace

void mend_media(Surfaces& surfaces, Media& media, const PathOrigins& origins,
                const ScenePlaces& places, Warnings& warnings) {
    const Media stated = media;
    std::set<std::uint32_t> at_odds;
    for (int i = 0; i < kMostNested; ++i) {
        MediaWalks walks(surfaces, origins, stated, at_odds);
        walks.walk_all();
        const bool is_last = i + 1 == kMostNested;
        const auto inside_out = shapes_inside_out(walks);
        for (const std::uint32_t shape : inside_out) {
            surfaces.exchange_media(shape);
            warnings.add(places.shapes[shape],
                         "the normals of this shape point into it, so that its MediumInterface "
                         "names the medium within as the one around it; the two are exchanged; "
                         "leave out ReverseOrientation, or turn its triangles (glass refracts by "
                         "these normals, too), or write the media in the other order");
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
                     "for the sides of surfaces, and the camera, that face each other, and close "
                     "the shape: rays go around the edge of an open one");
}

}  // namespace sunfleck::engine

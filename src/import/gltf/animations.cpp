// Samplers of animations: steps, straight lines and splines between keys.
#include "import/gltf/animations.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace sunfleck::engine {
namespace {

enum class Interpolation { step, linear, spline };

Interpolation interpolation_of(const JsonPlace& sampler) {
    const std::string name = sampler.text("interpolation", "LINEAR");
    if (name == "LINEAR") return Interpolation::linear;
    if (name == "STEP") return Interpolation::step;
    if (name == "CUBICSPLINE") return Interpolation::spline;
    sampler.at("interpolation").refuse("is no interpolation", "write LINEAR, STEP or CUBICSPLINE");
}

/// The keys of a sampler around a time.
struct Between {
    std::size_t before = 0;
    std::size_t after = 0;
    double share = 0;   // of the way to `after`
    double length = 0;  // seconds
};

Between between(const std::vector<float>& times, double seconds, const JsonPlace& input) {
    if (times.empty()) input.refuse("has no key", "export the file again");
    for (std::size_t i = 1; i < times.size(); ++i)
        if (times[i] < times[i - 1])
            input.refuse("has times that decrease", "export the file again");
    const auto next = std::upper_bound(times.begin(), times.end(), seconds,
                                       [](double t, float key) { return t < double{key}; });
    if (next == times.begin()) return {};
    Between found;
    found.before = static_cast<std::size_t>(next - times.begin()) - 1;
    found.after = std::min(found.before + 1, times.size() - 1);
    found.length = double{times[found.after]} - double{times[found.before]};
    if (found.length > 0) found.share = (seconds - double{times[found.before]}) / found.length;
    return found;
}

/// Numbers of all keys one after another, and how many of them a key has.
struct Track {
    std::vector<double> numbers;
    std::size_t size = 0;

    std::vector<double> at(std::size_t element) const {
        const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(element * size);
        return {begin, begin + static_cast<std::ptrdiff_t>(size)};
    }
};

/// @return  of weights, whose number the file does not say, with a size of 0.
Track track_of(const Accessors& accessors, const JsonPlace& output, const std::string& path) {
    Track track;
    const auto add = [&](const auto& numbers) {
        for (const float x : numbers) track.numbers.push_back(double{x});
    };
    if (path == "weights") {
        add(accessors.scalars(output));
        return track;
    }
    track.size = path == "rotation" ? 4 : 3;
    if (path == "rotation")
        for (const auto& q : accessors.quadruples(output)) add(q);
    else
        for (const Vec3& v : accessors.triples(output)) add(std::array{v.x, v.y, v.z});
    return track;
}

std::vector<double> sum(const std::vector<double>& a, double of_a, const std::vector<double>& b,
                        double of_b) {
    std::vector<double> result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] * of_a + b[i] * of_b;
    return result;
}

/// Returns the arc between unit quaternions at a share of its length, by halving it: no function of
/// angles is needed, and after 40 halvings nothing is left of the arc.
std::vector<double> on_arc(std::vector<double> from, std::vector<double> to, double share) {
    const auto unit = [](const std::vector<double>& q) {
        double square = 0;
        for (const double x : q) square += x * x;
        return square > 0 ? sum(q, 1 / std::sqrt(square), q, 0) : q;
    };
    from = unit(from);
    to = unit(to);
    double cosine = 0;
    for (std::size_t i = 0; i < 4; ++i) cosine += from[i] * to[i];
    if (cosine < 0) to = sum(to, -1, to, 0);  // the same rotation, by the shorter way
    for (int halving = 0; halving < 40; ++halving) {
        const std::vector<double> middle = unit(sum(from, 1, to, 1));
        share *= 2;
        if (share < 1) {
            to = middle;
        } else {
            from = middle;
            share -= 1;
        }
    }
    return unit(sum(from, 1 - share, to, share));
}

/// Hermite's spline. The numbers of a key are: tangent in, value, tangent out.
std::vector<double> on_spline(const Track& track, const Between& at) {
    const double t = at.share;
    const double t2 = t * t;
    const double t3 = t2 * t;
    const std::vector<double> values = sum(track.at(3 * at.before + 1), 2 * t3 - 3 * t2 + 1,
                                           track.at(3 * at.after + 1), 3 * t2 - 2 * t3);
    const std::vector<double> tangents =
        sum(track.at(3 * at.before + 2), at.length * (t3 - 2 * t2 + t), track.at(3 * at.after),
            at.length * (t3 - t2));
    return sum(values, 1, tangents, 1);
}

std::vector<double> sampled(const Accessors& accessors, const JsonPlace& sampler,
                            const std::string& path, double seconds) {
    const JsonPlace input = sampler.at("input");
    const JsonPlace output = sampler.at("output");
    const Interpolation how = interpolation_of(sampler);
    const std::vector<float> times = accessors.scalars(input);
    const Between at = between(times, seconds, input);
    Track track = track_of(accessors, output, path);
    const std::size_t elements = times.size() * (how == Interpolation::spline ? 3 : 1);
    if (track.size == 0) track.size = track.numbers.size() / elements;
    if (track.size == 0 || track.numbers.size() != track.size * elements)
        output.refuse("does not fit the keys of its animation", "export the file again");
    if (how == Interpolation::spline) return on_spline(track, at);
    if (how == Interpolation::step || at.share == 0) return track.at(at.before);
    if (path == "rotation") return on_arc(track.at(at.before), track.at(at.after), at.share);
    return sum(track.at(at.before), 1 - at.share, track.at(at.after), at.share);
}

void set(GltfPose& pose, const std::string& path, std::vector<double> value) {
    if (path == "translation") pose.translation = Vec3d(value[0], value[1], value[2]);
    if (path == "scale") pose.scale = Vec3d(value[0], value[1], value[2]);
    if (path == "rotation") pose.rotation = {value[0], value[1], value[2], value[3]};
    if (path == "weights") pose.weights = std::move(value);
}

bool is_path(const std::string& name) {
    return name == "translation" || name == "rotation" || name == "scale" || name == "weights";
}

}  // namespace

GltfPoses poses_at(double seconds, const GltfDocument& document, const Accessors& accessors,
                   Warnings& warnings) {
    GltfPoses poses;
    std::set<std::pair<std::size_t, std::string>> moved;
    for (const JsonPlace& animation : document.root().elements("animations"))
        for (const JsonPlace& channel : animation.elements("channels")) {
            const JsonPlace target = channel.at("target");
            const auto node = target.find("node");
            const std::string path = target.at("path").text();
            if (!node || !is_path(path)) {
                warnings.add(target.where(), "is no part of a node, and is not animated");
                continue;
            }
            const std::size_t number = node->index(document.count("nodes"), "node");
            if (!moved.insert({number, path}).second) {
                warnings.add(animation.where(),
                             "moves what an animation before it moves: the first counts");
                continue;
            }
            const JsonPlace samplers = animation.at("samplers");
            const JsonPlace sampler =
                samplers[channel.at("sampler").index(samplers.size(), "sampler")];
            set(poses[number], path, sampled(accessors, sampler, path, seconds));
        }
    return poses;
}

}  // namespace sunfleck::engine

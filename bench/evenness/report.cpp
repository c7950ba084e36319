// The tables.
#include "evenness/report.h"

#include "bootstrap.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

namespace sunfleck::engine::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string name_of_class(std::size_t number) {
    if (number + 1 == kClassCount) return fmt::format("above {:g}", kClassEdges[number]);
    return fmt::format("{:g} to {:g}", kClassEdges[number], kClassEdges[number + 1]);
}

/// How many times less error the second method has than the first, at equal time.
struct Gain {
    double ratio = 1;
    Interval interval;
};

Gain gain_over(const SceneErrors& before, const SceneErrors& now) {
    const auto mean_by = [](const SceneErrors& errors, const std::vector<std::size_t>& seeds) {
        double sum = 0;
        for (const std::size_t seed : seeds) sum += errors.pictures[seed].relative;
        return sum;
    };
    const auto ratio = [&](const std::vector<std::size_t>& first,
                           const std::vector<std::size_t>& second) {
        return mean_by(before, first) / mean_by(now, second);
    };
    std::vector<std::size_t> all(now.pictures.size());
    std::iota(all.begin(), all.end(), 0U);
    return {ratio(all, all), bootstrap(all.size(), ratio)};
}

std::size_t most_spots(const SceneErrors& errors) {
    std::size_t most = 0;
    for (const PictureErrors& picture : errors.pictures) most = std::max(most, picture.spots.count);
    return most;
}

double worst_share(const SceneErrors& errors) {
    double sum = 0;
    for (const PictureErrors& picture : errors.pictures) sum += picture.spots.worst_share;
    return sum / static_cast<double>(errors.pictures.size());
}

Json json_of_classes(const SceneErrors& errors, const BlockClasses& classes) {
    Json list = Json::array();
    for (std::size_t number = 0; number < kClassCount; ++number) {
        if (classes.blocks(number).empty()) continue;
        Json row = {{"class", name_of_class(number)}, {"blocks", classes.blocks(number).size()}};
        for (std::size_t part = 0; part < kParts.size(); ++part)
            row[std::string(kParts[part])] = {
                {"rms", errors.rms(part, number, &ClassError::plain)},
                {"trimmed", errors.rms(part, number, &ClassError::trimmed)}};
        list.push_back(row);
    }
    return list;
}

Json json_of(const SceneResult& result, const std::vector<Method>& methods) {
    const BlockClasses classes(result.reference.blocks.mean);
    Json list = Json::array();
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const SceneErrors& errors = result.methods[i];
        Json row = {{"method", methods[i].name},
                    {"seeds", errors.pictures.size()},
                    {"cpu_seconds", errors.mean(&PictureErrors::cpu_seconds)},
                    {"brightness", errors.mean(&PictureErrors::brightness)},
                    {"rel_mse", errors.mean(&PictureErrors::relative)},
                    {"most_spots", most_spots(errors)},
                    {"worst_share", worst_share(errors)},
                    {"classes", json_of_classes(errors, classes)}};
        if (i > 0) {
            const Gain gain = gain_over(result.methods[0], errors);
            row["gain"] = {gain.ratio, gain.interval.low, gain.interval.high};
        }
        list.push_back(row);
    }
    return {{"scene", result.scene.name}, {"methods", list}};
}

std::string text_of(const SceneResult& result, const std::vector<Method>& methods) {
    const BlockClasses classes(result.reference.blocks.mean);
    std::string text = "\n" + result.scene.name + "\n";
    for (std::size_t number = 0; number < kClassCount; ++number) {
        const std::size_t blocks = classes.blocks(number).size();
        if (blocks == 0) continue;
        const auto share = 100.0 * static_cast<double>(blocks) /
                           static_cast<double>(result.reference.blocks.mean.size());
        for (std::size_t i = 0; i < methods.size(); ++i) {
            text +=
                fmt::format("  {:<11} {:4.0f}% {:<12}",
                            i == 0 ? name_of_class(number) : std::string(), share, methods[i].name);
            for (std::size_t part = 0; part < kParts.size(); ++part)
                text += fmt::format("  {} {:.4f} ({:.4f})", kParts[part],
                                    result.methods[i].rms(part, number, &ClassError::plain),
                                    result.methods[i].rms(part, number, &ClassError::trimmed));
            text += "\n";
        }
    }
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const SceneErrors& errors = result.methods[i];
        text += fmt::format(
            "  {:<12} relMSE {:.3g}  brightness {:.4f}  most spots {}  worst share {:.2f}  {:.1f} "
            "s",
            methods[i].name, errors.mean(&PictureErrors::relative),
            errors.mean(&PictureErrors::brightness), most_spots(errors), worst_share(errors),
            errors.mean(&PictureErrors::cpu_seconds));
        if (i > 0) {
            const Gain gain = gain_over(result.methods[0], errors);
            text += fmt::format("  gain {:.3g} [{:.3g}, {:.3g}]", gain.ratio, gain.interval.low,
                                gain.interval.high);
        }
        text += "\n";
    }
    return text;
}

/// The square of the largest error over the smallest, of a view with all its surrounds.
struct SurroundCost {
    std::string view;
    std::string method;
    std::size_t number = 0;  // of the class
    double plain = 1;
    double trimmed = 1;
};

std::optional<double> spread(const std::vector<const SceneResult*>& scenes, std::size_t method,
                             std::size_t number, double ClassError::*kind) {
    double low = std::numeric_limits<double>::infinity();
    double high = 0;
    for (const SceneResult* scene : scenes) {
        const double rms = scene->methods[method].rms(0, number, kind);
        low = std::min(low, rms);
        high = std::max(high, rms);
    }
    if (!(low > 0)) return {};
    return high * high / (low * low);
}

std::vector<SurroundCost> surround_costs(const Results& results) {
    std::map<std::string, std::vector<const SceneResult*>> views;
    for (const SceneResult& scene : results.scenes) views[scene.scene.view].push_back(&scene);
    std::vector<SurroundCost> costs;
    for (const auto& [view, scenes] : views) {
        if (scenes.size() < 2) continue;
        for (std::size_t method = 0; method < results.methods.size(); ++method)
            for (std::size_t number = 0; number < kClassCount; ++number) {
                const auto plain = spread(scenes, method, number, &ClassError::plain);
                const auto trimmed = spread(scenes, method, number, &ClassError::trimmed);
                if (plain && trimmed)
                    costs.push_back({view, results.methods[method].name, number, *plain, *trimmed});
            }
    }
    return costs;
}

}  // namespace

std::string results_text(const Results& results) {
    std::string text = fmt::format("Block rms over the class's mean (trimmed), {:g} s, {} pixels\n",
                                   results.cpu_seconds, results.resolution);
    for (const SceneResult& scene : results.scenes) text += text_of(scene, results.methods);
    const std::vector<SurroundCost> costs = surround_costs(results);
    if (!costs.empty()) text += "\nSquare of the largest over the smallest, over surrounds\n";
    for (const SurroundCost& cost : costs)
        text += fmt::format("  {:<14} {:<12} {:<11} plain {:8.2f}  trimmed {:8.2f}\n", cost.view,
                            cost.method, name_of_class(cost.number), cost.plain, cost.trimmed);
    return text;
}

std::string evenness_json(const Results& results) {
    Json json = {{"cpu_seconds", results.cpu_seconds}, {"resolution", results.resolution}};
    json["scenes"] = Json::array();
    for (const SceneResult& scene : results.scenes)
        json["scenes"].push_back(json_of(scene, results.methods));
    json["surrounds"] = Json::array();
    for (const SurroundCost& cost : surround_costs(results))
        json["surrounds"].push_back({{"view", cost.view},
                                     {"method", cost.method},
                                     {"class", name_of_class(cost.number)},
                                     {"plain", cost.plain},
                                     {"trimmed", cost.trimmed}});
    return json.dump(2) + "\n";
}

}  // namespace sunfleck::engine::bench

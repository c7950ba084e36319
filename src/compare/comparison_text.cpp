// A comparison as a table for a terminal and as JSON.
#include "compare/comparison.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

using Json = nlohmann::ordered_json;

/// NaN is null.
Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

Json metrics_json(const Metrics& metrics) {
    Json json = Json::object();
    for (const MetricRow& row : kMetrics) json[std::string(row.name)] = number(metrics.*row.value);
    return json;
}

Json point_json(const SeriesPoint& point) {
    Json json = {
        {"passes", point.passes}, {"seconds", point.seconds}, {"cpu_seconds", point.cpu_seconds}};
    for (std::size_t m = 0; m < kMetrics.size(); ++m) {
        const Band& band = point.bands[m];
        if (std::isnan(band.middle)) continue;
        json[std::string(kMetrics[m].name)] = {number(band.low), number(band.middle),
                                               number(band.high)};
    }
    return json;
}

Json picture_json(const Compared& picture) {
    return {
        {"label", picture.input.label}, {"path", picture.shown}, {"broken_pixels", picture.broken}};
}

std::size_t width_of_labels(const Comparison& comparison) {
    std::size_t width = 9;
    for (const Compared& picture : comparison.pictures)
        width = std::max(width, picture.input.label.size());
    return width;
}

}  // namespace

std::string comparison_table(const Comparison& comparison) {
    const std::size_t width = width_of_labels(comparison);
    std::string text = fmt::format("{:<{}}", "picture", width);
    for (const MetricRow& row : kMetrics) text += fmt::format("  {:>10}", row.title);
    text += '\n';
    for (const Compared& picture : comparison.pictures) {
        text += fmt::format("{:<{}}", picture.input.label, width);
        for (const MetricRow& row : kMetrics) {
            const double value = picture.measured.metrics.*row.value;
            const std::string cell = std::isnan(value) ? "-" : fmt::format("{:.4g}", value);
            text += fmt::format("  {:>{}}", cell, std::max<std::size_t>(10, row.title.size()));
        }
        text += '\n';
    }
    const auto tell = [&](const Compared& picture) {
        if (picture.broken > 0)
            text += fmt::format("{}: {} of {} pixels are NaN or infinite, and left out\n",
                                picture.input.label, picture.broken, picture.image.pixels.size());
    };
    tell(comparison.reference);
    for (const Compared& picture : comparison.pictures) tell(picture);
    return text;
}

std::string comparison_json(const Comparison& comparison) {
    Json json = {{"width", comparison.reference.image.width},
                 {"height", comparison.reference.image.height},
                 {"reference", picture_json(comparison.reference)}};
    json["pictures"] = Json::array();
    for (const Compared& picture : comparison.pictures) {
        Json one = picture_json(picture);
        one["left_out"] = picture.measured.left_out;
        one["metrics"] = metrics_json(picture.measured.metrics);
        if (picture.seeds > 0) {
            one["series"]["seeds"] = picture.seeds;
            one["series"]["points"] = Json::array();
            for (const SeriesPoint& point : picture.points)
                one["series"]["points"].push_back(point_json(point));
        }
        json["pictures"].push_back(one);
    }
    // Names of files may be any bytes.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sunfleck::engine

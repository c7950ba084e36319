// The record of a run as JSON.
#include "experiment/record.h"

#include "experiment/figure_cells.h"
#include "experiment/machine.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace sunfleck::engine {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

Json table_json(const Table& table) {
    return {{"name", table.name},
            {"title", table.title},
            {"columns", table.columns},
            {"rows", table.rows}};
}

Json chart_json(const Chart& chart) {
    Json json = {{"name", chart.name}, {"x", chart.x_title}, {"y", chart.y_title}};
    for (const ChartLine& line : chart.lines) {
        Json points = Json::array();
        for (const ChartPoint& p : line.points)
            points.push_back({number(p.x), number(p.y), number(p.low), number(p.high)});
        json["lines"].push_back({{"label", line.label}, {"x y low high", points}});
    }
    return json;
}

Json cell_json(const Results& results, const Cell& cell, bool has_reference) {
    const CellFacts facts = results.facts(cell);
    Json json = {{"scene", cell.scene},
                 {"method", cell.method.name},
                 {"flags", cell.method.flags},
                 {"seed", cell.seed},
                 {"passes", number(facts.passes)},
                 {"seconds", number(facts.seconds)},
                 {"cpu_seconds", number(facts.cpu_seconds)},
                 {"mean", number(facts.mean)},
                 {"visible_fraction", number(facts.visible_fraction)},
                 {"visible_photon_ratio", number(facts.visible_ratio)},
                 {"visible_photon_ratio_with_repeats", number(facts.visible_ratio_with_repeats)},
                 {"mutation_size", number(facts.mutation_size)},
                 {"acceptance", number(facts.acceptance)}};
    if (!has_reference) return json;
    const PictureError error = results.error(cell);
    json["mse"] = number(error.mse);
    json["rel_mse"] = number(error.rel_mse);
    json["trimmed_mse"] = number(error.trimmed_mse);
    return json;
}

}  // namespace

std::string results_json(const Results& results, const std::vector<FinishedFigure>& finished) {
    const RunSettings& s = results.settings();
    Json json = {{"version", SUNFLECK_VERSION},
                 {"machine", machine_text()},
                 {"settings",
                  {{"cpu_seconds", s.passes > 0 ? Json() : Json(s.cpu_seconds)},
                   {"passes", s.passes > 0 ? Json(s.passes) : Json()},
                   {"reference_budget", s.reference_budget},
                   {"seeds", s.seeds},
                   {"scale", s.scale},
                   {"threads", s.threads}}}};
    std::vector<Figure> all;
    for (const FinishedFigure& f : finished) {
        Json figure = {{"name", f.figure->name},
                       {"title", f.figure->title},
                       {"claim", f.figure->claim},
                       {"findings", f.section.findings}};
        for (const Table& table : f.section.tables) figure["tables"].push_back(table_json(table));
        for (const Chart& chart : f.section.charts) figure["charts"].push_back(chart_json(chart));
        json["figures"].push_back(figure);
        all.push_back(*f.figure);
    }
    for (const Cell& cell : cells_of(all, s))
        json["cells"].push_back(cell_json(results, cell, results.has_reference(cell.scene)));
    return json.dump(2) + "\n";
}

}  // namespace sunfleck::engine

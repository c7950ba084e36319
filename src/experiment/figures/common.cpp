// Tables, charts and rows that figures share.
#include "experiment/figures/common.h"

#include <fmt/format.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

double mean_fact(const Results& results, const std::vector<Cell>& cells, double CellFacts::*fact) {
    double sum = 0;
    for (const Cell& cell : cells) sum += results.facts(cell).*fact;
    return sum / static_cast<double>(cells.size());
}

std::vector<std::string> method_row(const Results& results, const std::string& scene,
                                    const Method& method, const Method& base) {
    const std::vector<Cell> cells = results.cells(scene, method);
    std::vector<std::string> row = {
        scene, method.name, number_text(mean_fact(results, cells, &CellFacts::passes)),
        number_text(mean_fact(results, cells, &CellFacts::cpu_seconds))};
    for (const Measure& m : kMeasures)
        row.push_back(interval_text(mean_interval(results.errors(scene, method, m.kind))));
    for (const Measure& m : kMeasures)
        row.push_back(method.name == base.name
                          ? "1"
                          : interval_text(cost_ratio(results, scene, method, base, m.kind)));
    return row;
}

void add_others(const Results& results, const std::string& scene, Table& table) {
    for (const OtherPicture& other : results.settings().others) {
        if (other.scene != scene) continue;
        const PictureError error = results.error(scene, other.file);
        std::vector<std::string>& row = table.rows.emplace_back();
        row = {scene, other.label, "-", "-"};
        for (const Measure& m : kMeasures) row.push_back(number_text(error.*m.kind));
        row.resize(table.columns.size(), "-");
    }
}

/// Median, lowest and highest of one snapshot a seed.
ChartPoint error_point(const Results& results, const std::string& scene,
                       const std::vector<const CellFacts*>& seeds) {
    std::vector<double> errors;
    std::vector<double> seconds;
    for (const CellFacts* facts : seeds) {
        errors.push_back(results.error(scene, facts->picture).rel_mse);
        seconds.push_back(facts->cpu_seconds);
    }
    std::sort(errors.begin(), errors.end());
    std::sort(seconds.begin(), seconds.end());
    return {seconds[seconds.size() / 2], errors[errors.size() / 2], errors.front(), errors.back()};
}

/// @param seeds  snapshots after 1, 2, 4 ... passes and at the end, of each seed.
std::vector<ChartPoint> error_points(const Results& results, const std::string& scene,
                                     const std::vector<std::vector<CellFacts>>& seeds) {
    std::size_t shared = seeds[0].size();
    for (const auto& seed : seeds) shared = std::min(shared, seed.size());
    std::vector<ChartPoint> points;
    for (std::size_t i = 0; i < shared; ++i) {
        std::vector<const CellFacts*> column;
        column.reserve(seeds.size());
        for (const auto& seed : seeds) column.push_back(i + 1 < shared ? &seed[i] : &seed.back());
        points.push_back(error_point(results, scene, column));
    }
    return points;
}

}  // namespace

std::vector<Cell> seed_cells(const RunSettings& settings, const std::vector<std::string>& scenes,
                             const std::vector<Method>& methods) {
    std::vector<Cell> cells;
    for (std::uint64_t seed = 1; seed <= settings.seeds; ++seed)  // interleaved
        for (const std::string& scene : scenes)
            for (const Method& method : methods) cells.push_back({scene, method, seed});
    return cells;
}

Table error_table(const Results& results, const std::string& name,
                  const std::vector<std::string>& scenes, const std::vector<Method>& methods) {
    Table table{name,
                fmt::format("Errors after equal time, {} seeds: mean and 95% interval",
                            results.settings().seeds),
                {"scene", "method", "passes", "cpu s"},
                {}};
    for (const Measure& m : kMeasures) table.columns.emplace_back(m.name);
    for (const Measure& m : kMeasures)
        table.columns.push_back(fmt::format("{} x cpu s over {}", m.name, methods[0].name));
    for (const std::string& scene : scenes) {
        for (const Method& method : methods)
            table.rows.push_back(method_row(results, scene, method, methods[0]));
        add_others(results, scene, table);
        const Reference& r = results.reference(scene);
        table.rows.push_back({scene, r.method + " (its own error)", "-", "-", "-",
                              number_text(r.own_rel_mse), "-", "-", "-", "-"});
    }
    return table;
}

Chart error_chart(const Results& results, const std::string& name, const std::string& scene,
                  const std::vector<Method>& methods) {
    Chart chart{name, "Error over time: " + scene, "processor seconds", "relMSE", {}, true};
    for (const Method& method : methods) {
        std::vector<std::vector<CellFacts>> seeds;
        for (const Cell& cell : results.cells(scene, method))
            seeds.push_back(results.snapshots(cell));
        chart.lines.push_back({method.name, error_points(results, scene, seeds)});
    }
    return chart;
}

PictureRow picture_row(const Results& results, const std::string& name, const std::string& scene,
                       const std::vector<Method>& methods) {
    PictureRow row{fmt::format("{}-{}", name, scene), scene, {}};
    const auto add = [&](const Cell& cell) {
        const CellFacts facts = results.facts(cell);
        row.pictures.push_back(
            {facts.picture, fmt::format("{}-{}", row.name, cell.method.name),
             fmt::format("{}, {}, {:.0f} s", scene, cell.method.name, facts.cpu_seconds)});
    };
    for (const Method& method : methods) add({scene, method, 1});
    for (const OtherPicture& other : results.settings().others)
        if (other.scene == scene)
            row.pictures.push_back({other.file, fmt::format("{}-{}", row.name, other.label),
                                    scene + ", " + other.label});
    add(reference_cell(scene, results.settings()));
    return row;
}

Interval cost_ratio(const Results& results, const std::string& scene, const Method& a,
                    const Method& b, ErrorKind kind) {
    return ratio_interval(results.costs(scene, a, kind), results.costs(scene, b, kind));
}

std::string ratio_sentence(const Results& results, const std::string& scene, const Method& a,
                           const Method& b) {
    const auto ratio = [&](ErrorKind kind) {
        return interval_text(cost_ratio(results, scene, a, b, kind));
    };
    return fmt::format(
        "{} over {} in {}: relMSE x processor time {}, MSE x processor time {}, without the worst "
        "1% of pixels {}.",
        a.name, b.name, scene, ratio(&PictureError::rel_mse), ratio(&PictureError::mse),
        ratio(&PictureError::trimmed_mse));
}

}  // namespace sunfleck::engine

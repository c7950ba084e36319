// Figure 11: replica exchange, in a hall with two windows far apart.
#include "experiment/figures/common.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

const std::string kScene = "two-windows";

// One size for both, so that only the exchange differs. So small that a chain hardly steps from the
// light of one window into that of the other: with 0.1 it did so all the time, and exchange made no
// difference.
const std::vector<std::string> kSize = {"--mutation-size", "0.003"};

Method with_exchange() {
    return paper_method("with-exchange", kSize);
}

Method without_exchange() {
    Method method = paper_method("without-exchange", kSize);
    method.flags.insert(method.flags.end(), {"--replica-exchange", "off"});
    return method;
}

std::vector<Method> methods() {
    return {with_exchange(), without_exchange()};
}

/// What lies left of this share of the width is lit by the one window, mostly: the patches of sun
/// of the two lie on both sides.
constexpr double kBetween = 0.66;

/// The share of the picture's light that lies there.
double left_share(const std::vector<double>& luminance) {
    const auto side = static_cast<std::size_t>(
        std::lround(std::sqrt(static_cast<double>(luminance.size()))));  // pictures are square
    double left = 0;
    double all = 0;
    for (std::size_t i = 0; i < luminance.size(); ++i) {
        all += luminance[i];
        if (static_cast<double>(i % side) < kBetween * static_cast<double>(side))
            left += luminance[i];
    }
    return left / all;
}

ChartLine share_line(const Results& results, const Method& method) {
    ChartLine line{method.name, {}};
    std::vector<std::vector<double>> shares;
    std::vector<double> seconds;
    for (const Cell& cell : results.cells(kScene, method)) {
        const auto all = results.snapshots(cell);
        if (shares.size() < all.size()) shares.resize(all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            shares[i].push_back(left_share(read_measured(all[i].picture).luminance));
            if (seconds.size() <= i) seconds.push_back(all[i].cpu_seconds);
        }
    }
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const auto [low, high] = std::minmax_element(shares[i].begin(), shares[i].end());
        line.points.push_back({seconds[i], mean_interval(shares[i]).value, *low, *high});
    }
    return line;
}

Section fig11_section(const Results& results) {
    Section section;
    const double truth = left_share(results.reference(kScene).picture.luminance);
    Chart chart{"fig11",
                "Light of the left window, lowest to highest of all seeds",
                "processor seconds",
                "share",
                {},
                false};
    Table table{"fig11-shares",
                "Share of the left window's light, over seeds",
                {"method", "share at the end", "spread over seeds", "truth"},
                {}};
    for (const Method& method : methods()) {
        chart.lines.push_back(share_line(results, method));
        const ChartPoint& end = chart.lines.back().points.back();
        table.rows.push_back(
            {method.name, number_text(end.y), number_text(end.high - end.low), number_text(truth)});
    }
    ChartLine line{"reference", {}};
    for (const ChartPoint& p : chart.lines[0].points)
        line.points.push_back({p.x, truth, truth, truth});
    chart.lines.push_back(line);
    section.charts.push_back(chart);
    section.tables.push_back(table);
    section.tables.push_back(error_table(results, "fig11-errors", {kScene}, methods()));
    section.rows.push_back(picture_row(results, "fig11", kScene, methods()));
    return section;
}

}  // namespace

Figure fig11() {
    return {
        "fig11",
        "Figure 11: replica exchange",
        "Without exchange a chain stays in the light of one window for many mutations; exchange "
        "with uniform sampling takes it from one to the other.",
        {kScene},
        [](const RunSettings& s) { return seed_cells(s, {kScene}, methods()); },
        fig11_section};
}

}  // namespace sunfleck::engine

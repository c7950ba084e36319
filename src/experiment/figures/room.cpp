// Figures 5 and 6: the room over time.
#include "experiment/figures/common.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace sunfleck::engine {
namespace {

std::vector<Cell> room_cells(const RunSettings& settings) {
    return seed_cells(settings, {"room"}, sampler_methods());
}

/// The snapshot nearest to a share of the whole time, by the ratio of times.
const CellFacts& nearest(const std::vector<CellFacts>& all, double share) {
    const double wanted = share * all.back().cpu_seconds;
    const auto off = [&](const CellFacts& f) { return std::abs(std::log(f.cpu_seconds / wanted)); };
    return *std::min_element(all.begin(), all.end(), [&](const CellFacts& a, const CellFacts& b) {
        return off(a) < off(b);
    });
}

Section fig5_section(const Results& results) {
    Section section;
    for (const Method& method : sampler_methods()) {
        const auto all = results.snapshots({"room", method});
        PictureRow row{"fig5-" + method.name, "room", {}};
        for (const double share : {1.0 / 60, 0.25, 0.5, 1.0}) {
            const CellFacts& facts = nearest(all, share);
            row.pictures.push_back({facts.picture, fmt::format("{}-{:.0f}", row.name, 1000 * share),
                                    fmt::format("{}, {:.3g} s", method.name, facts.cpu_seconds)});
        }
        section.rows.push_back(row);
    }
    return section;
}

/// The line at x, straight between points on logarithmic axes; nothing beyond its ends.
std::optional<double> value_at(const ChartLine& line, double x) {
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const ChartPoint& a = line.points[i - 1];
        const ChartPoint& b = line.points[i];
        if (x < a.x || x > b.x || !(a.y > 0) || !(b.y > 0)) continue;
        const double t = b.x > a.x ? std::log(x / a.x) / std::log(b.x / a.x) : 0;
        return a.y * std::pow(b.y / a.y, t);
    }
    return {};
}

/// When `a` comes to lie below or above `b`: "never", or between which of its points.
std::string crossings(const ChartLine& a, const ChartLine& b) {
    std::string found;
    std::optional<bool> below;
    double last = 0;
    for (const ChartPoint& p : a.points) {
        const auto other = value_at(b, p.x);
        if (!other) continue;
        const bool now = p.y < *other;
        if (below && *below != now)
            found +=
                fmt::format("{}between {:.2g} and {:.2g} s", found.empty() ? "" : ", ", last, p.x);
        below = now;
        last = p.x;
    }
    return found.empty() ? "never" : found;
}

Section fig6_section(const Results& results) {
    Section section;
    section.tables.push_back(error_table(results, "fig6-errors", {"room"}, sampler_methods()));
    section.charts.push_back(error_chart(results, "fig6", "room", sampler_methods()));
    const auto& lines = section.charts[0].lines;
    double total = 0;
    for (const Method& method : sampler_methods())
        for (const Cell& cell : results.cells("room", method))
            total += results.facts(cell).cpu_seconds;
    section.findings.push_back(
        fmt::format("{} renders, {:.0f} s in all. The curve of paper crosses "
                    "that of random {}; that of adaptive {}.",
                    4 * results.settings().seeds, total, crossings(lines[2], lines[0]),
                    crossings(lines[3], lines[0])));
    return section;
}

}  // namespace

Figure fig5() {
    return {"fig5",
            "Figure 5: the room over time",
            "At 1, 15, 30 and 60 minutes the paper's method shows a cleaner room than uniform "
            "sampling; here at 1/60, 1/4, 1/2 and all of the time.",
            {"room"},
            room_cells,
            fig5_section};
}

Figure fig6() {
    return {
        "fig6",
        "Figure 6: error against time in the room",
        "The average relative error of the paper's method lies below uniform sampling's all the "
        "time.",
        {"room"},
        room_cells,
        fig6_section};
}

}  // namespace sunfleck::engine

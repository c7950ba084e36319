// Charts: axes, ticks, bands, lines, legend.
#include "experiment/chart.h"

#include "experiment/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr double kWidth = 640;
constexpr double kHeight = 400;
constexpr double kLeft = 76;
constexpr double kRight = 492;  // the legend stands beyond
constexpr double kTop = 34;
constexpr double kBottom = 346;

constexpr std::array<const char*, 8> kColours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                 "#E69F00", "#56B4E9", "#000000", "#8C8C00"};

/// One axis: from values to the picture.
struct Axis {
    bool log = true;
    double low = 0;
    double high = 0;
    double from = 0;  // where low lies in the picture
    double to = 0;

    bool shows(double value) const { return std::isfinite(value) && (!log || value > 0); }
    double scaled(double value) const { return log ? std::log10(value) : value; }
    double place(double value) const {
        return from + (scaled(value) - scaled(low)) / (scaled(high) - scaled(low)) * (to - from);
    }
    void take(double value) {
        if (!shows(value)) return;
        low = empty ? value : std::min(low, value);
        high = empty ? value : std::max(high, value);
        empty = false;
    }
    /// Some room beyond the ends; never of no length.
    void widen() {
        if (empty) low = high = 1;
        if (log) {
            low /= 1.15;
            high *= 1.15;
        } else {
            const double room = std::max(0.05 * (high - low), 1e-9 + 0.01 * std::abs(high));
            low -= room;
            high += room;
        }
    }
    std::vector<double> ticks() const;

    bool empty = true;
};

std::vector<double> Axis::ticks() const {
    std::vector<double> ticks;
    if (log) {
        const bool wide = high / low > 50;
        for (int e = static_cast<int>(std::floor(std::log10(low))); e <= std::log10(high); ++e)
            for (const double digit : {1.0, 2.0, 5.0}) {
                const double tick = digit * std::pow(10.0, e);
                if ((!wide || digit == 1) && tick >= low && tick <= high) ticks.push_back(tick);
            }
        return ticks;
    }
    const double rough = (high - low) / 5;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double step = power * (rough / power > 5 ? 10 : rough / power > 2 ? 5 : 2);
    const double first = std::ceil(low / step) * step;
    for (int i = 0; first + i * step <= high; ++i) {
        const double tick = first + i * step;
        ticks.push_back(std::abs(tick) < 1e-9 * step ? 0 : tick);
    }
    return ticks;
}

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y,
                       anchor, escaped(text));
}

std::string axes_svg(const Chart& chart, const Axis& x, const Axis& y) {
    std::string svg = fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#888\"/>\n",
        kLeft, kTop, kRight - kLeft, kBottom - kTop);
    for (const double tick : x.ticks()) {
        const double at = x.place(tick);
        svg += fmt::format("<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/>\n", at, kTop, kBottom);
        svg += text_at(at, kBottom + 16, "middle", number_text(tick));
    }
    for (const double tick : y.ticks()) {
        const double at = y.place(tick);
        svg += fmt::format("<path d=\"M{1} {0:.1f}H{2}\" stroke=\"#ddd\"/>\n", at, kLeft, kRight);
        svg += text_at(kLeft - 6, at + 4, "end", number_text(tick));
    }
    svg += text_at(kLeft, kTop - 12, "start", chart.title);
    svg += text_at((kLeft + kRight) / 2, kBottom + 38, "middle", chart.x_title);
    return svg + fmt::format(
                     "<text transform=\"translate(16 {:.1f}) rotate(-90)\" "
                     "text-anchor=\"middle\">{}</text>\n",
                     (kTop + kBottom) / 2, escaped(chart.y_title));
}

std::string line_svg(const ChartLine& line, const Axis& x, const Axis& y, const char* colour) {
    std::string path;
    std::string marks;
    std::string upper;
    std::string lower;
    for (const ChartPoint& p : line.points) {
        if (!x.shows(p.x) || !y.shows(p.y)) continue;
        const double at = x.place(p.x);
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at, y.place(p.y));
        marks += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n", at,
                             y.place(p.y), colour);
        if (!y.shows(p.low) || !y.shows(p.high)) continue;
        upper += fmt::format("{}{:.1f} {:.1f}", upper.empty() ? "M" : "L", at, y.place(p.high));
        lower.insert(0, fmt::format("L{:.1f} {:.1f}", at, y.place(p.low)));
    }
    if (path.empty()) return {};
    return fmt::format(
        "<path d=\"{0}{1}Z\" fill=\"{2}\" opacity=\"0.15\"/>\n"
        "<path d=\"{3}\" fill=\"none\" stroke=\"{2}\" stroke-width=\"1.8\"/>\n{4}",
        upper.empty() ? "M0 0" : upper, lower, colour, path, marks);
}

}  // namespace

std::string chart_svg(const Chart& chart) {
    Axis x{true, 0, 0, kLeft, kRight};
    Axis y{chart.log_y, 0, 0, kBottom, kTop};
    for (const ChartLine& line : chart.lines)
        for (const ChartPoint& p : line.points) {
            if (!x.shows(p.x) || !y.shows(p.y)) continue;
            x.take(p.x);
            for (const double value : {p.y, p.low, p.high}) y.take(value);
        }
    x.widen();
    y.widen();
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"sans-serif\" font-size=\"12\" role=\"img\" "
        "aria-label=\"{2}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
        kWidth, kHeight, escaped(chart.title));
    svg += axes_svg(chart, x, y);
    for (std::size_t i = 0; i < chart.lines.size(); ++i) {
        const char* const colour = kColours.at(i % kColours.size());
        const double row = kTop + 10 + 18 * static_cast<double>(i);
        svg += line_svg(chart.lines[i], x, y, colour);
        svg += fmt::format("<path d=\"M{} {}h16\" stroke=\"{}\" stroke-width=\"3\"/>\n",
                           kRight + 10, row - 4, colour);
        svg += text_at(kRight + 32, row, "start", chart.lines[i].label);
    }
    return svg + "</svg>\n";
}

}  // namespace sunfleck::engine

// Line charts as SVG, on logarithmic axes, with bands.
#pragma once

#include <string>
#include <vector>

namespace sunfleck::engine {

struct ChartPoint {
    double x = 0;
    double y = 0;
    double low = 0;  // of the band
    double high = 0;
};

struct ChartLine {
    std::string label;
    std::vector<ChartPoint> points;  // x ascending
};

struct Chart {
    std::string name;  // of its file
    std::string title;
    std::string x_title;
    std::string y_title;
    std::vector<ChartLine> lines;
    bool log_y = true;  // x is always logarithmic
};

/// A whole SVG file, 640 x 400. Points that an axis cannot show (not positive on a logarithmic
/// one, not finite) are left out. Up to eight lines have colours of their own, from Okabe and Ito,
/// Color Universal Design (2008): told apart by all eyes.
std::string chart_svg(const Chart& chart);

}  // namespace sunfleck::engine

// Line charts as SVG, with logarithmic axes and bands.
#pragma once

#include <string>
#include <vector>

namespace sunfleck::engine {

struct ChartPoint {
    double x = 0;
    double y = 0;
    double low = 0;  // lower end of the band
    double high = 0;
};

struct ChartLine {
    std::string label;
    std::vector<ChartPoint> points;  // ascending x
};

struct Chart {
    std::string name;  // of its file
    std::string title;
    std::string x_title;
    std::string y_title;
    std::vector<ChartLine> lines;
    bool log_y = true;  // x is always logarithmic
};

/// Returns a complete SVG file of 640 x 400. Points that an axis cannot show (not positive on a
/// logarithmic one, not finite) are left out. Up to eight lines have the colours of Okabe and Ito,
/// Color Universal Design (2008), which colour-blind viewers can distinguish.
std::string chart_svg(const Chart& chart);

}  // namespace sunfleck::engine

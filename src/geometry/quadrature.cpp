// Gauss-Legendre quadrature on a grid of panels.
#include "geometry/quadrature.h"

#include "geometry/sweep.h"

namespace sunfleck::engine {
namespace {

struct Node {
    double place;  // in (0, 1)
    double weight;
};

// Four points, exact to degree 7. Source: Abramowitz and Stegun, table 25.4, moved to (0, 1).
constexpr std::array<Node, 4> kNodes{{{0.06943184420297371, 0.17392742256872693},
                                      {0.33000947820757187, 0.32607257743127307},
                                      {0.66999052179242813, 0.32607257743127307},
                                      {0.93056815579702629, 0.17392742256872693}}};

double on_panels(const std::function<double(double, double)>& f, const Interval& x,
                 const Interval& y, int panels) {
    const double width = (x.to - x.from) / panels;
    const double height = (y.to - y.from) / panels;
    double sum = 0;
    for (int i = 0; i < panels; ++i)
        for (const Node& across : kNodes) {
            const double at_x = x.from + (i + across.place) * width;
            double row = 0;
            for (int j = 0; j < panels; ++j)
                for (const Node& up : kNodes)
                    row += up.weight * f(at_x, y.from + (j + up.place) * height);
            sum += across.weight * row;
        }
    return sum * width * height;
}

}  // namespace

double integrate_rectangle(const std::function<double(double, double)>& f, const Interval& x,
                           const Interval& y, double tolerance) {
    double coarse = on_panels(f, x, y, 4);
    for (int panels = 8;; panels *= 2) {
        const double fine = on_panels(f, x, y, panels);
        if (panels >= 512 || std::abs(fine - coarse) <= tolerance * std::abs(fine)) return fine;
        coarse = fine;
    }
}

/// Newton's method on the cosine, from the float function's value through half the angle.
double arc_cosine(double x) {
    if (x >= 1) return 0;
    if (x <= -1) return kPiDouble;
    const double half = std::asin(static_cast<float>(std::sqrt((1 - std::abs(x)) / 2)));
    double angle = x >= 0 ? 2 * half : kPiDouble - 2 * half;
    for (int step = 0; step < 3; ++step) {
        const SinCos now = sin_cos(angle);
        if (now.sin == 0) break;
        angle += (now.cos - x) / now.sin;
    }
    return angle;
}

}  // namespace sunfleck::engine

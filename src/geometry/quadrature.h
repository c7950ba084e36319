// Integration of smooth functions over rectangles: Gauss-Legendre panels, doubled until converged.
#pragma once

#include "math/vector.h"

#include <array>
#include <cmath>
#include <functional>

namespace sunfleck::engine {

struct Interval {
    double from = 0;
    double to = 0;
};

/// Returns the integral of f(x, y) over the rectangle. @param tolerance  relative change that ends
/// it.
double integrate_rectangle(const std::function<double(double, double)>& f, const Interval& x,
                           const Interval& y, double tolerance);

/// Returns the arc cosine in double by + - * / and sqrt alone, in [0, pi]. @param x  in [-1, 1].
double arc_cosine(double x);

}  // namespace sunfleck::engine

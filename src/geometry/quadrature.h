// Integrals of smooth functions over rectangles: Gauss-Legendre panels, doubled until they agree.
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

/// Integral of f(x, y) over the rectangle. @param tolerance  relative change at which to stop.
double integrate_rectangle(const std::function<double(double, double)>& f, const Interval& x,
                           const Interval& y, double tolerance);

/// Arc cosine in double from + - * / and square roots, in [0, pi]. @param x  in [-1, 1].
double arc_cosine(double x);

}  // namespace sunfleck::engine

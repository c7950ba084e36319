// Levenberg-Marquardt on three coefficients, led from grey to the colour in steps of saturation.
#include "math/sigmoid_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sunfleck::engine {

template <class Real>
Real sigmoid(Real x) {
    const Real root = std::sqrt(1 + x * x);
    const Real small = Real(0.5) / (root * (root + std::abs(x)));
    return x < 0 ? small : 1 - small;
}

template float sigmoid(float);
template double sigmoid(double);

namespace {

using Rows = std::array<Triple, 3>;

/// What a reflectance of one at t adds to X, Y, Z under D65, as a share of the white.
struct Node {
    double t = 0;
    Triple share{};
};
using Nodes = std::vector<Node>;

double t_of(double nm) {
    return (nm - kMiddleNm) / kHalfRangeNm;
}

/// At every nanometre.
const Nodes& fine_nodes() {
    static const Nodes built = [] {
        Nodes nodes(kVisibleCount);
        const Triple white_xyz = xyz_of_rgb({1, 1, 1});
        for (std::size_t i = 0; i < kVisibleCount; ++i) {
            nodes[i] = {t_of(static_cast<double>(i) + kFirstNm), xyz_of_rgb(rgb_response()[i])};
            for (std::size_t k = 0; k < 3; ++k) nodes[i].share[k] *= white()[i] / white_xyz[k];
        }
        return nodes;
    }();
    return built;
}

Nodes every_fifth(const Nodes& fine) {
    constexpr std::size_t kStep = 5;
    Nodes nodes((kVisibleCount - 1) / kStep + 1);
    for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n].t = fine[n * kStep].t;
    for (std::size_t i = 0; i < kVisibleCount; ++i) {
        const std::size_t below = std::min(i / kStep, nodes.size() - 2);
        const double part = static_cast<double>(i - below * kStep) / kStep;
        for (std::size_t k = 0; k < 3; ++k) {
            nodes[below].share[k] += fine[i].share[k] * (1 - part);
            nodes[below + 1].share[k] += fine[i].share[k] * part;
        }
    }
    return nodes;
}

/// Every 5 nm: the shares of a reflectance that is linear in between, to be fitted faster.
const Nodes& coarse_nodes() {
    static const Nodes built = every_fifth(fine_nodes());
    return built;
}

/// Cube root by Newton's method; for value in about [0.008, 2].
double cube_root(double value) {
    double root = 0.3 + 0.7 * value;
    for (int step = 0; step < 8; ++step) root -= (root - value / (root * root)) / 3;
    return root;
}

/// The compressed scale of CIELab, and its slope.
struct Lightness {
    double value = 0;
    double slope = 0;
};

Lightness lightness(double share) {
    constexpr double kKnee = 6.0 / 29;
    if (share <= kKnee * kKnee * kKnee) {
        const double slope = 1 / (3 * kKnee * kKnee);
        return {share * slope + 4.0 / 29, slope};
    }
    const double root = cube_root(share);
    return {root, 1 / (3 * root * root)};
}

/// CIELab of shares of the white (X/Xn, Y/Yn, Z/Zn), and its derivative by each share.
struct Lab {
    Triple value{};
    Rows slope{};
};

Lab lab(const Triple& share) {
    const Lightness x = lightness(share[0]);
    const Lightness y = lightness(share[1]);
    const Lightness z = lightness(share[2]);
    return {{116 * y.value - 16, 500 * (x.value - y.value), 200 * (y.value - z.value)},
            {Triple{0, 116 * y.slope, 0}, Triple{500 * x.slope, -500 * y.slope, 0},
             Triple{0, 200 * y.slope, -200 * z.slope}}};
}

Triple target_lab(const Triple& rgb) {
    Triple share = xyz_of_rgb(rgb);
    const Triple white_xyz = xyz_of_rgb({1, 1, 1});
    for (std::size_t k = 0; k < 3; ++k) share[k] /= white_xyz[k];
    return lab(share).value;
}

/// What a step needs to know of one set of coefficients (of 1, t, t^2).
struct Trial {
    Triple coefficients{};
    Triple residual{};
    Rows jacobian{};  // [residual][coefficient]
    double cost = 0;
};

Trial evaluate(const Nodes& nodes, const Triple& c, const Triple& target) {
    Triple share{};
    Rows by_coefficient{};  // [share][coefficient]
    for (const Node& node : nodes) {
        const double t = node.t;
        const double x = c[0] + t * (c[1] + t * c[2]);
        const double root = std::sqrt(1 + x * x);
        const double value = sigmoid(x);
        const double slope = 0.5 / (root * root * root);
        for (std::size_t k = 0; k < 3; ++k) {
            const double weight = node.share[k];
            share[k] += weight * value;
            by_coefficient[k][0] += weight * slope;
            by_coefficient[k][1] += weight * slope * t;
            by_coefficient[k][2] += weight * slope * t * t;
        }
    }
    const Lab seen = lab(share);
    Trial trial{c, {}, {}, 0};
    for (std::size_t r = 0; r < 3; ++r) {
        trial.residual[r] = seen.value[r] - target[r];
        trial.cost += trial.residual[r] * trial.residual[r];
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t j = 0; j < 3; ++j)
                trial.jacobian[r][j] += seen.slope[r][k] * by_coefficient[k][j];
    }
    return trial;
}

/// Solves m x = v for a positive definite m, by elimination without pivots.
Triple solve(Rows m, Triple v) {
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = k + 1; i < 3; ++i) {
            const double factor = m[i][k] / m[k][k];
            for (std::size_t j = k; j < 3; ++j) m[i][j] -= factor * m[k][j];
            v[i] -= factor * v[k];
        }
    }
    for (std::size_t k = 3; k-- > 0;) {
        for (std::size_t j = k + 1; j < 3; ++j) v[k] -= m[k][j] * v[j];
        v[k] /= m[k][k];
    }
    return v;
}

/// The damped Gauss-Newton step.
Triple step_from(const Trial& at, double damping) {
    Rows normal{};
    Triple downhill{};
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t i = 0; i < 3; ++i) {
            downhill[i] -= at.jacobian[r][i] * at.residual[r];
            for (std::size_t j = 0; j < 3; ++j)
                normal[i][j] += at.jacobian[r][i] * at.jacobian[r][j];
        }
    }
    for (std::size_t i = 0; i < 3; ++i) normal[i][i] += damping * normal[i][i] + 1e-14;
    return solve(normal, downhill);
}

/// Descends from `start` until the colour is `enough` (a squared CIELab distance) near.
Triple descend(const Nodes& nodes, const Triple& start, const Triple& target, double enough,
               int max_steps) {
    Trial best = evaluate(nodes, start, target);
    double damping = 1e-3;
    for (int step = 0; step < max_steps && best.cost > enough && damping < 1e12; ++step) {
        const Triple move = step_from(best, damping);
        Triple next = best.coefficients;
        for (std::size_t i = 0; i < 3; ++i) next[i] += move[i];
        const Trial trial = evaluate(nodes, next, target);
        if (trial.cost < best.cost) {
            best = trial;
            damping *= 0.2;
        } else {
            damping *= 6;
        }
    }
    return best.coefficients;
}

/// From grey to the colour. @return coefficients of 1, t, t^2.
Triple fit_from_grey(const Nodes& nodes, const Triple& rgb) {
    constexpr std::array kSaturations{0.25, 0.5, 0.75, 0.9};
    const double grey = xyz_of_rgb(rgb)[1];
    Triple c{(grey - 0.5) / std::sqrt(grey * (1 - grey)), 0, 0};
    for (const double saturation : kSaturations) {
        Triple nearer{};
        for (std::size_t k = 0; k < 3; ++k) nearer[k] = grey + saturation * (rgb[k] - grey);
        c = descend(nodes, c, target_lab(nearer), 1e-4, 30);
    }
    return descend(nodes, c, target_lab(rgb), 1e-12, 200);
}

}  // namespace

Triple fit_sigmoid(const Triple& rgb) {
    const Triple c = fit_from_grey(fine_nodes(), rgb);
    const double b = c[1] / kHalfRangeNm;
    const double a = c[2] / (kHalfRangeNm * kHalfRangeNm);
    return {a, b - 2 * a * kMiddleNm, c[0] + kMiddleNm * (a * kMiddleNm - b)};
}

Triple fit_sigmoid_coarsely(const Triple& rgb, const Triple* near) {
    const Nodes& nodes = coarse_nodes();
    return near == nullptr ? fit_from_grey(nodes, rgb)
                           : descend(nodes, *near, target_lab(rgb), 1e-10, 30);
}

}  // namespace sunfleck::engine

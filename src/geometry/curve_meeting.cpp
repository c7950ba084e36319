// Where lines meet pieces of curves: cut until straight, then solved for in double.
//
// Everything happens in the frame of the line, which is the z axis there: x and y say how far the
// curve is, z where. A part whose box in x and y, widened by half the width, does not hold the
// origin is passed over. What is left is solved to rounding, so the surfaces do not depend on how
// curves were cut. Source for the recursion: Nakamaru and Ohno, Ray Tracing for Curves Primitive
// (WSCG 2002).
#include "geometry/curve_piece.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck {
namespace {

/// Part ends belong to both neighbours, this far out, so that no line slips through.
constexpr double kSlack = 1e-9;
/// How far from its part, in u, a search may go before it comes back.
constexpr double kStray = 0.5;

class Search {
public:
    using Found = std::array<CurveMeeting, CurvePiece::kMostCrossings>;

    Search(CurvePiece piece, const Vec3d& origin, const Vec3d& direction, Found& found)
        : piece_(std::move(piece)), found_(found), length_(direction.length()) {
        const Vec3d z = direction / length_;
        const Vec3d aside = std::abs(z.x) < 0.7 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
        const Vec3d x = aside.cross(z).normalized();
        const Vec3d y = z.cross(x);
        const auto turned = [&](const Vec3d& v) { return Vec3d(v.dot(x), v.dot(y), v.dot(z)); };
        for (Vec3d& p : piece_.curve) {
            p = turned(p - origin);
            size_ = std::max(size_, p.length());
        }
        for (Vec3d& n : piece_.normal) n = turned(n);
    }

    std::size_t run() {
        const Bezier part = part_of(piece_.curve, piece_.from, piece_.to);
        int depth = 0;
        const double widest = std::max(piece_.width_at(piece_.from), piece_.width_at(piece_.to));
        const double straight = 0.05 * widest;
        double bend = std::max((part[0] - part[1] * 2 + part[2]).length(),
                               (part[1] - part[2] * 2 + part[3]).length());
        for (; bend > straight && depth < 10; bend /= 4) ++depth;
        if (widest > 0) descend(part, piece_.from, piece_.to, depth);
        return count_;
    }

private:
    void descend(const Bezier& part, double from, double to, int depth) {
        const double reach = std::max(piece_.width_at(from), piece_.width_at(to)) / 2;
        for (int axis = 0; axis < 2; ++axis) {
            const auto [low, high] =
                std::minmax({part[0][axis], part[1][axis], part[2][axis], part[3][axis]});
            if (!(low <= reach && high >= -reach)) return;
        }
        if (depth > 0) {
            const double middle = 0.5 * (from + to);
            descend(part_of(part, 0, 0.5), from, middle, depth - 1);
            descend(part_of(part, 0.5, 1), middle, to, depth - 1);
            return;
        }
        if (piece_.kind == CurveKind::flat) return meet_flat(from, to);
        if (piece_.kind == CurveKind::ribbon) return meet_ribbon(from, to);
        meet_tube(part[0], part[3], from, to);
    }

    void add(double z, double u, double across) {
        if (count_ < found_.size() && std::isfinite(z))
            found_.at(count_++) = {z / length_, u, across};
    }

    /// The root between two ends at which f has different signs: bisection with secants (the
    /// Illinois rule).
    template <class F>
    static double root_between(double a, double fa, double b, double fb, const F& f) {
        for (int step = 0; step < 60 && b - a > 1e-15; ++step) {
            const double secant = (a * fb - b * fa) / (fb - fa);
            const double c = step % 4 == 3 || !(secant > a && secant < b) ? 0.5 * (a + b) : secant;
            const double fc = f(c);
            if (fc == 0) return c;
            if ((fc < 0) == (fa < 0)) {
                a = c;
                fa = fc;
                fb *= 0.5;
            } else {
                b = c;
                fb = fc;
                fa *= 0.5;
            }
        }
        return 0.5 * (a + b);
    }

    /// The strip faces the line: it is met where the curve comes nearest.
    void meet_flat(double from, double to) {
        const auto slope = [&](double u) {
            const CurvePoint c = evaluate(piece_.curve, u);
            return c.position.x * c.first.x + c.position.y * c.first.y;
        };
        const double at_from = slope(from);
        const double at_to = slope(to);
        if (!(at_from <= 0 && at_to >= 0)) return;
        const double u = root_between(from, at_from, to, at_to, slope);
        const CurvePoint c = evaluate(piece_.curve, u);
        const Vec2d aside(-c.first.y, c.first.x);
        const double across = -(c.position.x * aside.x + c.position.y * aside.y) / aside.length();
        if (std::abs(across) <= piece_.width_at(u) / 2) add(c.position.z, u, across);
    }

    /// A ruled surface: the line meets the ruling that passes it at no distance.
    void meet_ribbon(double from, double to) {
        const auto distance = [&](double u) {
            const CurvePoint c = evaluate(piece_.curve, u);
            const Vec3d b = piece_.across_ribbon(c, u);
            return c.position.x * b.y - c.position.y * b.x;
        };
        const double at_from = distance(from);
        const double at_to = distance(to);
        if ((at_from < 0) == (at_to < 0) && at_from != 0 && at_to != 0) return;
        const double u = root_between(from, at_from, to, at_to, distance);
        const CurvePoint c = evaluate(piece_.curve, u);
        const Vec3d b = piece_.across_ribbon(c, u);
        const double s = -(c.position.x * b.x + c.position.y * b.y) / (b.x * b.x + b.y * b.y);
        if (std::abs(s) <= piece_.width_at(u) / 2) add(c.position.z + s * b.z, u, s);
    }

    /// Starts from the straight cylinder around the chord, made wider by more than the curve may
    /// bulge: from outside, Newton's method tends to the nearer of two roots that lie close.
    void meet_tube(const Vec3d& start, const Vec3d& end, double from, double to) {
        const Vec3d chord = end - start;
        const double chord2 = chord.length2();
        const Vec3d off = -start - chord * (-start.dot(chord) / chord2);
        const Vec3d along = Vec3d(0, 0, 1) - chord * (chord.z / chord2);
        const double along2 = along.length2();
        if (!(along2 > 1e-20)) return;
        const double radius = piece_.width_at(0.5 * (from + to)) / 2;
        const double middle = -off.dot(along) / along2;
        const double depth = radius * radius - (off + along * middle).length2();
        const double wider = depth + 0.25 * radius * radius;
        if (!(wider > 0)) return;
        const double half = std::sqrt(wider / along2);
        for (const double z : {middle - half, middle + half}) {
            const double share = (Vec3d(0, 0, z) - start).dot(chord) / chord2;
            refine_tube(z, from + (to - from) * std::clamp(share, -1.0, 2.0), {from, to});
        }
    }

    /// Newton's method for (p - C) . C' = 0 and |p - C| = radius, p on the line. The last step
    /// squares what the one before left, or comes down to rounding.
    void refine_tube(double z, double u, const Vec2d& range) {
        const double slope = (piece_.width[1] - piece_.width[0]) / 2;
        bool converged = false;
        for (int step = 0; step < 12 && !converged; ++step) {
            const CurvePoint c = evaluate(piece_.curve, u);
            const Vec3d apart = Vec3d(0, 0, z) - c.position;
            const double radius = piece_.width_at(u) / 2;
            const double g = apart.dot(c.first);
            const double h = (apart.length2() - radius * radius) / 2;
            const double g_u = apart.dot(c.second) - c.first.length2();
            const double h_u = -g - radius * slope;
            const double determinant = c.first.z * h_u - g_u * apart.z;
            const double dz = (g_u * h - g * h_u) / determinant;
            const double du = (g * apart.z - c.first.z * h) / determinant;
            if (!std::isfinite(dz) || !std::isfinite(du)) return;
            z += dz;
            u += du;
            if (u < range.x - kStray || u > range.y + kStray) return;
            const double tolerance = std::max(1e-9 * radius, 1e-13 * size_);
            converged = std::abs(dz) <= tolerance && std::abs(du) * c.first.length() <= tolerance;
        }
        if (!converged || u < range.x - kSlack || u > range.y + kSlack) return;
        const CurvePoint c = evaluate(piece_.curve, u);
        const Vec2d aside(-c.first.y, c.first.x);
        add(z, u, -(c.position.x * aside.x + c.position.y * aside.y) / aside.length());
    }

    CurvePiece piece_;
    Found& found_;
    std::size_t count_ = 0;
    double length_;
    double size_ = 0;  // of the numbers that are added: 2^-53 of it is lost
};

}  // namespace

std::size_t meet(const CurvePiece& piece, const Vec3d& origin, const Vec3d& direction,
                 std::array<CurveMeeting, CurvePiece::kMostCrossings>& found) {
    return Search(piece, origin, direction, found).run();
}

}  // namespace sunfleck

// Where lines meet pieces of curves: cut until straight, then solved for in double.
//
// Everything happens in the frame of the line, which is the z axis there: x and y say how far the
// curve is, z where. A part whose box in x and y, widened by half the width, does not hold the
// origin is passed over, and so is one behind the line's start. What is left is solved to rounding,
// so the surfaces do not depend on how curves were cut. Source for the recursion: Nakamaru and
// Ohno, Ray Tracing for Curves Primitive (WSCG 2002).
#include "geometry/curve_piece.h"
#include "geometry/sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Part ends belong to both neighbours, this far out, so that no line slips through.
constexpr double kSlack = 1e-9;
/// How far from its part, in u, a search may go before it comes back.
constexpr double kStray = 0.5;

/// A cubic by its coefficients: evaluated often, so with few operations.
class Cubic {
public:
    Cubic() = default;
    explicit Cubic(const Bezier& p)
        : c0_(p[0]),
          c1_((p[1] - p[0]) * 3),
          c2_((p[0] - p[1] * 2 + p[2]) * 3),
          c3_(p[3] - p[0] + (p[1] - p[2]) * 3) {}

    CurvePoint at(double u) const {
        return {((c3_ * u + c2_) * u + c1_) * u + c0_, (c3_ * (3 * u) + c2_ * 2) * u + c1_,
                c3_ * (6 * u) + c2_ * 2};
    }

private:
    Vec3d c0_{0};
    Vec3d c1_{0};
    Vec3d c2_{0};
    Vec3d c3_{0};
};

/// Both halves of a curve (de Casteljau).
std::array<Bezier, 2> halves_of(const Bezier& p) {
    const auto middle = [](const Vec3d& a, const Vec3d& b) { return (a + b) * 0.5; };
    const Vec3d p01 = middle(p[0], p[1]);
    const Vec3d p12 = middle(p[1], p[2]);
    const Vec3d p23 = middle(p[2], p[3]);
    const Vec3d p012 = middle(p01, p12);
    const Vec3d p123 = middle(p12, p23);
    const Vec3d p0123 = middle(p012, p123);
    return {Bezier{p[0], p01, p012, p0123}, Bezier{p0123, p123, p23, p[3]}};
}

/// The greater of a curve's second differences: the curve stays within 3/4 of it from its chord.
double bend_of(const Bezier& p) {
    return std::sqrt(
        std::max((p[0] - p[1] * 2 + p[2]).length2(), (p[1] - p[2] * 2 + p[3]).length2()));
}

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
        if (piece_.kind == CurveKind::ribbon) {
            for (Vec3d& n : piece_.normal) n = turned(n);
            turn_ = sin_cos(piece_.turn);
        }
        cubic_ = Cubic(piece_.curve);
    }

    std::size_t run() {
        const Bezier part = part_of(piece_.curve, piece_.from, piece_.to);
        int depth = 0;
        const double widest = std::max(piece_.width_at(piece_.from), piece_.width_at(piece_.to));
        const double straight = 0.05 * widest;
        for (double bend = bend_of(part); bend > straight && depth < 10; bend /= 4) ++depth;
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
        const double ahead = std::max({part[0].z, part[1].z, part[2].z, part[3].z});
        if (!(ahead >= -reach - 1e-6 * size_)) return;
        if (depth > 0) {
            const double middle = 0.5 * (from + to);
            const auto halves = halves_of(part);
            descend(halves[0], from, middle, depth - 1);
            descend(halves[1], middle, to, depth - 1);
            return;
        }
        if (piece_.kind == CurveKind::flat) return meet_flat(from, to);
        if (piece_.kind == CurveKind::ribbon) return meet_ribbon(from, to);
        meet_tube(part, from, to);
    }

    void add(double z, double u, double across) {
        if (count_ < found_.size() && std::isfinite(z))
            found_.at(count_++) = {z / length_, u, across};
    }

    /// The root between two ends at which f has different signs: bisection with secants (the
    /// Illinois rule).
    template <class F>
    static double root_between(double a, double fa, double b, double fb, const F& f) {
        double last = a;
        for (int step = 0; step < 60 && b - a > 1e-15; ++step) {
            const double secant = (a * fb - b * fa) / (fb - fa);
            const double c = step % 4 == 3 || !(secant > a && secant < b) ? 0.5 * (a + b) : secant;
            const double fc = f(c);
            if (fc == 0 || std::abs(c - last) < 1e-15) return c;
            last = c;
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
            const CurvePoint c = cubic_.at(u);
            return c.position.x * c.first.x + c.position.y * c.first.y;
        };
        const double at_from = slope(from);
        const double at_to = slope(to);
        if (!(at_from <= 0 && at_to >= 0)) return;
        const double u = root_between(from, at_from, to, at_to, slope);
        const CurvePoint c = cubic_.at(u);
        const Vec2d aside(-c.first.y, c.first.x);
        const double across = -(c.position.x * aside.x + c.position.y * aside.y) / aside.length();
        if (std::abs(across) <= piece_.width_at(u) / 2) add(c.position.z, u, across);
    }

    /// The normal of a ribbon, of any length: sin((1 - u) t) by the angles t and u t alone.
    Vec3d normal_at(double u) const {
        if (!(piece_.turn > 0)) return piece_.normal[0] * (1 - u) + piece_.normal[1] * u;
        const SinCos part = sin_cos(u * piece_.turn);
        return piece_.normal[0] * (turn_.sin * part.cos - turn_.cos * part.sin) +
               piece_.normal[1] * part.sin;
    }

    /// A ruled surface: the line meets the ruling that passes it at no distance.
    void meet_ribbon(double from, double to) {
        const auto distance = [&](double u) {
            const CurvePoint c = cubic_.at(u);
            const Vec3d b = normal_at(u).cross(c.first);
            return c.position.x * b.y - c.position.y * b.x;
        };
        const double at_from = distance(from);
        const double at_to = distance(to);
        if ((at_from < 0) == (at_to < 0) && at_from != 0 && at_to != 0) return;
        const double u = root_between(from, at_from, to, at_to, distance);
        const CurvePoint c = cubic_.at(u);
        const Vec3d b = piece_.across_ribbon(c, u);
        const double s = -(c.position.x * b.x + c.position.y * b.y) / (b.x * b.x + b.y * b.y);
        if (std::abs(s) <= piece_.width_at(u) / 2) add(c.position.z + s * b.z, u, s);
    }

    /// Starts from the straight cylinder around the chord, made wider by more than the curve may
    /// bulge: from outside, Newton's method tends to the nearer of two roots that lie close.
    void meet_tube(const Bezier& part, double from, double to) {
        const Vec3d& start = part[0];
        const Vec3d chord = part[3] - start;
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
        const double stray = stray_of(part, radius, half);
        for (const double z : {middle - half, middle + half}) {
            const double share = (Vec3d(0, 0, z) - start).dot(chord) / chord2;
            if (!(share > -stray && share < 1 + stray)) continue;
            refine_tube(z, from + (to - from) * std::clamp(share, -1.0, 2.0), {from, to});
        }
    }

    /// How far beyond an end, in parts of the chord, the straight cylinder may be met where the
    /// tube is met within: the line meets both as far apart as `half` at most, and the planes
    /// across the curve are turned against those across the chord. Rather too far: then a search is
    /// in vain.
    static double stray_of(const Bezier& part, double radius, double half) {
        const Vec3d chord = part[3] - part[0];
        const double along = std::abs(chord.z) * half;
        const double bend = bend_of(part);
        return 0.1 + (along + 3 * bend * radius + bend * chord.length()) / chord.length2();
    }

    /// Newton's method for (p - C) . C' = 0 and |p - C| = radius, p on the line. The last step
    /// squares what the one before left, or comes down to rounding. Steps that have become small do
    /// not come back from beyond the ends.
    void refine_tube(double z, double u, const Vec2d& range) {
        const double slope = (piece_.width[1] - piece_.width[0]) / 2;
        const double near = 0.25 * (range.y - range.x);
        for (int step = 0; step < 12; ++step) {
            const CurvePoint c = cubic_.at(u);
            const Vec3d apart = Vec3d(0, 0, z) - c.position;
            const double radius = piece_.width_at(u) / 2;
            const double speed2 = c.first.length2();
            const double g = apart.dot(c.first);
            const double h = (apart.length2() - radius * radius) / 2;
            const double g_u = apart.dot(c.second) - speed2;
            const double h_u = -g - radius * slope;
            const double scale = 1 / (c.first.z * h_u - g_u * apart.z);
            const double dz = (g_u * h - g * h_u) * scale;
            const double du = (g * apart.z - c.first.z * h) * scale;
            z += dz;
            u += du;
            const double beyond = std::max(range.x - u, u - range.y);
            if (!(beyond < kStray)) return;
            if (std::abs(du) < near && beyond > std::max(2 * std::abs(du), kSlack)) return;
            const double tolerance = std::max(1e-7 * radius, 1e-13 * size_);
            if (std::abs(dz) > tolerance || du * du * speed2 > tolerance * tolerance) continue;
            if (beyond > kSlack) return;
            const Vec2d aside(-c.first.y, c.first.x);
            return add(z, u, -(c.position.x * aside.x + c.position.y * aside.y) / aside.length());
        }
    }

    CurvePiece piece_;
    Cubic cubic_;        // piece_.curve
    SinCos turn_{0, 1};  // of the angle between a ribbon's normals
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

}  // namespace sunfleck::engine

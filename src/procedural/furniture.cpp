// Cushions are superellipsoids, turned work is turned, the rest is boards.

#include "procedural/furniture.h"

#include "math/trigonometry.h"
#include "procedural/extrusion.h"
#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/scene_random.h"
#include "procedural/surfaces.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

Mesh cushion(const Vec3d& half, const Vec3d& middle, float power = 0.4F) {
    return placed(superellipsoid(half, power, 75, 39), at(middle));
}

Mesh board(const Vec3d& low, const Vec3d& high) {
    return box_mesh(rounded_point(low), rounded_point(high));
}

constexpr std::array<double, 5> kBoards = {0.06, 0.46, 0.84, 1.22, 1.6};

}  // namespace

Seat sofa(int places) {
    constexpr double kPlace = 0.62;
    const double half = kPlace * places / 2;
    Seat seat;
    seat.cloth = cushion({half + 0.2, 0.42, 0.13}, {0, -0.45, 0.24}, 0.2F);
    seat.cloth.append(cushion({half + 0.2, 0.13, 0.36}, {0, -0.12, 0.45}, 0.25F));
    for (const double side : {-1.0, 1.0})
        seat.cloth.append(cushion({0.11, 0.43, 0.27}, {side * (half + 0.12), -0.45, 0.38}, 0.35F));
    for (int i = 0; i < places; ++i) {
        const double x = kPlace * (i + 0.5) - half;
        seat.cloth.append(cushion({kPlace / 2 - 0.004, 0.36, 0.09}, {x, -0.53, 0.43}));
        const Placement leaning =
            at({x, -0.3, 0.7}) * tilted(0.03, Vec3d(0)) * tilted(0.25, Vec3d(0));
        seat.cloth.append(
            placed(superellipsoid({kPlace / 2 - 0.01, 0.26, 0.1}, 0.45F, 75, 39), leaning));
    }
    for (const double x : {-half - 0.1, half + 0.1})
        for (const double y : {-0.8, -0.1})
            seat.wood.append(placed(
                revolve({{0, 0.002}, {0.02, 0.002}, {0.035, 0.15}, {0, 0.15}}, 24), at({x, y, 0})));
    return seat;
}

Mesh round_table() {
    Profile top = {{0, 0.405}, {0.5, 0.405}};
    append_bezier(top, {{{0.53, 0.41}, {0.53, 0.44}, {0.5, 0.44}}}, 8);
    top.push_back({0, 0.44});
    Mesh table = revolve(top, 96);
    Profile leg = {{0, 0.002}, {0.018, 0.002}};
    append_bezier(leg, {{{0.03, 0.1}, {0.03, 0.12}, {0.018, 0.16}}}, 8);
    append_bezier(leg, {{{0.03, 0.25}, {0.035, 0.3}, {0.03, 0.42}}}, 8);
    leg.push_back({0, 0.42});
    for (int i = 0; i < 3; ++i) {
        const SinCos t = sin_cos_2pi(i / 3.0 + 0.2);
        table.append(placed(revolve(leg, 32), at({0.38 * t.cos, 0.38 * t.sin, 0})));
    }
    return table;
}

Mesh shelves() {
    Mesh wood = board({-0.6, -0.3, 0.001}, {-0.57, 0, 2});
    wood.append(board({0.57, -0.3, 0.001}, {0.6, 0, 2}));
    for (const double z : kBoards) wood.append(board({-0.58, -0.29, z - 0.025}, {0.58, -0.012, z}));
    wood.append(board({-0.62, -0.31, 1.97}, {0.62, -0.001, 2.02}));
    wood.append(board({-0.59, -0.015, 0.02}, {0.59, -0.002, 1.98}));
    return wood;
}

Mesh books(int kind) {
    Mesh books;
    SceneRandom random(11);
    int count = 0;
    for (const double z : kBoards) {
        const double end = random.between(0.1, 0.5);
        for (double x = -0.555; x < end; ++count) {
            const double thick = random.between(0.018, 0.05);
            const double tall = random.between(0.19, 0.31);
            const double deep = random.between(0.14, 0.21);
            if (count % 3 == kind)
                books.append(board({x, -0.02 - deep, z + 0.001}, {x + thick, -0.03, z + tall}));
            x += thick + 0.002;
        }
    }
    return books;
}

Mesh lamp_stem() {
    Profile profile = {{0, 0.002}, {0.15, 0.002}, {0.15, 0.015}};
    append_bezier(profile, {{{0.1, 0.03}, {0.012, 0.03}, {0.012, 0.08}}}, 12);
    profile.push_back({0.012, 1.34});
    profile.push_back({0.02, 1.36});
    profile.push_back({0, 1.4});
    return revolve(profile, 64);
}

Mesh lamp_shade() {
    return revolve({{0.22, 1.2}, {0.14, 1.52}, {0.137, 1.52}, {0.217, 1.2}, {0.22, 1.2}}, 96);
}

Mesh pot() {
    Profile profile = {{0, 0.002}, {0.12, 0.002}};
    append_bezier(profile, {{{0.17, 0.1}, {0.18, 0.2}, {0.17, 0.3}}}, 12);
    profile.push_back({0.155, 0.3});
    profile.push_back({0.15, 0.26});
    profile.push_back({0, 0.27});
    return revolve(profile, 72);
}

Mesh leaves() {
    Mesh leaves;
    SceneRandom random(5);
    for (int i = 0; i < 30; ++i) {
        const double length = random.between(0.35, 0.6);
        const double rise = random.between(0.5, 1.25);
        const double turn = 0.382 * i + random.between(-0.03, 0.03);
        // A stalk that rises and bends over; the blade is the outer half of it.
        const auto blade = [&](double around, double along) {
            const SinCos t = sin_cos_2pi(around);
            const SinCos swell = sin_cos_2pi(along / 2);
            const double reach = length * (0.04 + along * (0.5 + 0.5 * along));
            const double wide = 0.004 + 0.06 * swell.sin * along;
            const double up = 0.27 + rise * along * (1.35 - 0.75 * along);
            return Vec3d(reach, -wide * t.sin * swell.sin, up + 0.004 * t.cos * swell.sin);
        };
        leaves.append(placed(ball_grid(12, 24, blade), turned(turn, Vec3d(0))));
    }
    return leaves;
}

Mesh bowl() {
    Profile profile = {{0, 0.001}, {0.06, 0.001}};
    append_bezier(profile, {{{0.13, 0.02}, {0.17, 0.06}, {0.17, 0.1}}}, 16);
    profile.push_back({0.162, 0.1});
    append_bezier(profile, {{{0.16, 0.06}, {0.12, 0.025}, {0, 0.012}}}, 16);
    return revolve(profile, 96);
}

Mesh fruit() {
    Mesh fruit;
    const std::array<Vec3d, 4> middles = {{{0.062, 0.02, 0.058},
                                           {-0.05, 0.045, 0.056},
                                           {-0.01, -0.066, 0.056},
                                           {0.002, 0.004, 0.118}}};
    for (const Vec3d& middle : middles)
        fruit.append(placed(superellipsoid({0.04, 0.04, 0.037}, 0.95F, 40, 24), at(middle)));
    return fruit;
}

Mesh folded_curtain(double width, double height) {
    constexpr int kSteps = 160;
    const double folds = width / 0.11;
    Polygon outline;
    const auto add = [&](int i, double thick) {
        const double x = static_cast<double>(i) / kSteps;
        outline.emplace_back(width * x, 0.035 * sin_cos_2pi(folds * x + 0.03).sin + thick, 0);
    };
    for (int i = 0; i <= kSteps; ++i) add(i, 0);
    for (int i = kSteps; i >= 0; --i) add(i, 0.006);
    return extrude(outline, {}, 0.015, height);
}

Mesh net_curtain(double width, double height) {
    constexpr std::uint32_t kColumns = 240;
    constexpr std::uint32_t kRows = 16;
    Mesh net;
    for (std::uint32_t i = 0; i <= kColumns; ++i)
        for (std::uint32_t j = 0; j <= kRows; ++j) {
            const double x = static_cast<double>(i) / kColumns;
            const double z = static_cast<double>(j) / kRows;
            const double depth = 0.018 * (1.3 - 0.5 * z);
            const double fold =
                sin_cos_2pi(width / 0.13 * x).sin + 0.4 * sin_cos_2pi(5.3 * x + 0.2 * z).sin;
            net.points.push_back(
                rounded_point({width * x, depth * fold, 0.02 + (height - 0.02) * z}));
            const std::uint32_t at = i * (kRows + 1) + j;
            if (i < kColumns && j < kRows) net.add_quad(at, at + kRows + 1, at + kRows + 2, at + 1);
        }
    return net;
}

}  // namespace sunfleck::engine

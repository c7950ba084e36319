// Examples of every shape, each under a matrix; the laws of shapes hold for all of them.
#pragma once

#include "geometry/support.h"

#include <ostream>
#include <string>
#include <vector>

namespace sunfleck::test {

struct ShapeExample {
    std::string name;
    Shape shape;
    Matrix to_world;

    friend std::ostream& operator<<(std::ostream& out, const ShapeExample& e) {
        return out << e.name;
    }
};

/// At least one of each alternative of Shape (a test counts them).
inline std::vector<ShapeExample> shape_examples() {
    const Matrix turned = rotation({1, 2, 3}, 0.9) * translation({0.5, -0.25, 2});
    const Matrix stretched = scaling(1.5, -0.7, 0.4) * turned;
    TriangleMesh square;
    square.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    TriangleMesh smooth = square;
    smooth.uvs = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    smooth.normals = {{-0.2F, -0.2F, 1}, {0.2F, -0.2F, 1}, {0.2F, 0.2F, 1}, {-0.2F, 0.2F, 1}};
    return {{"square", square, turned},
            {"smooth_square", smooth, stretched},
            {"ball_of_triangles", bumpy_ball(10, 0.05, true), stretched},
            {"sphere", Sphere{}, turned},
            {"ellipsoid", Sphere{0.8, -0.8, 0.8, 7}, stretched},
            {"part_of_a_sphere", Sphere{1.2, -0.4, 0.9, 4}, turned},
            {"disk", Disk{}, turned},
            {"sector_of_a_ring", Disk{0.3, 1.4, 0.5, 5}, stretched}};
}

}  // namespace sunfleck::test

// Examples of every shape, each under a matrix; the laws of shapes hold for all of them.
#pragma once

#include "geometry/support.h"

#include <ostream>
#include <string>
#include <vector>

namespace sunfleck::engine::test {

struct ShapeExample {
    std::string name;
    Shape shape;
    Matrix to_world;

    friend std::ostream& operator<<(std::ostream& out, const ShapeExample& e) {
        return out << e.name;
    }
};

/// Two that share a side, far from flat.
inline BilinearMesh twisted_patches() {
    BilinearMesh mesh;
    mesh.positions = {{-1, -1, 0.4F},  {1, -0.8F, -0.5F}, {-0.9F, 0.3F, -0.4F},
                      {1, 0.2F, 0.6F}, {-1, 1.2F, 0.5F},  {0.8F, 1, -0.2F}};
    mesh.patches = {{0, 1, 2, 3}, {2, 3, 4, 5}};
    return mesh;
}

/// With normals that decide the side, and coordinates that turn it.
inline BilinearMesh smooth_patches() {
    BilinearMesh mesh = twisted_patches();
    mesh.normals = {{0.1F, 0, -1}, {-0.3F, 0, -1}, {0, 0.2F, -1},
                    {0.2F, 0, -1}, {0, 0, -1},     {0, -0.3F, -1}};
    mesh.uvs = {{0, 0}, {0, 1.2F}, {1, 0.1F}, {1.1F, 1.3F}, {2, 0}, {2, 1}};
    return mesh;
}

inline Curves bent_curve(CurveKind kind) {
    Curves curves;
    curves.kind = kind;
    curves.segments = {
        {{Vec3(-1.2F, 0, -0.3F), Vec3(-0.5F, 1, 0), Vec3(0, 0.5F, 0.5F), Vec3(0.2F, 0, 0.2F)},
         {0.5F, 0.6F},
         {Vec3(0, 0.2F, 1), Vec3(0.3F, 0, 1)}},
        {{Vec3(0.2F, 0, 0.2F), Vec3(0.4F, -0.5F, -0.1F), Vec3(0.7F, -0.6F, 0),
          Vec3(1.3F, -0.3F, 0)},
         {0.6F, 0.4F},
         {Vec3(0.3F, 0, 1), Vec3(0, -0.2F, 0.9F)}}};
    return curves;
}

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
            {"sector_of_a_ring", Disk{0.3, 1.4, 0.5, 5}, stretched},
            {"cylinder", Cylinder{0.8, -0.9, 0.7, 7}, turned},
            {"sector_of_a_cylinder", Cylinder{1.1, -0.6, 0.9, 4}, stretched},
            {"patches", twisted_patches(), turned},
            {"smooth_patches", smooth_patches(), stretched},
            {"tube", bent_curve(CurveKind::cylinder), turned},
            {"stretched_tube", bent_curve(CurveKind::cylinder), stretched},
            {"ribbon", bent_curve(CurveKind::ribbon), turned}};
}

}  // namespace sunfleck::engine::test

// Polygons with holes: their area, no corner but theirs, each edge once.

#include "procedural/flat_fill.h"

#include "mesh_checks.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

Polygon square(double x, double y, double half, double z = 2) {
    return {{x - half, y - half, z},
            {x + half, y - half, z},
            {x + half, y + half, z},
            {x - half, y + half, z}};
}

/// Area as seen from above, where all triangles face.
double area(const Mesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const Vec3d vector = area_vector(mesh, t);
        EXPECT_GT(vector.z, 0);
        sum += vector.z;
    }
    return sum;
}

/// Each edge of the polygons is open in its direction, and no other is.
void expect_boundary(const Mesh& mesh, std::size_t corners) {
    EXPECT_EQ(open_edges(mesh).size(), corners);
}

TEST(FlatFill, of_a_square) {
    Mesh mesh;
    fill(mesh, square(0, 0, 1), {});
    EXPECT_EQ(mesh.triangles.size(), 2);
    EXPECT_DOUBLE_EQ(area(mesh), 4);
    expect_boundary(mesh, 4);
}

TEST(FlatFill, of_a_polygon_that_is_not_convex) {
    Mesh mesh;
    fill(mesh, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 1, 0}, {1, 1, 0}, {0, 4, 0}}, {});
    EXPECT_DOUBLE_EQ(area(mesh), 4 + 1.5 + 1.5);
    expect_boundary(mesh, 6);
}

TEST(FlatFill, of_a_square_with_holes_in_a_row) {
    Mesh mesh;
    fill(mesh, square(0, 0, 4),
         {square(-2.5, 0, 0.5), square(0, 0, 0.5), square(2.5, 0, 0.5), square(0, 2, 1)});
    EXPECT_DOUBLE_EQ(area(mesh), 64 - 3 - 4);
    expect_boundary(mesh, 20);
    for (const auto& p : mesh.points) EXPECT_EQ(p[2], 2);
}

/// The nearest corners of the last hole and the edge have another hole between them.
TEST(FlatFill, bridges_go_around_other_holes) {
    Mesh mesh;
    const Polygon bar = {{-3, 2, 0}, {3, 2, 0}, {3, 2.5, 0}, {-3, 2.5, 0}};
    const Polygon edge = {{-9, -9, 0}, {9, -9, 0}, {9, 3, 0}, {0, 3, 0}, {-9, 3, 0}};
    fill(mesh, edge, {square(0, 1, 0.5, 0), bar});
    EXPECT_DOUBLE_EQ(area(mesh), 18 * 12 - 1 - 3);
    expect_boundary(mesh, 13);
}

}  // namespace
}  // namespace sunfleck::engine

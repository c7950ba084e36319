// Vertices far from the origin: what is kept of them, and the warning where the file has too few
// digits.
#include "import/pbrt/local_points.h"

#include "import/pbrt/scene_text.h"

#include <iomanip>

namespace sunfleck::engine {
namespace {

const Vec3d kMapPlace(500000, 4500000, 300);

/// A strip of triangles around a place, whose edges are some `size` long.
/// @param written  what the file has in place of a coordinate.
template <class Written>
std::vector<Vec3d> strip(const Vec3d& place, double size, const Written& written) {
    std::vector<Vec3d> points;
    for (int i = 0; i < 40; ++i) {
        const Vec3d p = place + Vec3d(0.37 * i, i % 2 + 0.1 * i, 0.01 * i) * size;
        points.emplace_back(written(p.x), written(p.y), written(p.z));
    }
    return points;
}

double as_float(double x) {
    return static_cast<float>(x);
}
double as_double(double x) {
    return x;
}

std::string list_of(const std::vector<Vec3d>& points) {
    std::ostringstream text;
    text << std::setprecision(17);
    for (const Vec3d& p : points) text << p.x << ' ' << p.y << ' ' << p.z << '\n';
    return text.str();
}

std::string indices(const std::string& before) {
    std::string text;
    for (int i = 0; i + 2 < 40; ++i)
        text += before + std::to_string(i) + ' ' + std::to_string(i + 1) + ' ' +
                std::to_string(i + 2) + '\n';
    return text;
}

std::string mesh_of(const std::vector<Vec3d>& points) {
    return "Shape \"trianglemesh\" \"integer indices\" [" + indices("") + "] \"point3 P\" [" +
           list_of(points) + "]\n";
}

std::string ply_of(const std::string& type, const std::vector<Vec3d>& points) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex 40\n";
    for (const char* name : {"x", "y", "z"}) text += "property " + type + " " + name + "\n";
    return text + "element face 38\nproperty list uchar int vertex_indices\nend_header\n" +
           list_of(points) + indices("3 ");
}

int coarse(const std::string& world, const MemoryFiles& files = {}) {
    return warnings_with(read_world(world, files), "float numbers have steps of 0.5");
}

TEST(LocalPoints, vertices_that_a_file_rounded_to_coarse_floats_are_told) {
    EXPECT_EQ(coarse(mesh_of(strip(kMapPlace, 1, as_float))), 1);
    const std::string shape = "Shape \"plymesh\" \"string filename\" \"m.ply\"";
    EXPECT_EQ(coarse(shape, {{"m.ply", ply_of("float", strip(kMapPlace, 1, as_float))}}), 1);
    EXPECT_EQ(coarse(shape, {{"m.ply", ply_of("double", strip(kMapPlace, 1, as_float))}}), 1);
    EXPECT_EQ(coarse(shape, {{"m.ply", ply_of("double", strip(kMapPlace, 1, as_double))}}), 0);
}

TEST(LocalPoints, no_word_where_digits_suffice) {
    EXPECT_EQ(coarse(mesh_of(strip(kMapPlace, 1, as_double))), 0) << "doubles";
    EXPECT_EQ(coarse(mesh_of(strip(kMapPlace, 50, as_float))), 0) << "long edges";
    EXPECT_EQ(coarse("Translate 500000 4500000 300\n" + mesh_of(strip(Vec3d(0), 1, as_float))), 0);
    const auto whole = [](double x) { return std::round(x); };
    EXPECT_EQ(coarse(mesh_of(strip(kMapPlace, 1, whole))), 0) << "whole metres";
}

TEST(LocalPoints, detail_far_from_the_origin_is_kept_as_well_as_near_it) {
    const std::vector<std::uint32_t> used = {0, 1, 2, 39};
    const std::vector<Vec3d> points = strip(kMapPlace, 1, as_double);
    const LocalPoints local = local_points(points, used);
    EXPECT_NE(local.origin, Vec3d(0));
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_LT((Vec3d(local.points[i]) + local.origin - points[i]).length(), 4e-6);
}

}  // namespace
}  // namespace sunfleck::engine

// The files that scenes name: pictures, a mesh and a spectrum, made by rule.
#include "differential/make_scene.h"
#include "image/exr.h"
#include "sunfleck/error.h"

#include <cmath>
#include <filesystem>
#include <fstream>

namespace sunfleck::engine::differential {
namespace {

constexpr const char* kOctahedron = R"(ply
format ascii 1.0
element vertex 6
property float x
property float y
property float z
element face 8
property list uchar int vertex_indices
end_header
0.7 0 0
-0.7 0 0
0 0.7 0
0 -0.7 0
0 0 0.7
0 0 -0.7
3 0 2 4
3 2 1 4
3 1 3 4
3 3 0 4
3 2 0 5
3 1 2 5
3 3 1 5
3 0 3 5
)";

constexpr const char* kGreen = "360 0.1\n480 0.2\n540 0.7\n600 0.3\n830 0.2\n";

void write_text(const std::string& path, const char* text) {
    if (!(std::ofstream(path, std::ios::binary) << text))
        throw Error({path}, "cannot write it", "name a folder that can be written with --out");
}

/// @param colour  of a place in the unit square, channel 0 to 2.
template <class Colour>
Picture picture_of(int width, int height, const Colour& colour) {
    Picture picture{width, height, {}, {}};
    for (int c = 0; c < 3; ++c) {
        Channel& channel = picture.add(std::string(1, "RGB"[c]));
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                channel.values[static_cast<std::size_t>(y * width + x)] =
                    static_cast<float>(colour((x + 0.5) / width, (y + 0.5) / height, c));
    }
    return picture;
}

}  // namespace

void write_files(const std::string& folder) {
    const std::string files = folder + "/files/";
    std::filesystem::create_directories(files);
    const auto smooth = [](double x, double y, int c) {
        return 0.55 + 0.4 * std::sin(7 * x + c) * std::cos(5 * y - c);
    };
    const auto sky = [&](double x, double y, int c) {
        const double far = std::hypot(x - 0.6, y - 0.45);
        return smooth(x, y, c) / 2 + (far < 0.15 ? 6.0 : 0.0);
    };
    const auto normals = [](double x, double y, int c) {
        const double bend = c == 0 ? std::sin(12 * x) : std::sin(9 * y);
        return c == 2 ? 0.95 : 0.5 + 0.12 * bend;
    };
    write_exr(files + "picture.exr", picture_of(12, 8, smooth));
    write_exr(files + "map.exr", picture_of(16, 16, sky));
    write_exr(files + "normals.exr", picture_of(16, 16, normals));
    write_text(files + "octahedron.ply", kOctahedron);
    write_text(files + "green.spd", kGreen);
}

}  // namespace sunfleck::engine::differential

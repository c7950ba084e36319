// The shape of the object, about 1.2 wide, around the origin. Closed ones have their normals
// outside.
#include "differential/scene_parts.h"

namespace sunfleck::engine::differential {
namespace {

constexpr const char* kBox =
    R"(Shape "trianglemesh" "integer indices" [0 2 1 0 3 2  4 5 6 4 6 7  0 1 5 0 5 4
    3 6 2 3 7 6  0 7 3 0 4 7  1 2 6 1 6 5] "point3 P" [-0.5 -0.4 -0.6  0.5 -0.4 -0.6  0.5 0.4 -0.6
    -0.5 0.4 -0.6  -0.5 -0.4 0.6  0.5 -0.4 0.6  0.5 0.4 0.6  -0.5 0.4 0.6])";
constexpr const char* kCorners =  // of an octahedron
    "[0.7 0 0  -0.7 0 0  0 0.7 0  0 -0.7 0  0 0 0.7  0 0 -0.7]";
constexpr const char* kOutward = "[0 2 4 2 1 4 1 3 4 3 0 4 2 0 5 1 2 5 3 1 5 0 3 5]";
constexpr const char* kClockwise = "[2 0 4 1 2 4 3 1 4 0 3 4 0 2 5 2 1 5 1 3 5 3 0 5]";
constexpr const char* kNormals = "[1 0 0  -1 0 0  0 1 0  0 -1 0  0 0 1  0 0 -1]";

}  // namespace

Statement shape_statement(Ingredients& scene) {
    const std::string_view kind = scene["shape"];
    if (kind == "sphere")
        return {R"(Shape "sphere")", {R"("float radius" )" + scene.number(0.4, 0.7)}};
    if (kind == "cut sphere")
        return {R"(Shape "sphere" "float radius" 0.6)",
                {R"("float zmin" -0.4)", R"("float zmax" 0.5)",
                 R"("float phimax" )" + scene.number(180, 340)}};
    if (kind == "disk")
        return {"Rotate 40 1 0.3 0\n  Shape \"disk\" \"float radius\" 0.7",
                {R"("float innerradius" 0.2)", R"("float phimax" )" + scene.number(200, 360)}};
    if (kind == "cylinder")
        return {R"(Shape "cylinder" "float radius" 0.4 "float zmin" -0.6 "float zmax" 0.6)",
                {R"("float phimax" )" + scene.number(200, 360)}};
    if (kind == "box") return {kBox, {}};
    if (kind == "shaded mesh")
        return {fmt::format(R"(Shape "trianglemesh" "integer indices" {} "point3 P" {})", kOutward,
                            kCorners),
                {fmt::format(R"("normal N" {})", kNormals)}};
    if (kind == "ply") return {R"(Shape "plymesh" "string filename" "files/octahedron.ply")", {}};
    if (kind == "bilinear")
        return {R"(Shape "bilinearmesh" "integer indices" [0 1 2 3] "point3 P" [-0.6 -0.4 -0.5
    0.6 -0.3 -0.3  -0.5 0.4 0.3  0.6 0.4 0.6])",
                {R"("point2 uv" [0 0  1 0  0 1  1 1])"}};
    if (kind == "loopsubdiv")
        return {fmt::format(R"(Shape "loopsubdiv" "integer indices" {} "point3 P" {})", kClockwise,
                            kCorners),
                {R"("integer levels" 2)"}};
    const std::string curve =
        R"(Shape "curve" "point3 P" [-0.6 0 -0.5  -0.3 0.3 0.6  0.3 -0.3 0.8  0.6 0 -0.4])";
    if (kind == "curve")
        return {curve + R"( "string type" "cylinder")",
                {R"("float width0" 0.2)", R"("float width1" )" + scene.number(0.1, 0.3)}};
    return {curve + R"( "string type" "ribbon" "normal N" [0 -1 0.2  0.2 -1 0])",
            {R"("float width" )" + scene.number(0.2, 0.5)}};
}

}  // namespace sunfleck::engine::differential

// The Cornell box: published geometry and spectra, 36 triangles with the light and closed boxes.
//
// Source of the numbers: "Cornell Box Data", Cornell University Program of Computer Graphics
// (1998).

#include "procedural/cornell.h"

#include <string_view>

namespace sunfleck::engine {
namespace {

constexpr std::string_view kHead = R"(# Sunfleck, scene cornell: the Cornell box.
# Made by "sunfleck scene cornell". Dedicated to the public domain (CC0 1.0).
# Dimensions (millimetres, y up), reflectances, and the light's spectrum are those that the Cornell
# University Program of Computer Graphics published. The light hangs 0.5 mm below the ceiling; the
# boxes have bottoms, which makes 36 triangles. The first line makes the picture right-handed.
Scale -1 1 1
LookAt 278 273 -800  278 273 0  0 1 0
Camera "perspective" "float fov" 39.3077
Film "rgb" "string filename" "cornell.exr" "integer xresolution" 256 "integer yresolution" 256
PixelFilter "box"
Sampler "halton" "integer pixelsamples" 256
Integrator "sppm" "integer maxdepth" 16

WorldBegin

# Wavelength in nm, reflectance.
)";

constexpr std::string_view kMaterials = R"(MakeNamedMaterial "white" "string type" "diffuse"
    "spectrum reflectance" [
    400 0.343 404 0.445 408 0.551 412 0.624 416 0.665 420 0.687 424 0.708 428 0.723 432 0.715
    436 0.71 440 0.745 444 0.758 448 0.739 452 0.767 456 0.777 460 0.765 464 0.751 468 0.745
    472 0.748 476 0.729 480 0.745 484 0.757 488 0.753 492 0.75 496 0.746 500 0.747 504 0.735
    508 0.732 512 0.739 516 0.734 520 0.725 524 0.721 528 0.733 532 0.725 536 0.732 540 0.743
    544 0.744 548 0.748 552 0.728 556 0.716 560 0.733 564 0.726 568 0.713 572 0.74 576 0.754
    580 0.764 584 0.752 588 0.736 592 0.734 596 0.741 600 0.74 604 0.732 608 0.745 612 0.755
    616 0.751 620 0.744 624 0.731 628 0.733 632 0.744 636 0.731 640 0.712 644 0.708 648 0.729
    652 0.73 656 0.727 660 0.707 664 0.703 668 0.729 672 0.75 676 0.76 680 0.751 684 0.739
    688 0.724 692 0.73 696 0.74 700 0.737 ]
MakeNamedMaterial "green" "string type" "diffuse"
    "spectrum reflectance" [
    400 0.092 404 0.096 408 0.098 412 0.097 416 0.098 420 0.095 424 0.095 428 0.097 432 0.095
    436 0.094 440 0.097 444 0.098 448 0.096 452 0.101 456 0.103 460 0.104 464 0.107 468 0.109
    472 0.112 476 0.115 480 0.125 484 0.14 488 0.16 492 0.187 496 0.229 500 0.285 504 0.343
    508 0.39 512 0.435 516 0.464 520 0.472 524 0.476 528 0.481 532 0.462 536 0.447 540 0.441
    544 0.426 548 0.406 552 0.373 556 0.347 560 0.337 564 0.314 568 0.285 572 0.277 576 0.266
    580 0.25 584 0.23 588 0.207 592 0.186 596 0.171 600 0.16 604 0.148 608 0.141 612 0.136
    616 0.13 620 0.126 624 0.123 628 0.121 632 0.122 636 0.119 640 0.114 644 0.115 648 0.117
    652 0.117 656 0.118 660 0.12 664 0.122 668 0.128 672 0.132 676 0.139 680 0.144 684 0.146
    688 0.15 692 0.152 696 0.157 700 0.159 ]
MakeNamedMaterial "red" "string type" "diffuse"
    "spectrum reflectance" [
    400 0.04 404 0.046 408 0.048 412 0.053 416 0.049 420 0.05 424 0.053 428 0.055 432 0.057
    436 0.056 440 0.059 444 0.057 448 0.061 452 0.061 456 0.06 460 0.062 464 0.062 468 0.062
    472 0.061 476 0.062 480 0.06 484 0.059 488 0.057 492 0.058 496 0.058 500 0.058 504 0.056
    508 0.055 512 0.056 516 0.059 520 0.057 524 0.055 528 0.059 532 0.059 536 0.058 540 0.059
    544 0.061 548 0.061 552 0.063 556 0.063 560 0.067 564 0.068 568 0.072 572 0.08 576 0.09
    580 0.099 584 0.124 588 0.154 592 0.192 596 0.255 600 0.287 604 0.349 608 0.402 612 0.443
    616 0.487 620 0.513 624 0.558 628 0.584 632 0.62 636 0.606 640 0.609 644 0.651 648 0.612
    652 0.61 656 0.65 660 0.638 664 0.627 668 0.62 672 0.63 676 0.628 680 0.642 684 0.639
    688 0.657 692 0.639 696 0.635 700 0.642 ]
)";

constexpr std::string_view kRoom = R"(
# The light; its normal points down. A spectrum is normalised to luminance one, then scaled to the
# luminance of the published values.
AttributeBegin
NamedMaterial "white"
AreaLightSource "diffuse" "spectrum L" [ 400 0  500 8  600 15.6  700 18.4 ] "float scale" 12.37
Shape "trianglemesh" "integer indices" [ 0 1 2  0 2 3 ]
    "point3 P" [ 343 548.3 227  343 548.3 332  213 548.3 332  213 548.3 227 ]
AttributeEnd

# Floor, ceiling and back wall; then the right and the left wall.
NamedMaterial "white"
Shape "trianglemesh" "integer indices" [ 0 1 2  0 2 3 ]
    "point3 P" [ 552.8 0 0  0 0 0  0 0 559.2  549.6 0 559.2 ]
Shape "trianglemesh" "integer indices" [ 0 1 2  0 2 3 ]
    "point3 P" [ 556 548.8 0  556 548.8 559.2  0 548.8 559.2  0 548.8 0 ]
Shape "trianglemesh" "integer indices" [ 0 1 2  0 2 3 ]
    "point3 P" [ 549.6 0 559.2  0 0 559.2  0 548.8 559.2  556 548.8 559.2 ]
NamedMaterial "green"
Shape "trianglemesh" "integer indices" [ 0 1 2  0 2 3 ]
    "point3 P" [ 0 0 559.2  0 0 0  0 548.8 0  0 548.8 559.2 ]
NamedMaterial "red"
Shape "trianglemesh" "integer indices" [ 0 1 2  0 2 3 ]
    "point3 P" [ 552.8 0 0  549.6 0 559.2  556 548.8 559.2  556 548.8 0 ]
)";

// Per box: four corners of the top, the same four of the bottom; top, bottom, four sides.
constexpr std::string_view kBoxes = R"(
# The short block, then the tall one.
NamedMaterial "white"
Shape "trianglemesh" "integer indices" [
        0 1 2  0 2 3   4 6 5  4 7 6
        4 5 1  4 1 0   5 6 2  5 2 1   6 7 3  6 3 2   7 4 0  7 0 3 ]
    "point3 P" [ 130 165 65  82 165 225  240 165 272  290 165 114
                 130   0 65  82   0 225  240   0 272  290   0 114 ]
Shape "trianglemesh" "integer indices" [
        0 1 2  0 2 3   4 6 5  4 7 6
        4 5 1  4 1 0   5 6 2  5 2 1   6 7 3  6 3 2   7 4 0  7 0 3 ]
    "point3 P" [ 423 330 247  265 330 296  314 330 456  472 330 406
                 423   0 247  265   0 296  314   0 456  472   0 406 ]
)";

}  // namespace

std::vector<SceneFile> cornell_scene() {
    std::string text(kHead);
    text += kMaterials;
    text += kRoom;
    text += kBoxes;
    return {{"cornell.pbrt", text}};
}

}  // namespace sunfleck::engine

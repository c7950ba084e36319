// What a Picture of the interface shares among its copies.
#pragma once

#include "image/picture.h"
#include "sunfleck/picture.h"

namespace sunfleck {

struct Picture::Data {
    engine::Picture picture;
    double exposure = 0;  // stops, where save() is told none
};

}  // namespace sunfleck

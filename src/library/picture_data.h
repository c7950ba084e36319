// What a Picture of the interface shares among its copies.
#pragma once

#include "image/picture_file.h"
#include "sunfleck/picture.h"

namespace sunfleck {

struct Picture::Data {
    engine::Picture picture;
    engine::PictureFileOptions files{};  // of save(); the exposure where it is told none
};

}  // namespace sunfleck

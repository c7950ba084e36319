// Looks of MTL materials: plastic, metal, glass, light, by their words.
#pragma once

#include "import/obj/mtl.h"
#include "import/part/look.h"
#include "import/part/pictures.h"

#include <string>

namespace sunfleck::engine {

/// A library of materials, and where it was found.
struct PartLibrary {
    std::string path;
    MtlLibrary materials;
};

/// Adds a material to a scene, with a warning for each part of it that is left out.
PartLook look_of(const MtlMaterial& material, const PartLibrary& library, PartPictures& pictures,
                 SceneDescription& scene);

}  // namespace sunfleck::engine

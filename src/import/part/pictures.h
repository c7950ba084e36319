// Pictures of MTL materials as textures: decoded once, with the options of their statements.
#pragma once

#include "import/obj/mtl.h"
#include "import/part/files.h"
#include "scene/description.h"
#include "texture/texture.h"

#include <map>
#include <memory>

namespace sunfleck::engine {

class PartPictures {
public:
    /// Both must outlive this.
    PartPictures(PartFiles& files, Warnings& warnings) : files_(files), warnings_(warnings) {}

    /// Returns the picture of a map times a colour, as a reflectance; nothing if it is missing.
    /// @param map  or null. @param library  path of the file that names it.
    std::optional<SpectrumTexture> colour(const MtlMap* map, const Vec3d& by,
                                          const std::string& library);
    /// Returns the picture as numbers: alpha or grey, or the channel that -imfchan names.
    std::optional<FloatTexture> number(const MtlMap* map, const std::string& library);
    /// Returns the picture as a normal map.
    BumpMap normals(const MtlMap* map, const std::string& library);
    /// Returns the picture if it is one of normals, for those that stand where heights should.
    BumpMap normals_in_place_of_heights(const MtlMap* map, const std::string& library);
    /// Returns the picture times a colour, for light.
    std::shared_ptr<const Image> light(const MtlMap* map, const Vec3d& by,
                                       const std::string& library);

private:
    std::shared_ptr<const Image> read(const MtlMap& map, const std::string& library,
                                      Encoding::Kind encoding);

    PartFiles& files_;
    Warnings& warnings_;
    std::map<std::string, std::shared_ptr<const Image>> images_;  // by path, as stored
};

}  // namespace sunfleck::engine

// PictureFiles: the pictures of a scene as files beside it, without loss.
//
// 8 bits become PNG, halves and floats OpenEXR. Each picture is written once.
#pragma once

#include "export/exported_scene.h"
#include "image/image.h"
#include "image/lookup.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace sunfleck::engine {

class PictureFiles {
public:
    /// @param folder  of the files, relative to that of the scene, without the last '/'.
    /// @param files  receives them; must outlive this.
    PictureFiles(std::string folder, std::vector<ExportedFile>& files)
        : folder_(std::move(folder)), files_(files) {}

    struct Entry {
        std::string name;      // of the file
        std::string encoding;  // of its values, as pbrt-v4 says it; empty for sRGB or floats
    };

    /// Returns the file of a picture. @param image  not null, not empty.
    const Entry& texture(const std::shared_ptr<const Image>& image);
    /// Returns the file of a picture that is read as linear whatever its name.
    const std::string& linear(const std::shared_ptr<const Image>& image);
    /// Adds a picture of floats with R, G, B, or Y where it has one channel. @return its file.
    std::string add_light(std::string_view what, std::shared_ptr<const Image> image);
    /// Returns the file of the picture with all edges mirrored, `across` or `down` the picture.
    const Entry& mirrored(const std::shared_ptr<const Image>& image, bool across, bool down);

private:
    std::string next_name(std::string_view what, std::string_view ending);
    Entry add(const std::shared_ptr<const Image>& image);

    std::string folder_;
    std::vector<ExportedFile>& files_;
    std::map<std::string, int, std::less<>> counts_;
    std::map<std::shared_ptr<const Image>, Entry> known_;
    std::map<std::shared_ptr<const Image>, std::string> linear_;
    std::map<std::pair<std::shared_ptr<const Image>, int>, Entry> mirrored_;
};

/// Returns a picture of floats with RGB, each texel multiplied by a colour.
std::shared_ptr<const Image> rgb_floats(const Image& image, const Vec3& by = Vec3(1));

}  // namespace sunfleck::engine

// ImageTable: the image files that a scene names, each stored once and all decoded in parallel at
// the end.
#pragma once

#include "image/image.h"
#include "import/pbrt/import_log.h"
#include "import/pbrt/scene_files.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Warns of what the image loses: primaries other than sRGB's, channels that were selected or left
/// out, texels that are not finite.
void warn_of_image(const Image& image, const std::string& path, const SourceLocation& from,
                   ImportLog& log);

class ImageTable {
public:
    /// Both must outlive this.
    ImageTable(SceneFiles& files, ImportLog& log) : files_(files), log_(log) {}

    /// Makes a copy that reads by another list of files.
    ImageTable(const ImageTable& other, SceneFiles& files, ImportLog& log)
        : files_(files),
          log_(log),
          numbers_(other.numbers_),
          slots_(other.slots_),
          loaded_(other.loaded_) {}

    /// Returns the image of a file, empty until load(). @param encoding  of a PNG.
    std::shared_ptr<const Image> enter(const std::string& name, const Encoding& encoding,
                                       const SourceLocation& from);

    /// Decodes all files that are not decoded yet, with their warnings. Missing files are noted.
    /// @throws Error  of the first file that cannot be read.
    void load();

private:
    struct Slot {
        std::string name;
        Encoding encoding;
        SourceLocation from;
        std::shared_ptr<Image> image;
    };

    struct Loaded {
        NamedFile file;
        std::optional<MissingFile> missing;
        std::optional<Error> fault;
    };

    void load(const Slot& slot, Loaded& loaded) const;

    SceneFiles& files_;
    ImportLog& log_;
    std::map<std::pair<std::string, Encoding>, std::size_t> numbers_;
    std::vector<Slot> slots_;
    std::size_t loaded_ = 0;  // index of the first image that is not decoded
};

}  // namespace sunfleck::engine

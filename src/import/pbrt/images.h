// Image files that a scene names: each entered once, all read side by side when the scene has
// ended.
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

/// Warns of what the picture's file has and the image has not: other primaries than sRGB's,
/// channels that were chosen or left out, texels that are no finite numbers.
void warn_of_image(const Image& image, const std::string& path, const SourceLocation& from,
                   ImportLog& log);

class ImageTable {
public:
    /// Both must outlive this.
    ImageTable(SceneFiles& files, ImportLog& log) : files_(files), log_(log) {}

    /// The image of a file, empty until load(). @param encoding  of a PNG.
    std::shared_ptr<const Image> enter(const std::string& name, const Encoding& encoding,
                                       const SourceLocation& from);

    /// Reads all files that were not read before, and warns of what is in them. Missing ones are
    /// noted in the list of files. @throws Error, that of the first one which cannot be read.
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
    std::size_t loaded_ = 0;  // the first of them
};

}  // namespace sunfleck::engine

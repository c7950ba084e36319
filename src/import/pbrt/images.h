// Image files that a scene names: each entered once, all read side by side when the scene has
// ended.
#pragma once

#include "core/error.h"
#include "image/image.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace sunfleck {

struct Reading;

/// Warns if the image's colours are not those of sRGB, as which they are taken.
void warn_of_primaries(const Image& image, const std::string& name, const SourceLocation& from,
                       Reading& reading);

class ImageTable {
public:
    /// The image of a file, empty until load(). @param encoding  of a PNG.
    std::shared_ptr<const Image> enter(const std::string& name, const Encoding& encoding,
                                       const SourceLocation& from, Reading& reading);

    /// Reads all files that were not read before; warns of colours that are taken for those of sRGB
    /// and are not. @throws Error, that of the first one which cannot
    /// be read.
    void load(Reading& reading);

private:
    struct Slot {
        std::string path;
        Encoding encoding;
        SourceLocation from;
        std::shared_ptr<Image> image;
    };

    std::map<std::pair<std::string, Encoding>, std::size_t> numbers_;
    std::vector<Slot> slots_;
    std::size_t loaded_ = 0;  // the first of them
};

}  // namespace sunfleck

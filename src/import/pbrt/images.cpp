// The table of images.
#include "import/pbrt/images.h"

#include "core/parallel.h"
#include "image/read_image.h"
#include "import/pbrt/reading.h"

#include <optional>
#include <utility>

namespace sunfleck {

void warn_of_primaries(const Image& image, const std::string& name, const SourceLocation& from,
                       Reading& reading) {
    if (!image.has_other_primaries()) return;
    reading.warn(from, "the colours of " + name +
                           " are of other primaries than sRGB's (chromaticities): they are taken "
                           "for sRGB's");
}

std::shared_ptr<const Image> ImageTable::enter(const std::string& name, const Encoding& encoding,
                                               const SourceLocation& from, Reading& reading) {
    const std::string path = resolved(name, reading.folder);
    const auto [place, is_new] = numbers_.try_emplace({path, encoding}, slots_.size());
    if (is_new) {
        reading.count_file(path, from);
        slots_.push_back({path, encoding, from, std::make_shared<Image>()});
    }
    return slots_[place->second].image;
}

void ImageTable::load(Reading& reading) {
    const std::size_t first = std::exchange(loaded_, slots_.size());
    std::vector<std::optional<Error>> faults(slots_.size() - first);
    parallel_for(faults.size(), [&](std::size_t i) {
        const Slot& slot = slots_[first + i];
        try {
            *slot.image =
                parse_image(reading.files(slot.path, slot.from), slot.path, slot.encoding);
        } catch (const Error& fault) {
            faults[i] = fault;
        }
    });
    for (const std::optional<Error>& fault : faults)
        if (fault) throw Error(*fault);
    for (std::size_t i = first; i < slots_.size(); ++i)
        warn_of_primaries(*slots_[i].image, slots_[i].path, slots_[i].from, reading);
}

}  // namespace sunfleck
